// Several moving figures put into order: by choosing them one after the other, or by moving one up and down.

import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import { t, tn } from "../words";
import { draw, empty, set, unset, type Asked, type CellParts, type Change, type Form, type Kind, type View } from "./kind";

/** What a study sets: what the first and the last place mean. */
export interface Parameters {
  first: string;
  last: string;
}

const left = ({ step }: Asked<unknown>, form: Form) => step.figures.length - Object.keys(form.answers).length;

/** The figures that have a place, the first one first. */
export function order(form: Form): string[] {
  return Object.keys(form.answers).sort((one, other) => rankOf(form, one) - rankOf(form, other));
}

/** Gives a figure the next free place; one that has a place loses it, and those behind it move up. */
export function toggle(form: Form, id: string): Form {
  if (form.answers[id] === undefined) return set(form, id, Object.keys(form.answers).length + 1);
  return ranked(order(form).filter((other) => other !== id), unset(form, id));
}

/** Moves a figure one place forward (−1) or back (1); its neighbour changes places with it. */
export function move(form: Form, id: string, by: -1 | 1): Form {
  const ordered = order(form);
  const at = ordered.indexOf(id);
  const neighbour = ordered[at + by];
  if (at < 0 || neighbour === undefined) return form;
  [ordered[at], ordered[at + by]] = [neighbour, id];
  return ranked(ordered, form);
}

function ranked(ordered: readonly string[], form: Form): Form {
  return { ...form, answers: Object.fromEntries(ordered.map((id, index) => [id, index + 1])) };
}

function rankOf(form: Form, id: string): number {
  return form.answers[id] as number;
}

export const ranking: Kind<Parameters> = {
  layout: "cells",
  data: { answers: "each figure, counted from 0 as they stand on the page, to its rank, 1 the first" },
  blank: empty,
  isComplete: (asked, form) => left(asked, form) === 0,
  remaining(asked, form) {
    const number = left(asked, form);
    return number ? tn("{n} figure to go", "{n} figures to go", number) : null;
  },
  simulate({ step }, random) {
    const rest = step.figures.map((_, place) => String(place));
    let form = empty();
    while (rest.length) form = toggle(form, rest.splice(draw(0, rest.length - 1, random), 1)[0]!);
    return form;
  },
  panel: ({ task, step }) =>
    html`<span class="verdict">${t("1 = {first}, {n} = {last}", { first: task.first, n: step.figures.length, last: task.last })}</span>`,
  cell,
};

function cell(view: View<Parameters>, place: number): CellParts {
  const { form, change } = view;
  const id = String(place);
  const rank = form.answers[id] as number | undefined;
  const flip = () => change((now) => toggle(now, id));
  return { head: letter(place), chosen: rank !== undefined, tap: flip, foot: buttons(view, id, rank, flip) };
}

/** Figures are lettered, because the numbers are their ranks. */
function letter(place: number): string {
  return String.fromCharCode("A".charCodeAt(0) + place);
}

function buttons({ form, change }: View<Parameters>, id: string, rank: number | undefined, flip: () => void): TemplateResult {
  const name = letter(Number(id));
  const last = Object.keys(form.answers).length;
  const label = rank === undefined ? t("Give figure {name} a place", { name }) : t("Figure {name} is number {rank}; take its place away", { name, rank });
  const shift = (by: -1 | 1, word: string, drawn: string) => html`<button class="button quiet shift" type="button"
    aria-label=${word} title=${word} ?disabled=${by < 0 ? rank === 1 : rank === last} @click=${() => change((now) => move(now, id, by))}>${icon(drawn)}</button>`;
  return html`<div class="rank" data-line=${id} ?data-open=${rank === undefined} @keydown=${(event: KeyboardEvent) => onKey(event, id, change)}>
    ${rank === undefined ? nothing : shift(-1, t("Move figure {name} forward", { name }), "back")}
    <button class="button place-button" type="button" aria-pressed=${rank !== undefined} aria-label=${label} @click=${flip}>${rank ?? t("Place")}</button>
    ${rank === undefined ? nothing : shift(1, t("Move figure {name} back", { name }), "arrow")}</div>`;
}

function onKey(event: KeyboardEvent, id: string, change: Change): void {
  const by = event.key === "ArrowLeft" ? -1 : event.key === "ArrowRight" ? 1 : 0;
  if (by === 0 || event.altKey || event.ctrlKey || event.metaKey) return;
  event.preventDefault();
  change((now) => move(now, id, by));
}
