// What the builder asks in between: which part to add, whether to publish, which version to look at.
import { html, nothing, type TemplateResult } from "lit";
import type { ApiError } from "../api";
import type { components } from "../api-types";
import { icon } from "../icons";
import { PAGES, TASKS, type Kind } from "./fields";
import type { Study } from "./model";

export type Changes = components["schemas"]["Changes"];

const closeButton = html`<button class="button quiet icon-button" type="button" aria-label="Close" @click=${(event: Event) => (event.target as Element).closest("dialog")?.close()}>${icon("close")}</button>`;
const head = (title: string, id: string) => html`<header><h2 class="figure-title" id=${id}>${title}</h2>${closeButton}</header>`;

export function addDialog(add: (kind: string, task?: string) => void): TemplateResult {
  const choose = (event: Event, kind: string, task?: string) => {
    (event.target as Element).closest("dialog")?.close();
    add(kind, task);
  };
  const list = (kinds: Record<string, Kind>, act: (event: Event, id: string) => void) => html`<ul class="kinds">${Object.entries(kinds).map(
    ([id, { title, about }]) => html`<li><button type="button" @click=${(event: Event) => act(event, id)}><b>${title}</b><span>${about}</span></button></li>`,
  )}</ul>`;
  return html`<dialog class="builder-dialog" id="add-dialog" aria-labelledby="add-title">${head("Add a part", "add-title")}
    <h3>Questions about clips</h3>${list(TASKS, (event, id) => choose(event, "trials", id))}
    <h3>Pages</h3>${list(PAGES, (event, id) => choose(event, id))}</dialog>`;
}

export interface Publishing {
  changes: Changes | null;
  refused: ApiError | null;
  busy: boolean;
  done: boolean;
  state: Study["state"];
  slug: string;
  mend: TemplateResult | null;
  publish(): void;
}

export function publishDialog(given: Publishing): TemplateResult {
  const { changes, done } = given;
  const title = done ? `Version ${changes?.number} is published` : changes?.same ? "Nothing to publish" : changes ? `Publish version ${changes.number}` : "Publish";
  return html`<dialog class="builder-dialog" id="publish-dialog" aria-labelledby="publish-title">${head(title, "publish-title")}
    ${given.refused ? (given.mend ?? refusal(given.refused)) : nothing}
    ${changes ? body(given, changes) : given.refused ? nothing : html`<p class="quiet" role="status">Looking at what is new.</p>`}
    <footer>${done || changes?.same || given.refused
      ? html`${done ? html`<a class="button" href=${`/research/studies/${given.slug}/settings`}>Links and settings</a>` : nothing}<button class="button primary" type="button" @click=${(event: Event) => (event.target as Element).closest("dialog")?.close()}>Close</button>`
      : html`<button class="button primary" type="button" ?disabled=${!changes || given.busy} @click=${given.publish}>${given.busy ? "Publishing" : "Publish"}</button>`}</footer></dialog>`;
}

function body({ done, state }: Publishing, changes: Changes): TemplateResult {
  if (changes.same) return html`<p>The draft is the same as version ${changes.number}.</p>${hash(changes.hash)}`;
  return html`<ul class="changes">${changes.changes.map((sentence) => html`<li>${sentence}</li>`)}</ul>
    <p class="quiet">${done ? "New participants see it from now on." : state === "draft" ? "This opens the study. A version never changes; answers belong to it." : "New participants see it from then on; who has begun stays with theirs."}</p>${hash(changes.hash)}`;
}

const hash = (value: string) => html`<p class="hash"><span class="label">Hash</span> <code>${value}</code></p>`;

export const refusal = ({ message, mend }: ApiError): TemplateResult => html`<div class="note note-bad" role="alert">${icon("warning")}<div><p><b>${message}</b></p>${mend ? html`<p>${mend}</p>` : nothing}</div></div>`;

export function versionsDialog(study: Study, isDraft: boolean, discard: (() => void) | null): TemplateResult {
  const address = `/api/v1/studies/${study.slug}/file`;
  const files = (query: string) => html`<a href=${`${address}?format=yaml${query}`} download>YAML</a> <a href=${`${address}?format=json${query}`} download>JSON</a>`;
  return html`<dialog class="builder-dialog" id="versions-dialog" aria-labelledby="versions-title">${head("Versions", "versions-title")}
    <ul class="versions">
      ${isDraft ? html`<li><header><h3>Draft</h3>${files("")}</header>
        ${discard ? html`<button class="button" type="button" @click=${discard}>Go back to version ${study.versions[0]?.number}</button>` : nothing}</li>` : nothing}
      ${study.versions.map((version) => html`<li><header><h3>Version ${version.number}</h3>${files(`&version=${version.number}`)}</header>
        <p class="tiny">${new Date(version.published_at).toLocaleString()} · ${version.sessions} ${version.sessions === 1 ? "participant" : "participants"}</p>
        <ul class="changes">${version.changes.map((sentence) => html`<li>${sentence}</li>`)}</ul>${hash(version.hash)}</li>`)}
    </ul></dialog>`;
}
