// What stands under the scales of a trial: the comment, the way back and the way on.

import { html, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { icon } from "../icons";
import type { Form, Parameters } from "../trials/semantic_differential";

const LONGEST_COMMENT = 2000;

export function comment(study: Parameters, form: Form, change: (form: Form) => void): TemplateResult {
  const onInput = ({ target }: InputEvent) => change({ ...form, comment: (target as HTMLTextAreaElement).value });
  return html`<label class="field comment"><span><strong>${study.comment_label}</strong> Optional</span>
    <textarea class="input" rows="1" maxlength=${LONGEST_COMMENT} placeholder=${study.comment_placeholder}
      .value=${live(form.comment)} @input=${onInput}></textarea></label>`;
}

interface Place {
  index: number;
  length: number;
}

/** Both buttons rest until the clip is shown; while it is still being fetched, Next also looks it. */
export function footer(
  { index, length }: Place,
  { ready, fetched }: { ready: boolean; fetched: boolean },
  back: () => void,
): TemplateResult {
  return html`<footer class="panel-footer ${fetched ? "resting" : ""}">
    <button class="button quiet back" type="button" ?hidden=${index === 0} ?disabled=${!ready} @click=${back}>
      ${icon("back")} Back</button>
    <button class="button primary next" type="submit" ?disabled=${!ready} @click=${firstOnly}>
      ${index + 1 < length ? "Next clip" : "Finish"} ${icon("arrow")}</button>
  </footer>`;
}

/**
 * The second click of a double click answers nothing. A busy device may deliver it long after the first, when the next
 * clip is already there; the browser still knows that the two belong together.
 */
function firstOnly(event: MouseEvent): void {
  if (event.detail > 1) event.preventDefault();
}
