// What the trial page says about the line, the server and other tabs. Calm, and always with a way on.

import { html, nothing, type TemplateResult } from "lit";
import type { ApiError } from "../api";
import { icon } from "../icons";
import { t, tn } from "../words";

export interface Line {
  waiting: number;
  offline: boolean;
  refusal: ApiError | null;
}

/** Beside the progress: whether the server has everything. */
export function savedMark({ waiting, offline }: Line, answered: number): TemplateResult | typeof nothing {
  if (waiting && offline) return html`<span class="saved">${icon("cloud")}${t("On this device")}</span>`;
  if (waiting) return html`<span class="saved">${t("Saving …")}</span>`;
  return answered ? html`<span class="saved">${icon("check")}${t("Saved")}</span>` : nothing;
}

/** Above the figure while the line is down or the server has refused an answer. */
export function lineNote({ waiting, offline, refusal }: Line, onward = t("You can carry on.")): TemplateResult {
  return html`<div class="line-note" role="status">${
    refusal ? refused(refusal) : offline ? noConnection(waiting, onward) : nothing
  }</div>`;
}

function noConnection(waiting: number, onward: string): TemplateResult {
  const kept = waiting
    ? tn(
        "{n} answer is kept on this device and goes out by itself.",
        "{n} answers are kept on this device and go out by themselves.",
        waiting,
      )
    : t("What you answered has arrived.");
  return html`<p class="note">${icon("cloud")}<span><strong>${t("No connection.")}</strong> ${kept} ${onward}</span></p>`;
}

function refused(error: ApiError): TemplateResult {
  const mend = error.mend ?? t("It is kept on this device; load the page again to send it once more.");
  return html`<p class="note note-bad">${icon("warning")}<span><strong>${t("An answer was not taken.")}</strong>
    ${error.message} ${mend}</span></p>`;
}

/** Instead of the figure until its clip is there. */
export function clipOnItsWay(share: number, slow: boolean, again: () => void): TemplateResult {
  return html`<div class="on-its-way" role="status">
    <p class="title">${t("The next clip is on its way")}</p>
    <progress max="1" .value=${share} aria-label=${t("Loading the clip")}></progress>
    ${slow
      ? html`<p>${t("Slow line? Your place is kept, also if you close the page and come back by the same link.")}
          <button class="link-button" type="button" @click=${again}>${t("Ask for it again")}</button></p>`
      : nothing}
  </div>`;
}

/** After the last step, until the server has acknowledged every answer. No code is shown before that. */
export function sending(line: Line, again: () => void): TemplateResult {
  const { waiting, refusal } = line;
  const title = waiting
    ? tn("One moment, the last answer is being sent", "One moment, the last {n} answers are being sent", waiting)
    : t("One moment, your answers are being counted");
  return html`<div class="sending">
    <h1>${title}</h1>
    <p class="lead">${t("Your code appears here as soon as everything has arrived. Please keep this page open.")}</p>
    ${lineNote(line, "")}
    ${refusal ? html`<button class="button" type="button" @click=${again}>${t("Send again")}</button>` : nothing}
  </div>`;
}

export function otherTab(): TemplateResult {
  return html`<div class="sending" role="alertdialog" aria-labelledby="other-tab" aria-describedby="other-tab-more">
    <h1 id="other-tab">${t("This study is open in another tab")}</h1>
    <p class="lead" id="other-tab-more">${t("The other tab counts now. Everything that you answered here is kept.")}</p>
    <button class="button primary" type="button" autofocus @click=${() => location.reload()}>${t("Continue here")}
      ${icon("arrow")}</button>
  </div>`;
}

/** A preview ends here: there is nothing to send. */
export function previewOver(again: () => void): TemplateResult {
  return html`<div class="sending" role="status">
    <h1>${t("That was the last step")}</h1>
    <p class="lead">${t("This is a preview: nothing that was answered is kept.")}</p>
    <button class="button primary" type="button" @click=${again}>${t("Start again")} ${icon("replay")}</button>
  </div>`;
}

/** The page cannot go on: no session, or a browser that cannot draw. */
export function stuck(title: string, text: string, help: string | null = null): TemplateResult {
  return html`<div class="sending" role="alert">
    <h1>${title}</h1>
    <p class="lead">${text}</p>
    <div class="buttons">
      <button class="button primary" type="button" @click=${() => location.reload()}>${t("Try again")}</button>
      ${help ? html`<a class="button quiet" href=${help}>${t("What to try")}</a>` : nothing}
    </div>
  </div>`;
}
