// The bar on top: which space, what the motion is called, undo and redo, export, save.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import { back, brand, type Drawer } from "../studio/top_bar";
import type { SpaceSession } from "./session";

export interface BarActs {
  undo(): void;
  redo(): void;
  exports(): void;
  save(): void;
  drawer(name: Drawer): void;
}

export function spaceBar(session: SpaceSession | null, { drawer, busy }: { drawer: Drawer | null; busy: boolean }, acts: BarActs): TemplateResult {
  return html`<header class="studio-top">
    ${brand}${back("/studio/spaces", "Spaces")}
    <nav class="crumbs" aria-label="Where you are"><a href="/studio">Studio</a><span aria-hidden="true">/</span><a href="/studio/spaces">Spaces</a><span aria-hidden="true">/</span></nav>
    ${session ? title(session) : html`<h1>Authoring space</h1>`}
    ${session
      ? html`<div class="acts">
          <button class="button quiet icon-button" type="button" title="Undo, Ctrl+Z" aria-label="Undo" ?disabled=${!session.history.canUndo} @click=${acts.undo}>${icon("undo")}</button>
          <button class="button quiet icon-button" type="button" title="Redo, Ctrl+Shift+Z" aria-label="Redo" ?disabled=${!session.history.canRedo} @click=${acts.redo}>${icon("redo")}</button>
        </div>
        <div class="acts drawer-acts">
          <button class="button" type="button" aria-expanded=${drawer === "movement"} @click=${() => acts.drawer("movement")}>Feel</button>
          <button class="button" type="button" aria-expanded=${drawer === "results"} @click=${() => acts.drawer("results")}>Mix</button></div>
        <div class="acts save"><button class="button export-button" type="button" @click=${acts.exports}>${icon("import")}<span>Export</span></button>
          <button class="button primary" type="button" ?disabled=${busy || session.isSaved} @click=${acts.save}>Save</button></div>`
      : nothing}
  </header>`;
}

function title(session: SpaceSession): TemplateResult {
  const { space, name, suggestedName, isSaved, saved } = session;
  const call = (event: Event) => session.call((event.target as HTMLInputElement).value);
  return html`<div class="studio-title"><h1 class="visually-hidden">Authoring space: ${space.name}</h1>
    <input class="title" aria-label="Name of the motion" maxlength="200" placeholder=${suggestedName} .value=${name} @input=${call}>
    <p class="tiny">in ${space.name}, version ${space.number} · <span role="status">${isSaved ? "saved" : "not saved"}</span>
      ${isSaved ? html`· <a href="/studio?clip=${saved!.id}&space=${space.id}">Open in the studio</a>` : nothing}</p></div>`;
}
