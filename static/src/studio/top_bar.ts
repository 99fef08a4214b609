// The bar on top: which clip, what it is called, undo and redo, A or B, save.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import type { Mix } from "./mix";
import type { Session } from "./session";

export interface TopActs {
  choose(): void;
  undo(): void;
  redo(): void;
  compare(original: boolean): void;
  exports(): void;
  save(): void;
  drawer(name: Drawer): void;
}

export type Drawer = "movement" | "results";

export interface TopState {
  original: boolean;
  drawer: Drawer | null;
  busy: boolean;
  /** What is on the stage, if it is a mix. */
  mix: Mix | null;
}

export function topBar(session: Session | null, { original, busy, drawer, mix }: TopState, acts: TopActs): TemplateResult {
  return html`<header class="studio-top">
    ${brand}${back("/library", "Library")}
    <nav class="crumbs" aria-label="Where you are"><a href="/library">Library</a><span aria-hidden="true">·</span><a href="/studio/spaces">Spaces</a><span aria-hidden="true">/</span></nav>
    ${session ? title(session, mix, acts) : html`<h1>Studio</h1>`}
    ${session
      ? html`<div class="acts">
          <button class="button quiet icon-button" type="button" title="Undo, Ctrl+Z" aria-label="Undo" ?disabled=${!session.history.canUndo} @click=${acts.undo}>${icon("undo")}</button>
          <button class="button quiet icon-button" type="button" title="Redo, Ctrl+Shift+Z" aria-label="Redo" ?disabled=${!session.history.canRedo} @click=${acts.redo}>${icon("redo")}</button>
        </div>
        <div class="segments compare" role="group" aria-label="Compare; key C">
          <button type="button" aria-pressed=${original} @click=${() => acts.compare(true)}><b>A</b><span> original</span></button>
          <button type="button" aria-pressed=${!original} @click=${() => acts.compare(false)}><b>B</b><span> edited</span></button>
        </div>
        ${drawers(session, drawer, acts)}
        <div class="acts save"><button class="button export-button" type="button" @click=${acts.exports}>${icon("import")}<span>Export</span></button>
          <button class="button primary" type="button" ?disabled=${busy || session.isSaved} @click=${acts.save}>Save</button></div>`
      : nothing}
  </header>`;
}

/** On a narrow screen the panels open by these. */
function drawers(session: Session, drawer: Drawer | null, acts: TopActs): TemplateResult {
  const faults = session.checked?.report.findings.length ?? 0;
  return html`<div class="acts drawer-acts">
    <button class="button" type="button" aria-expanded=${drawer === "movement"} @click=${() => acts.drawer("movement")}>Edit</button>
    <button class="button" type="button" aria-expanded=${drawer === "results"} @click=${() => acts.drawer("results")}>Results${faults
      ? html` <span class="count">${faults}<span class="visually-hidden"> found by the checks</span></span>`
      : nothing}</button></div>`;
}

function title(session: Session, mix: Mix | null, { choose }: TopActs): TemplateResult {
  const call = (event: Event) => session.call((event.target as HTMLInputElement).value);
  return html`<div class="studio-title"><h1 class="visually-hidden">Studio: ${session.name || session.suggestedName}</h1>
    <input class="title" aria-label="Name of the variant" maxlength="200" placeholder=${session.suggestedName} .value=${session.name} @input=${call}>
    <p class="tiny">from <button class="link-button" type="button" title="Choose another clip" @click=${choose}>${session.source.name}</button>${mix ? origin(mix) : nothing}
      · <span role="status">${session.isSaved ? "saved" : "not saved"}</span></p></div>`;
}

const origin = ({ examples, space }: Mix): TemplateResult => html`, a mix of ${examples === 1 ? "1 example" : `${examples} examples`}${space
  ? html` in <a href="/studio/spaces/${space.id}">${space.name}</a>`
  : nothing}`;

/** On a narrow screen, the way up in place of the crumbs. */
export const back = (address: string, words: string): TemplateResult =>
  html`<a class="button quiet icon-button way-back" href=${address} aria-label="Back to: ${words}" title=${words}>${icon("back")}</a>`;

/** The way home. */
export const brand = html`<a class="brand" href="/" aria-label="Manner"><svg class="mark" viewBox="0 0 18 28" aria-hidden="true"><path d="M3.6 26.4 9.9 9.6c2.3 5 2.9 7 3.2 9.6l1 7"></path><circle cx="11" cy="4.6" r="3.4"></circle></svg><span>Manner</span></a>`;
