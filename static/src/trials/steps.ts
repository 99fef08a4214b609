// Lines of steps to choose from: one group of radio buttons a line, made for mouse, finger and keyboard.

import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { icon } from "../icons";
import { t, tn } from "../words";
import { open, set, type Change, type Form } from "./kind";

export interface Line {
  id: string;
  /** What a screen reader calls the line. */
  name: string;
  left: string;
  right: string;
  /** Above the steps, where the line is more than two poles. */
  label?: string;
}

export interface Steps {
  lines: readonly Line[];
  /** The steps' words from left to right, and the value of each. */
  words: readonly string[];
  values: readonly number[];
  /** What a screen reader says for a step of a line. */
  nameOf: (place: number, line: Line) => string;
  /** Size and colour: two poles about a middle, or more and more of one thing. */
  tone: "bipolar" | "amount";
}

type Choose = (id: string, value: number) => void;
/** From so many lines on, hair lines part them and a count says how many are answered. */
const MANY = 9;
/** More steps than this leave no room for words beside them. */
const BESIDE = 5;

export function stepLines(steps: Steps, form: Form, change: Change): TemplateResult {
  const choose: Choose = (id, value) => change((now) => set(now, id, value));
  const { lines, words } = steps;
  const stacked = words.length > BESIDE || lines.some(({ label }) => label);
  return html`<div class="scales of-${words.length} ${steps.tone} ${stacked ? "stacked" : ""} ${lines.length >= MANY ? "many" : ""}">
    <div class="step-words" aria-hidden="true">${words.map((word) => html`<span>${word}</span>`)}</div>
    ${lines.map((line) => group(line, steps, form, choose))}
  </div>`;
}

function group(line: Line, steps: Steps, form: Form, choose: Choose): TemplateResult {
  const { values } = steps;
  const touched = form.touched.includes(line.id);
  const chosen = values.findIndex((value) => form.answers[line.id] === value);
  const entry = chosen >= 0 ? chosen : entryOf(steps);
  const step = (value: number, place: number) => html`<span class="step ${classOf(place, steps)}">
    <input type="radio" name=${line.id} value=${value} .checked=${live(place === chosen)}
      tabindex=${place === entry ? 0 : -1} data-touched=${touched} aria-label=${steps.nameOf(place, line)}
      @click=${() => choose(line.id, value)} /><i></i></span>`;
  return html`<div class="scale" role="radiogroup" aria-label=${line.name} data-line=${line.id} ?data-open=${chosen < 0}
    @keydown=${(event: KeyboardEvent) => onKey(event, line.id, values, choose)}>
    ${line.label ? html`<span class="line-label" aria-hidden="true">${line.label}</span>` : nothing}
    <span class="pole left" aria-hidden="true">${line.left}</span>
    <span class="steps">${values.map(step)}</span>
    <span class="pole right" aria-hidden="true">${line.right}</span>
  </div>`;
}

/** Where the keyboard enters a line without an answer: in the middle, or at the lowest step. */
function entryOf({ tone, values }: Steps): number {
  return tone === "bipolar" ? Math.floor((values.length - 1) / 2) : 0;
}

/** Names a step's size and colour: l2 l1 0 r1 r2 with the ends always 2; a1 … a5 for amounts. */
function classOf(place: number, { tone, values }: Steps): string {
  const last = values.length - 1;
  if (tone === "amount") return `step-a${1 + Math.round((4 * place) / last)}`;
  const from = 2 * place - last;
  if (from === 0) return "step-0";
  return `step-${from < 0 ? "l" : "r"}${Math.abs(from) === last ? 2 : 1}`;
}

/**
 * Arrows move within the line and stop at its ends (a browser's own radio group would jump from one pole to the
 * other), digits choose a step by its place, the space bar confirms a preselected middle.
 */
function onKey(event: KeyboardEvent, id: string, values: readonly number[], choose: Choose): void {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const inputs = [...(event.currentTarget as HTMLElement).querySelectorAll("input")];
  const at = inputs.indexOf(event.target as HTMLInputElement);
  const target = targetOf(event.key, at, inputs.length);
  if (target === null) return;
  event.preventDefault();
  inputs[target]?.focus();
  choose(id, values[target] ?? 0);
}

/** The place that a key leads to from place `at`, or null where the key means nothing here. */
export function targetOf(key: string, at: number, count: number): number | null {
  if (key === "ArrowLeft" || key === "ArrowUp") return Math.max(0, at - 1);
  if (key === "ArrowRight" || key === "ArrowDown") return Math.min(count - 1, at + 1);
  if (key === "Home") return 0;
  if (key === "End") return count - 1;
  if (key === " ") return at;
  const digit = key === "0" ? 10 : Number.parseInt(key, 10);
  return key.length === 1 && digit >= 1 && digit <= count ? digit - 1 : null;
}

/** “9 of 41 pairs answered”, and the way to the next one without an answer; for long lists only. */
export function answeredOf(lines: readonly Line[], form: Form): TemplateResult | typeof nothing {
  if (lines.length < MANY) return nothing;
  const left = open(lines.map(({ id }) => id), form).length;
  const count = tn("of {n} pair answered", "of {n} pairs answered", lines.length);
  return html`<div class="answered"><span><strong>${lines.length - left}</strong> ${count}</span>
    <button class="button quiet" type="button" ?hidden=${left === 0} @click=${toNextOpen}>
      ${t("Next open pair")} ${icon("down")}</button></div>`;
}

function toNextOpen(event: Event): void {
  const panel = (event.currentTarget as HTMLElement).closest(".panel-scroll");
  if (panel) focusNextOpen(panel, null);
}

/** Goes to the next line without an answer, after `from` or else the first. Returns whether there is one. */
export function focusNextOpen(panel: Element, from: Element | null): boolean {
  const lines = [...panel.querySelectorAll<HTMLElement>("[data-line]")];
  const at = lines.findIndex((line) => line.contains(from));
  const ordered = [...lines.slice(at + 1), ...lines.slice(0, at + 1)];
  const next = ordered.find((line) => line.hasAttribute("data-open"));
  if (!next) return false;
  enter(next);
  return true;
}

/** Puts the focus into a line; the list moves only if the line is out of view. */
export function enter(line: Element): void {
  const entry = line.querySelector<HTMLElement>('input[tabindex="0"], input:not([tabindex])');
  entry?.focus({ preventScroll: true });
  line.scrollIntoView?.({ block: "nearest" });
}
