// One moving figure between opposite words, perhaps beside a reference figure.

import { html } from "lit";
import { t, tn } from "../words";
import { draw, empty, open, set, type Asked, type Form, type Kind } from "./kind";
import { answeredOf, stepLines, type Line } from "./steps";

export interface Scale {
  id: string;
  left: string;
  right: string;
}

/** What a study sets. */
export interface Parameters {
  scales: readonly Scale[];
  /** Words for the steps from the left end to the right end, an odd number of them. */
  steps: readonly string[];
  /** The middle holds until a scale is touched; else every scale must be answered. */
  preselected: boolean;
}

/** Steps as numbers around 0. */
export function values(steps: readonly string[]): number[] {
  const middle = (steps.length - 1) / 2;
  return steps.map((_, index) => index - middle);
}

/** What a screen reader says for a step: “rather sad”, “neither”. */
export function nameOf(value: number, { left, right }: Pick<Scale, "left" | "right">, steps: readonly string[]): string {
  const word = steps[value + (steps.length - 1) / 2] ?? "";
  if (value === 0) return word;
  return `${word} ${value < 0 ? left : right}`;
}

/** The scales as this participant sees them. */
export function shown({ task, step }: Asked<Parameters>): Line[] {
  const known = new Map(task.scales.map((scale) => [scale.id, scale]));
  const scales = step.scales?.flatMap((id) => known.get(id) ?? []) ?? task.scales;
  return scales.map(({ id, left, right }) => ({ id, left, right, name: t("{left} or {right}", { left, right }) }));
}

function blank({ task }: Asked<Parameters>): Form {
  if (!task.preselected) return empty();
  return { ...empty(), answers: Object.fromEntries(task.scales.map(({ id }) => [id, 0])) };
}

const left = ({ task }: Asked<Parameters>, form: Form) => open(task.scales.map(({ id }) => id), form).length;

export const semanticDifferential: Kind<Parameters> = {
  layout: "stage",
  data: {
    answers: "scale id to steps from the middle, negative to the left",
    touched: "ids of the scales whose step was chosen, rather than left as preselected",
  },
  blank,
  isComplete: (asked, form) => left(asked, form) === 0,
  remaining(asked, form) {
    const number = left(asked, form);
    return number ? tn("{n} pair to go", "{n} pairs to go", number) : null;
  },
  simulate(asked, random) {
    const reach = (asked.task.steps.length - 1) / 2;
    return asked.task.scales.reduce((form, { id }) => set(form, id, draw(-reach, reach, random)), blank(asked));
  },
  panel(view) {
    const { task, form, change } = view;
    const lines = shown(view);
    const steps = values(task.steps);
    const name = (place: number, line: Line) => nameOf(steps[place] ?? 0, line, task.steps);
    return html`${answeredOf(lines, form)}
      ${stepLines({ lines, words: task.steps, values: steps, nameOf: name, tone: "bipolar" }, form, change)}`;
  },
};
