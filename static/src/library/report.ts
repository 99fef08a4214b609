// The import report: what was read and mended, one hair line each, and what a person should confirm.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import { counted, framesPerSecond, seconds, type Note, type Report } from "./model";

export const summary = ({ repairs, questions }: Report): string =>
  [counted(repairs.length, "repair"), questions.length ? counted(questions.length, "question") : ""]
    .filter(Boolean)
    .join(", ");

export function facts(report: Report): TemplateResult {
  const roles = report.missing_roles.length
    ? `${counted(report.missing_roles.length, "role")} missing`
    : "all roles found";
  return html`<dl class="facts">
    <div><dt>Length</dt><dd>${seconds(report.duration)} at ${framesPerSecond(report.frame_time)}</dd></div>
    <div><dt>Skeleton</dt><dd>${counted(report.joint_names.length, "joint")}, ${roles}</dd></div>
  </dl>`;
}

/**
 * What is asked stands first: on a low screen the repairs would push it out of sight.
 *
 * @param change opens the form that corrects what a question is about; none where nothing can change.
 */
export function notes(report: Report, change?: () => void): TemplateResult {
  return html`<ul class="report-notes">
    ${report.questions.map(
      (note) => html`<li class="question">
        ${icon("info")}<p>${question(note.text)}</p>
        ${change ? html`<button class="link-button" @click=${change}>Change</button>` : place(note)}
      </li>`,
    )}
    ${report.repairs.map((note) => html`<li>${icon("check")}<p>${note.text}</p>${place(note)}</li>`)}
    ${report.repairs.length + report.questions.length
      ? nothing
      : html`<li>${icon("check")}<p>Read as written; nothing had to be repaired.</p></li>`}
  </ul>`;
}

const place = ({ line, where }: Note) => {
  const words = line ? `line ${line}` : (where ?? "");
  return words ? html`<span class="tiny place">${words}</span>` : nothing;
};

/** The question itself in bold, what it rests on after it. */
const question = (text: string) => {
  const end = text.indexOf("?") + 1;
  return end ? html`<b>${text.slice(0, end)}</b>${text.slice(end)}` : text;
};
