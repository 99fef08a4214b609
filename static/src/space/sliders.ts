// Sliders between two words: primary ones with their name on top, single pairs with a way to swap or delete them.
// For authors and for participants alike.
import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { repeat } from "lit/directives/repeat.js";
import { filled } from "../studio/slider";
import { t } from "../words";

export interface WordSlider {
  id: string;
  /** On top; without one, the words at the ends stand there. */
  title?: string | undefined;
  hint?: string | undefined;
  left: string;
  right: string;
  /** 0 at the left end, 1 at the right. */
  value: number;
  /** Of its words, where that is not the page's own language. */
  lang?: string | undefined;
  /** The value in words; a number from 0 to 100 where there are none. */
  words?: string | undefined;
}

export interface SliderActs {
  set(id: string, value: number): void;
  swap?(id: string): void;
  remove?(id: string): void;
}

const HALF = { min: 0, max: 1, neutral: 0.5 };
const percent = (value: number): string => String(Math.round(100 * value));

/** `loose`: whether a slider may be swapped and deleted. */
export const wordSliders = (sliders: readonly WordSlider[], acts: SliderActs, loose: (id: string) => boolean = () => false): TemplateResult =>
  html`<div class="word-sliders">${repeat(sliders, ({ id }) => id, (slider) => wordSlider(slider, acts, loose(slider.id)))}</div>`;

function wordSlider(slider: WordSlider, acts: SliderActs, loose: boolean): TemplateResult {
  const { id, title, hint, left, right, value, words, lang = nothing } = slider;
  const name = title ?? t("{left} or {right}", { left, right });
  const said = words ?? t("{value} from {left} to {right}", { value: percent(value), left, right });
  const read = (event: Event) => acts.set(id, (event.target as HTMLInputElement).valueAsNumber);
  return html`<div class="word-slider ${title ? "titled" : ""}" data-slider=${id} title=${hint ?? nothing}>
    ${title ? html`<p class="word-title" lang=${lang} aria-hidden="true">${title}</p>` : nothing}
    <span class="word-end left" lang=${lang} aria-hidden="true">${left}</span>
    ${loose ? tools(id, name, acts) : nothing}
    <span class="word-end right" lang=${lang} aria-hidden="true">${right}</span>
    <input class="filled" type="range" min="0" max="1" step="0.01" .value=${live(String(value))} aria-label=${name} aria-valuetext=${said}
      @input=${read} @dblclick=${() => acts.set(id, HALF.neutral)} ${filled({ ...HALF, value })}>
  </div>`;
}

const tools = (id: string, name: string, { swap, remove }: SliderActs): TemplateResult => html`<span class="word-tools">
  ${swap ? tool(t("Swap"), t("Swap {name} for another pair", { name }), () => swap(id)) : nothing}
  ${remove ? tool(t("Delete"), t("Delete {name}", { name }), () => remove(id)) : nothing}</span>`;

const tool = (word: string, label: string, act: () => void): TemplateResult =>
  html`<button class="link-button" type="button" aria-label=${label} @click=${act}>${word}</button>`;
