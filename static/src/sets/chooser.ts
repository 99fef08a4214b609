// The left side: which clips, which presets, under which tag.

import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import { caption } from "../library/model";
import { matching, type Choice, type Clip, type Preset } from "./model";

const SHOWN = 200; // rows; beyond, a person searches

export interface Chooser {
  clips: readonly Clip[];
  presets: readonly Preset[];
  choice: Choice;
  query: string;
  search(query: string): void;
  toggle(what: "sources" | "presets", id: string): void;
  takeAll(ids: string[], on: boolean): void;
  callSet(name: string): void;
}

export function chooser(given: Chooser): TemplateResult {
  return html`<div class="set-choice">
    ${clipPart(given)}
    <section aria-labelledby="presets-title">
      <h2 id="presets-title">Presets <span class="count">${given.choice.presets.size || ""}</span></h2>
      <div class="chips">${given.presets.map(
        ({ name, title, summary }) => html`<button class="chip" type="button" title=${summary}
          aria-pressed=${given.choice.presets.has(name)} @click=${() => given.toggle("presets", name)}>${title}</button>`,
      )}</div>
    </section>
    <div class="field"><label for="set-name">Name of the set</label>
      <input class="input" id="set-name" maxlength="200" .value=${given.choice.set}
        @input=${(event: InputEvent) => given.callSet((event.target as HTMLInputElement).value)}>
      <p class="hint">All its clips get the tag <b>set: ${given.choice.set || "modified"}</b>, by which the library finds them.</p></div>
  </div>`;
}

function clipPart(given: Chooser): TemplateResult {
  const found = matching(given.clips, given.query);
  const shown = found.slice(0, SHOWN);
  const all = shown.length > 0 && shown.every(({ id }) => given.choice.sources.has(id));
  return html`<section aria-labelledby="clips-title">
    <header class="set-part"><h2 id="clips-title">Clips <span class="count">${given.choice.sources.size || ""}</span></h2>
      ${shown.length
        ? html`<button class="link-button small" type="button" @click=${() => given.takeAll(shown.map(({ id }) => id), !all)}>
            ${all ? "None of these" : `All ${shown.length}`}</button>`
        : nothing}</header>
    <label class="search">${icon("search")}<span class="visually-hidden">Search clips</span>
      <input class="input" type="search" placeholder="Name, style or tag" .value=${given.query}
        @input=${(event: InputEvent) => given.search((event.target as HTMLInputElement).value)}></label>
    <ul class="set-clips" tabindex="-1">${shown.map((clip) => clipRow(clip, given))}</ul>
    ${found.length ? nothing : html`<p class="quiet" role="status">No clip is called or tagged like that.</p>`}
    ${found.length > shown.length ? html`<p class="hint">${found.length - shown.length} more. Search to see them.</p>` : nothing}
  </section>`;
}

const clipRow = (clip: Clip, { choice, toggle }: Chooser): TemplateResult => html`<li>
  <label class="choice"><input type="checkbox" .checked=${choice.sources.has(clip.id)} @change=${() => toggle("sources", clip.id)}>
    <span class="set-clip"><span>${clip.name}</span> <span class="tiny">${caption(clip)}</span></span></label></li>`;
