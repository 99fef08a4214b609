// What the trial page says about the line, the server and other tabs. Calm, and always with a way on.

import { html, nothing, type TemplateResult } from "lit";
import type { ApiError } from "../api";
import { icon } from "../icons";

/** “1 answer”, “3 answers”. */
export function count(number: number, noun = "answer"): string {
  return `${number} ${noun}${number === 1 ? "" : "s"}`;
}

export interface Line {
  waiting: number;
  offline: boolean;
  refusal: ApiError | null;
}

/** Beside the progress: whether the server has everything. */
export function savedMark({ waiting, offline }: Line, answered: number): TemplateResult | typeof nothing {
  if (waiting && offline) return html`<span class="saved">${icon("cloud")}On this device</span>`;
  if (waiting) return html`<span class="saved">Saving …</span>`;
  return answered ? html`<span class="saved">${icon("check")}Saved</span>` : nothing;
}

/** Above the figure while the line is down or the server has refused an answer. */
export function lineNote({ waiting, offline, refusal }: Line, onward = "You can carry on."): TemplateResult {
  return html`<div class="line-note" role="status">${
    refusal ? refused(refusal) : offline ? noConnection(waiting, onward) : nothing
  }</div>`;
}

function noConnection(waiting: number, onward: string): TemplateResult {
  const kept = waiting
    ? `${count(waiting)} ${waiting === 1 ? "is" : "are"} kept on this device and ${
        waiting === 1 ? "goes out by itself" : "go out by themselves"}.`
    : "What you answered has arrived.";
  return html`<p class="note">${icon("cloud")}<span><strong>No connection.</strong> ${kept} ${onward}</span></p>`;
}

function refused(error: ApiError): TemplateResult {
  return html`<p class="note note-bad">${icon("warning")}<span><strong>An answer was not taken.</strong>
    ${error.message} ${error.mend ?? "It is kept on this device; load the page again to send it once more."}</span></p>`;
}

/** Instead of the figure until its clip is there. */
export function clipOnItsWay(share: number, slow: boolean, again: () => void): TemplateResult {
  return html`<div class="on-its-way" role="status">
    <p class="title">The next clip is on its way</p>
    <progress max="1" .value=${share} aria-label="Loading the clip"></progress>
    ${slow
      ? html`<p>Slow line? <button class="link-button" type="button" @click=${again}>Ask for it again</button>, or
          close the page and come back by the same link: your place is kept.</p>`
      : nothing}
  </div>`;
}

/** After the last clip, until the server has acknowledged every answer. No code is shown before that. */
export function sending(line: Line, again: () => void): TemplateResult {
  const { waiting, refusal } = line;
  const title = waiting > 1 ? `One moment, the last ${waiting} answers are being sent`
    : waiting === 1 ? "One moment, the last answer is being sent" : "One moment, your answers are being counted";
  return html`<div class="sending">
    <h1>${title}</h1>
    <p class="lead">Your code appears here as soon as everything has arrived. Please keep this page open.</p>
    ${lineNote(line, "")}
    ${refusal ? html`<button class="button" type="button" @click=${again}>Send again</button>` : nothing}
  </div>`;
}

export function otherTab(): TemplateResult {
  return html`<div class="sending" role="alertdialog" aria-labelledby="other-tab" aria-describedby="other-tab-more">
    <h1 id="other-tab">This study is open in another tab</h1>
    <p class="lead" id="other-tab-more">The other tab counts now. Everything that you answered here is kept.</p>
    <button class="button primary" type="button" autofocus @click=${() => location.reload()}>Continue here
      ${icon("arrow")}</button>
  </div>`;
}

/** The page cannot go on: no session, or a browser that cannot draw. */
export function stuck(title: string, text: string, help: string | null = null): TemplateResult {
  return html`<div class="sending" role="alert">
    <h1>${title}</h1>
    <p class="lead">${text}</p>
    <div class="buttons">
      <button class="button primary" type="button" @click=${() => location.reload()}>Try again</button>
      ${help ? html`<a class="button quiet" href=${help}>What to try</a>` : nothing}
    </div>
  </div>`;
}
