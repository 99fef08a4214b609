// A target in green is made again in blue: guessed unseen, or matched against the clock with the blue figure on view.

import { html } from "lit";
import { keyed } from "lit/directives/keyed.js";
import { t } from "../words";
import { empty, type Asked, type Form, type Kind } from "./kind";
import { inSeconds, slidersOf, type Parameters } from "./matching/model";
import "./matching/task";

const isComplete = (_: Asked<Parameters>, { answers }: Form): boolean => answers["seconds"] !== undefined;

export const match: Kind<Parameters> = {
  layout: "stage",
  data: {
    answers: "slider to position, 0 at the left end … 1 at the right end; e0, e1, … are the examples' weights",
    "answers.seconds": "s from the first picture of both figures to the match, or to the end of the time; of a guess, to the last move. Neither a page that is closed counts nor a line that is down",
    "record.path": "moves of the sliders: ms by the same clock, slider, position; of one slider at most ten a second",
  },
  blank: empty,
  isComplete,
  remaining(asked, form) {
    if (isComplete(asked, form)) return null;
    return asked.step.seen ? t("Not alike yet") : t("Move a slider");
  },
  simulate(asked, random) {
    const made = slidersOf(asked).map(({ id }) => [id, Math.round(100 * random()) / 100] as const);
    const touched = made.map(([id]) => id);
    return { answers: { ...Object.fromEntries(made), seconds: inSeconds(1000 * asked.task.seconds * random()) }, touched, comment: "" };
  },
  panel: (view) => html`${keyed(view.step.index, html`<matching-task .view=${view}></matching-task>`)}`,
};
