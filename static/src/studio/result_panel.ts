// The right panel: what the checks say, the variants of this clip, and ways to take one along.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import { faultWords, fineLines, sizeWords, timeWords, type Finding } from "./checks";
import { exportPanel, type ExportActs } from "./export_panel";
import type { Clip } from "./server";
import type { Session } from "./session";
import { deleteButton } from "./slider";

export interface ResultActs extends Omit<ExportActs, "variant"> {
  seek(finding: Finding): void;
  easeOff(): void;
  open(clip: string): void;
  remove(clip: Clip): void;
}

export interface ResultState {
  variants: Clip[];
  /** What was copied, in words. */
  said: string;
  /** How far the edit was eased off, in words. */
  eased: string;
  busy: boolean;
}

const SHOWN = 6;

export function resultPanel(session: Session, state: ResultState, acts: ResultActs): TemplateResult {
  return html`${checks(session, state, acts)} ${variants(session, state, acts)} ${exports(session, state, acts)}`;
}

function checks(session: Session, { busy, eased }: ResultState, acts: ResultActs): TemplateResult {
  const report = session.checked?.report;
  const shown = report?.findings.slice(0, SHOWN) ?? [];
  const more = (report?.findings.length ?? 0) - shown.length;
  return html`<section class="report ${session.checking ? "stale" : ""}"><header><h2>Checks</h2>
      <span class="tiny" role="status">${session.checking ? "being checked" : report ? (report.clean ? "all is well" : "") : "not checked"}</span></header>
    <ul>${shown.map((finding) => fault(finding, acts))}
      ${more > 0 ? html`<li><span></span><p class="tiny">and ${more} more, marked in the strip below</p></li>` : nothing}
      ${report ? fineLines(report.findings).map((words) => html`<li class="fine">${icon("check")}<p>${words}</p></li>`) : nothing}</ul>
    ${report && !report.clean && session.steps.length
      ? html`<button class="button wide" type="button" ?disabled=${busy} @click=${acts.easeOff}>Ease off until all is well</button>`
      : nothing}
    <p class="tiny" role="status">${eased}</p></section>`;
}

const fault = (finding: Finding, { seek }: ResultActs) => html`<li class="fault">${icon("warning")}
  <p>${faultWords(finding)} <b>${sizeWords(finding.size, finding.unit)}</b>
    <button class="link-button" type="button" @click=${() => seek(finding)}>${timeWords(finding)}</button>
    <span class="tiny">${sizeWords(finding.limit, finding.unit)} allowed</span></p></li>`;

function variants(session: Session, { variants }: ResultState, { open, remove }: ResultActs): TemplateResult {
  return html`<section class="variants"><header><h2>Variants</h2><span class="tiny">of ${session.source.name}</span></header>
    ${variants.length
      ? html`<ul>${variants.map(
          (clip) => html`<li><button class="variant" type="button" aria-current=${clip.id === session.saved.id ? "true" : nothing} @click=${() => open(clip.id)}>
            <span class="still"><motion-thumbnail src=${clip.glb_url} figure=${clip.figure_url ?? nothing} poster-time=${clip.poster_time}></motion-thumbnail></span>
            <span>${clip.name}</span></button>${deleteButton(clip.name, () => remove(clip))}</li>`,
        )}</ul>`
      : html`<p class="quiet">What you save is kept here, to be opened again.</p>`}
    ${session.saved.id === session.source.id
      ? nothing
      : html`<button class="link-button" type="button" @click=${() => open(session.source.id)}>Begin again from the original</button>`}</section>`;
}

const exports = (session: Session, { said, busy }: ResultState, { download, copied, saved }: ResultActs): TemplateResult =>
  exportPanel({ said, busy }, {
    variant: () => Promise.resolve({ source: session.source.id, operations: session.steps, name: session.name || session.suggestedName }),
    download,
    copied,
    saved,
  }, html`<a class="make-set" href="/research/sets">${icon("sets")}Make a set</a>`);
