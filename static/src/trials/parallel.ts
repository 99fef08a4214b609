// Several moving figures in step on one page, a slider below each.

import { t, tn } from "../words";
import { draw, empty, NOTHING, open, set, type Asked, type Form, type Kind } from "./kind";
import { HIGHEST, LOWEST, slider } from "./slider";

/** What a study sets. */
export interface Parameters {
  low: string;
  high: string;
}

const places = ({ step }: Asked<unknown>) => step.figures.map((_, place) => String(place));
const left = (asked: Asked<unknown>, form: Form) => open(places(asked), form).length;

export const parallel: Kind<Parameters> = {
  layout: "cells",
  data: {
    answers: "each figure, counted from 0 as they stand on the page, to its position, 0 … 100",
    "record.start": "each figure to the position that its slider showed before it was touched, where it showed one",
  },
  blank: empty,
  isComplete: (asked, form) => left(asked, form) === 0,
  remaining(asked, form) {
    const number = left(asked, form);
    return number ? tn("{n} figure to go", "{n} figures to go", number) : null;
  },
  simulate: (asked, random) =>
    places(asked).reduce((form, id) => set(form, id, draw(LOWEST, HIGHEST, random)), empty()),
  panel: () => NOTHING,
  cell({ task, form, change }, place) {
    const id = String(place);
    const head = String(place + 1);
    const value = form.answers[id] as number | undefined;
    const named = { id, name: t("Figure {name}", { name: head }), left: task.low, right: task.high, value };
    return { head, foot: slider(named, (position) => change((now) => set(now, id, position))) };
  },
};
