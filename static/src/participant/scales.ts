// The bipolar scales of a trial: one group of radio buttons per scale, made for mouse, finger and keyboard.

import { html, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { nameOf, values, type Form, type Parameters, type Scale } from "../trials/semantic_differential";

type Choose = (scale: string, value: number) => void;

export function scales(study: Parameters, form: Form, choose: Choose): TemplateResult {
  return html`<div class="scales">
    <div class="step-words" aria-hidden="true">${study.steps.map((word) => html`<span>${word}</span>`)}</div>
    ${study.scales.map((scale) => group(scale, study.steps, form, choose))}
  </div>`;
}

function group(scale: Scale, steps: readonly string[], form: Form, choose: Choose): TemplateResult {
  const touched = form.touched.includes(scale.id);
  const step = (value: number) => html`<span class="step step-${reachOf(value, steps)}">
    <input type="radio" name=${scale.id} value=${value} .checked=${live(form.answers[scale.id] === value)}
      data-touched=${touched} aria-label=${nameOf(value, scale, steps)}
      @click=${() => choose(scale.id, value)} /><i></i></span>`;
  return html`<div class="scale" role="radiogroup" aria-label="${scale.left} or ${scale.right}"
    @keydown=${(event: KeyboardEvent) => onKey(event, scale.id, values(steps), choose)}>
    <span class="pole left" aria-hidden="true">${scale.left}</span>
    <span class="steps">${values(steps).map(step)}</span>
    <span class="pole right" aria-hidden="true">${scale.right}</span>
  </div>`;
}

/** Names a step's size and colour: l2 l1 0 r1 r2, the ends always 2. */
function reachOf(value: number, steps: readonly string[]): string {
  if (value === 0) return "0";
  const end = Math.abs(value) === (steps.length - 1) / 2;
  return `${value < 0 ? "l" : "r"}${end ? 2 : 1}`;
}

/**
 * Arrows move within the scale and stop at its ends (a browser's own radio group would jump from one pole to the
 * other), digits choose a step by its place, the space bar confirms a preselected middle.
 */
function onKey(event: KeyboardEvent, scale: string, choices: number[], choose: Choose): void {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const inputs = [...(event.currentTarget as HTMLElement).querySelectorAll("input")];
  const at = inputs.indexOf(event.target as HTMLInputElement);
  const target = targetOf(event.key, at, inputs.length);
  if (target === null) return;
  event.preventDefault();
  inputs[target]?.focus();
  choose(scale, choices[target] ?? 0);
}

/** The place that a key leads to from place `at`, or null where the key means nothing here. */
export function targetOf(key: string, at: number, count: number): number | null {
  if (key === "ArrowLeft" || key === "ArrowUp") return Math.max(0, at - 1);
  if (key === "ArrowRight" || key === "ArrowDown") return Math.min(count - 1, at + 1);
  if (key === "Home") return 0;
  if (key === "End") return count - 1;
  if (key === " ") return at;
  const digit = Number.parseInt(key, 10);
  return key.length === 1 && digit >= 1 && digit <= count ? digit - 1 : null;
}
