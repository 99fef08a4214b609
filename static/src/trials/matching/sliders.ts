// The sliders of each interface: words and features between their ends, weights by their examples' numbers.

import { html, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { wordSliders } from "../../space/sliders";
import { filled } from "../../studio/slider";
import { t } from "../../words";
import type { MatchSlider, Positions } from "./model";

type Set = (id: string, position: number) => void;

export function matchSliders(by: string, sliders: readonly MatchSlider[], at: Positions, set: Set): TemplateResult {
  if (by === "weights") return html`<div class="weight-sliders">${sliders.map((one) => weight(one, at[one.id] ?? 0, set))}</div>`;
  return wordSliders(sliders.map((one) => ({ ...one, value: at[one.id] ?? 0 })), { set });
}

function weight({ id, title }: MatchSlider, value: number, set: Set): TemplateResult {
  const read = (event: Event) => set(id, (event.target as HTMLInputElement).valueAsNumber);
  return html`<div class="weight-slider" data-slider=${id}><span aria-hidden="true">${title}</span>
    <input class="filled" type="range" min="0" max="1" step="0.01" .value=${live(String(value))}
      aria-label=${t("Share of example {number}", { number: title })} aria-valuetext=${String(Math.round(100 * value))}
      @input=${read} ${filled({ min: 0, max: 1, neutral: 0, value })}></div>`;
}
