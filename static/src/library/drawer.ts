// The drawer beside the library: the report of one import, or why it was refused.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import { correctionsForm, type Corrections } from "./corrections";
import { failure } from "./failure";
import type { ImportItem } from "./imports";
import { counted, type Clip, type Imported } from "./model";
import * as report from "./report";
import "./clip_body";
import "./measured_figure";

export interface DrawerActs {
  correcting: boolean;
  /** Other imports that wait to be looked at. */
  others: number;
  keep(): void;
  discard(): void;
  leaveOut(): void;
  follow(event: CustomEvent<Clip>): void;
  close(): void;
  change(on: boolean): void;
  correct(corrections: Corrections): void;
  retry(options: Record<string, unknown>): void;
}

export function drawer(item: ImportItem, acts: DrawerActs): TemplateResult {
  const escape = (event: KeyboardEvent) => event.key === "Escape" && acts.close();
  return html`<aside class="drawer" aria-label="Import report" @keydown=${escape} @kept=${acts.follow} @made=${acts.follow}>
    ${item.result ? imported(item, item.result, acts) : failure(item, acts.retry, acts.leaveOut)}
  </aside>`;
}

function imported(item: ImportItem, result: Imported, acts: DrawerActs): TemplateResult {
  const open = result.clip.state === "to_confirm";
  return html`${heading(item, result, acts)}
    ${result.clip.figure_url ? html`<measured-figure .clip=${result.clip}></measured-figure>` : noFigure}
    <div class="drawer-body">
      ${report.facts(result.report)}
      ${acts.correcting
        ? correctionsForm(result.report, acts.correct, () => acts.change(false))
        : report.notes(result.report, open ? () => acts.change(true) : undefined)}
      ${result.report.questions.length || acts.correcting || !open
        ? nothing
        : html`<p><button class="link-button" @click=${() => acts.change(true)}>Correct unit, axis or roles</button></p>`}
      ${acts.correcting || !result.clip.figure_url ? nothing : html`<clip-body clip-id=${result.clip.id}></clip-body>`}
    </div>
    <footer>
      ${acts.others ? html`<p class="tiny">${counted(acts.others, "more file")} to look at</p>` : nothing}
      ${open
        ? html`<div><button class="button" @click=${acts.discard}>Discard</button>
            <button class="button primary" data-first @click=${acts.keep}>Yes, keep it</button></div>`
        : html`<button class="button primary wide" data-first @click=${acts.leaveOut}>Go on</button>`}
    </footer>`;
}

/** The file is at hand in the visit that brought it only. */
const since = ({ file }: ImportItem, { already_there }: Imported): string =>
  already_there ? "In the library already" : file.size ? "Imported just now" : "Waits to be confirmed";

const heading = (item: ImportItem, result: Imported, acts: DrawerActs) => html`<header>
  <div><h2 class="head">${result.clip.name}</h2>
    <p class="small quiet">${since(item, result)} · ${report.summary(result.report)}</p></div>
  <button class="button quiet icon-button" @click=${acts.close}>${icon("close")}<span class="visually-hidden">Close; decide later</span></button>
</header>`;

const noFigure = html`<div class="note flat" role="status">${icon("info")}
  <p><b>No figure can stand on this skeleton yet.</b> Say below which joint moves which part.</p></div>`;
