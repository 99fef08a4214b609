// A slider that has no answer until it is touched: its knob appears with the first touch or key.

import { html, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { t } from "../words";

export interface Slider {
  id: string;
  name: string;
  left: string;
  right: string;
  /** 0 … 100, or undefined while nothing is answered. */
  value: number | undefined;
}

export const LOWEST = 0;
export const HIGHEST = 100;
const MIDDLE = 50;

export function slider({ id, name, left, right, value }: Slider, change: (value: number) => void): TemplateResult {
  const read = (event: Event) => change((event.target as HTMLInputElement).valueAsNumber);
  // A press on the very middle moves no knob and so makes no input event; it is an answer all the same.
  return html`<div class="slider" data-line=${id} ?data-open=${value === undefined}>
    <span class="pole left" aria-hidden="true">${left}</span><span class="pole right" aria-hidden="true">${right}</span>
    <input type="range" min=${LOWEST} max=${HIGHEST} step="1" .value=${live(String(value ?? MIDDLE))}
      data-answered=${value !== undefined} aria-label=${name}
      aria-valuetext=${value === undefined ? t("not answered yet") : t("{value} from {left} to {right}", { value, left, right })}
      @input=${read} @pointerup=${read}
      @keydown=${(event: KeyboardEvent) => event.key === " " && (event.preventDefault(), read(event))} />
  </div>`;
}
