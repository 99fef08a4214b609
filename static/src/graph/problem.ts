// What the server refused, in its own words, and a way to try again.
import { html, nothing, type TemplateResult } from "lit";
import type { ApiError } from "../api";
import { icon } from "../icons";

export const problemNote = (problem: ApiError, again?: () => void): TemplateResult => html`<div class="note note-bad" role="alert">
  ${icon("warning")}<div><p><b>${problem.message}</b></p>${problem.mend ? html`<p>${problem.mend}</p>` : nothing}
  ${again ? html`<p><button class="link-button" type="button" @click=${again}>Load it again</button></p>` : nothing}</div></div>`;
