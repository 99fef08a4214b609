// The right panel: how much of every example is in the mix, how far outside of them it is, and ways to take it along.
import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { repeat } from "lit/directives/repeat.js";
import { icon } from "../icons";
import { exportPanel, type ExportActs } from "../studio/export_panel";
import { filled } from "../studio/slider";
import type { SpaceSession } from "./session";

export interface WeightActs extends ExportActs {
  weigh(clip: string, weight: number): void;
  look(index: number): void;
  join(): void;
}

export interface WeightState {
  /** What was copied. */
  said: string;
  /** What was made of the space. */
  told: string;
  busy: boolean;
}

/** A weight that is said as 0 %. */
const NONE = 0.005;

export function weightsPanel(session: SpaceSession, state: WeightState, acts: WeightActs): TemplateResult {
  return html`${blend(session, acts)} ${facts(session, state.told, acts)} ${exportPanel(state, acts)}`;
}

function blend(session: SpaceSession, acts: WeightActs): TemplateResult {
  const { examples } = session.space.definition;
  return html`<section class="blend" aria-labelledby="blend-title"><header><h2 id="blend-title">Mix</h2><span class="tiny">${examples.length} examples, together 100 %</span></header>
    <ul class="weights" tabindex="-1">${repeat(examples, ({ clip }) => clip, ({ clip, name, predicted }, index) =>
      row({ clip, name, predicted: Boolean(predicted), index, weight: session.weights[index] ?? 0, looked: session.looking === index }, acts))}</ul></section>`;
}

interface Row {
  clip: string;
  name: string;
  predicted: boolean;
  index: number;
  weight: number;
  looked: boolean;
}

function row({ clip, name, predicted, index, weight, looked }: Row, { weigh, look }: WeightActs): TemplateResult {
  const percent = `${Math.round(100 * weight)} %`;
  const read = (event: Event) => weigh(clip, (event.target as HTMLInputElement).valueAsNumber);
  return html`<li class=${weight < NONE ? "none" : ""} data-clip=${clip}>
    <button class="weight-name" type="button" aria-pressed=${looked} title="Look at ${name}" @click=${() => look(index)}>${name}${predicted
      ? html` <span class="tag" title="Nobody rated it: its place was predicted from its motion">predicted</span>` : nothing}</button>
    <span class="weight-value" aria-hidden="true">${percent}</span>
    <input class="filled" type="range" min="0" max="1" step="0.01" .value=${live(String(weight))} aria-label="Weight of ${name}" aria-valuetext=${percent}
      @input=${read} ${filled({ min: 0, max: 1, neutral: 0, value: weight })}></li>`;
}

function facts({ outside, space, place }: SpaceSession, told: string, { join }: WeightActs): TemplateResult {
  const notes = (space.notes as Record<string, string[] | undefined>)[place.by] ?? [];
  return html`<section class="space-facts">
    <p class="outside" role="status">${outside > NONE
      ? html`${icon("info")}<span><b>Outside what the examples span</b>, by ${Math.round(100 * outside)}\u00a0% of a slider’s length. The figure stays a mix of them.</span>`
      : nothing}</p>
    ${notes.map((words) => html`<p class="tiny">${words}</p>`)}
    <button class="link-button" type="button" @click=${join}>${icon("plus")}Add a clip to the space</button>
    <p class="tiny told" role="status">${told}</p></section>`;
}
