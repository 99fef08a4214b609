// The addresses by which participants come, ready to be copied.
import { html, type TemplateResult } from "lit";
import { icon } from "../icons";

export interface Link {
  label: string;
  address: string;
  hint?: string;
}

/** Prolific fills the words in double braces in by itself. */
export const prolificLink = (study: string): Link => ({
  label: "Study URL for Prolific",
  address: `${study}?PROLIFIC_PID={{%PROLIFIC_PID%}}&STUDY_ID={{%STUDY_ID%}}&SESSION_ID={{%SESSION_ID%}}`,
});

export const sonaLink = (study: string): Link => ({
  label: "Study URL for SONA",
  address: `${study}?id=%SURVEY_CODE%`,
});

export const mturkLink = (study: string): Link => ({
  label: "Address for an ExternalQuestion",
  address: study,
  hint: "Mechanical Turk adds the worker and the assignment by itself.",
});

export const linkRow = ({ label, address, hint }: Link): TemplateResult => html`<div class="field link-field"><span class="label">${label}</span>
  <div class="secret"><code>${address}</code><button class="button" type="button" data-copy=${address}>${icon("copy")}<span data-word aria-live="polite">Copy</span><span class="visually-hidden"> ${label}</span></button></div>
  ${hint ? html`<p class="hint">${hint}</p>` : ""}</div>`;

/** Personal links as a table for a mail merge. Labels that would be formulas become text. */
export function asCsv(links: readonly { label: string; url: string }[]): string {
  const cell = (text: string) => `"${(/^[=+\-@\t\r]/.test(text) ? `'${text}` : text).replaceAll('"', '""')}"`;
  return ["label,url", ...links.map(({ label, url }) => `${cell(label)},${cell(url)}`), ""].join("\r\n");
}
