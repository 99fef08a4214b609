// One moving figure and several lines of the same steps: qualities to rate, or statements to agree with.

import { html } from "lit";
import { tn } from "../words";
import { draw, empty, open, set, type Asked, type Form, type Kind } from "./kind";
import { answeredOf, stepLines, type Line, type Steps } from "./steps";

export interface Item {
  id: string;
  label: string;
}

/** What a study sets. */
export interface Parameters {
  items: readonly Item[];
  /** Words for the steps from the lowest to the highest. */
  steps: readonly string[];
}

/** A kind whose lowest step is called `first`. */
export function ofItems(first: number, tone: Steps["tone"], unit: string): Kind<Parameters> {
  const left = ({ task }: Asked<Parameters>, form: Form) => open(task.items.map(({ id }) => id), form).length;
  return {
    layout: "stage",
    data: { answers: unit },
    blank: empty,
    isComplete: (asked, form) => left(asked, form) === 0,
    remaining(asked, form) {
      const number = left(asked, form);
      return number ? tn("{n} line to go", "{n} lines to go", number) : null;
    },
    simulate({ task }, random) {
      const last = first + task.steps.length - 1;
      return task.items.reduce((form, { id }) => set(form, id, draw(first, last, random)), empty());
    },
    panel({ task, form, change }) {
      const words = task.steps;
      const [low = "", high = ""] = [words[0], words.at(-1)];
      const lines = task.items.map(({ id, label }): Line => ({ id, label, name: label, left: low, right: high }));
      const values = words.map((_, place) => first + place);
      const nameOf = (place: number) => words[place] ?? "";
      return html`${answeredOf(lines, form)} ${stepLines({ lines, words, values, nameOf, tone }, form, change)}`;
    },
  };
}
