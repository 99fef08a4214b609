// One amount: its name, a slider that fills from where it does nothing, its value, and a way back.
import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { ref } from "lit/directives/ref.js";
import { icon } from "../icons";

export interface Amount {
  label: string;
  value: number;
  min: number;
  max: number;
  step: number;
  /** Where it does nothing, and where reset leads. */
  neutral: number;
  unit?: string;
  hint?: string;
  /** Where it can be deleted, while it does nothing. */
  remove?: () => void;
}

export function amountSlider(amount: Amount, set: (value: number) => void): TemplateResult {
  const { label, value, min, max, step, neutral, unit = "", hint, remove } = amount;
  const text = `${value.toFixed(step < 1 ? 2 : 0)}${unit && ` ${unit}`}`;
  const input = (event: Event) => set(Number((event.target as HTMLInputElement).value));
  return html`<div class="amount" title=${hint ?? nothing}>
    <label><span>${label}</span>
      <input class="filled" type="range" min=${min} max=${max} step=${step} .value=${live(String(value))} aria-valuetext=${text}
        @input=${input} @dblclick=${() => set(neutral)} ${filled(amount)}></label>
    <span class="amount-value" aria-hidden="true">${text.replace("-", "−")}</span>
    ${remove && value === neutral ? deleteButton(label, remove) : resetButton(label, value !== neutral, () => set(neutral))}
  </div>`;
}

/** A way back for one control; it keeps its place where there is nothing to go back from. */
export const resetButton = (label: string, changed: boolean, reset: () => void): TemplateResult =>
  html`<button class="reset" type="button" title="Reset ${label}" aria-label="Reset ${label}" ?disabled=${!changed} @click=${reset}>
    ${icon("replay")}</button>`;

/** Takes something captured or saved off the server; who calls it asks first. */
export const deleteButton = (label: string, remove: () => void): TemplateResult =>
  html`<button class="reset" type="button" title="Delete ${label}" aria-label="Delete ${label}" @click=${remove}>
    ${icon("close")}</button>`;

/** Fills a range from its neutral place. The content policy allows no style in markup, so it is set on the element. */
export const filled = (amount: Pick<Amount, "value" | "min" | "max" | "neutral">) =>
  ref((element) => paint(element as HTMLElement | undefined, amount));

/** What a slider was last painted like: in a drag most of a page's sliders stand still. */
const painted = new WeakMap<HTMLElement, string>();

function paint(slider: HTMLElement | undefined, { value, min, max, neutral }: Pick<Amount, "value" | "min" | "max" | "neutral">): void {
  if (!slider) return;
  const share = (at: number) => (Math.min(Math.max(at, min), max) - min) / (max - min);
  const [from, to] = [share(neutral), share(value)].sort((one, other) => one - other) as [number, number];
  const places = { from, to, neutral: share(neutral) };
  const look = JSON.stringify(places);
  if (painted.get(slider) === look) return;
  painted.set(slider, look);
  for (const [name, place] of Object.entries(places)) slider.style.setProperty(`--${name}`, place.toFixed(4));
}
