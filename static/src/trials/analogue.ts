// One moving figure, sliders without steps; no answer until touched.

import { html } from "lit";
import { t, tn } from "../words";
import { draw, empty, open, set, type Asked, type Form, type Kind } from "./kind";
import type { Scale } from "./semantic_differential";
import { HIGHEST, LOWEST, slider } from "./slider";

/** What a study sets. */
export interface Parameters {
  scales: readonly Scale[];
}

const left = ({ task }: Asked<Parameters>, form: Form) => open(task.scales.map(({ id }) => id), form).length;

export const analogue: Kind<Parameters> = {
  layout: "stage",
  data: {
    answers: "scale id to position, 0 at the left end … 100 at the right end",
    "record.start": "scale id to the position that the slider showed before it was touched, where it showed one",
  },
  blank: empty,
  isComplete: (asked, form) => left(asked, form) === 0,
  remaining(asked, form) {
    const number = left(asked, form);
    return number ? tn("{n} slider to go", "{n} sliders to go", number) : null;
  },
  simulate: ({ task }, random) =>
    task.scales.reduce((form, { id }) => set(form, id, draw(LOWEST, HIGHEST, random)), empty()),
  panel: ({ task, form, change }) => html`<div class="sliders">${task.scales.map(({ id, left, right }) => {
    const value = form.answers[id] as number | undefined;
    return slider({ id, left, right, name: t("{left} or {right}", { left, right }), value }, (position) => change((now) => set(now, id, position)));
  })}</div>`,
};
