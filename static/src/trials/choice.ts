// What choosing one of several figures has in common, whether of two or of ten.

import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { icon } from "../icons";
import { t } from "../words";
import { draw, empty, set, type CellParts, type Form, type Kind, type View } from "./kind";

/** The chosen figure, counted from 0, or −1 for none of them. */
const CHOICE = "choice";
export const NONE = -1;

export interface ChoiceOptions<P> {
  unit: string;
  /** What the figure at a place is called: “3”, “B”. */
  name: (place: number) => string;
  /** How many of the figures can be chosen; the others are only looked at. */
  count: (view: Pick<View<P>, "step">) => number;
  /** The words for “none of them”, where the study allows that. */
  none: (task: P) => string | null;
  open: () => string;
  chosen: (name: string) => string;
}

export function choosing<P>(options: ChoiceOptions<P>): Kind<P> {
  const { count, none } = options;
  return {
    layout: "cells",
    data: { "answers.choice": options.unit },
    blank: empty,
    isComplete: (_, form) => form.answers[CHOICE] !== undefined,
    remaining: (_, form) => (form.answers[CHOICE] === undefined ? options.open() : null),
    simulate({ task, step }, random) {
      const lowest = none(task) === null ? 0 : NONE;
      return set(empty(), CHOICE, draw(lowest, count({ step }) - 1, random));
    },
    panel(view) {
      const words = none(view.task);
      return html`<span class="verdict">${verdict(view.form, options)}</span>
        ${words === null ? nothing : noneOfThem(words, view)}`;
    },
    cell: (view, place) => cell(view, place, options),
    onward: () => t("Keep this choice"),
  };
}

function cell<P>(view: View<P>, place: number, { name, count }: ChoiceOptions<P>): CellParts {
  const head = name(place);
  if (place >= count(view)) return { head };
  const chosen = view.form.answers[CHOICE] === place;
  const choose = () => view.change((now) => set(now, CHOICE, place));
  return { head, chosen, tap: choose, corner: radio(place, t("Figure {name}", { name: head }), chosen, choose) };
}

function radio(place: number, label: string, chosen: boolean, choose: () => void): TemplateResult {
  return html`<span class="pick"><input type="radio" name=${CHOICE} value=${place} .checked=${live(chosen)}
    aria-label=${label} @change=${choose} /><i>${chosen ? icon("check") : nothing}</i></span>`;
}

function noneOfThem<P>(words: string, { form, change }: View<P>): TemplateResult {
  const chosen = form.answers[CHOICE] === NONE;
  return html`<label class="choice"><input type="radio" name=${CHOICE} value=${NONE} .checked=${live(chosen)}
    @change=${() => change((now) => set(now, CHOICE, NONE))} /><span>${words}</span></label>`;
}

function verdict<P>(form: Form, { name, chosen }: ChoiceOptions<P>): string {
  const choice = form.answers[CHOICE];
  return typeof choice === "number" && choice !== NONE ? chosen(name(choice)) : "";
}
