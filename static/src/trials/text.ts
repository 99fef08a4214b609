// A box for an answer in one's own words.

import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { set, unset, type Change, type Form } from "./kind";

/** As much as the server takes. */
export const LONGEST_TEXT = 5000;

export interface TextBox {
  id: string;
  label: string | TemplateResult;
  placeholder?: string | null;
  rows?: number;
  error?: string | null;
}

export function textBox({ id, label, placeholder, rows = 5, error }: TextBox, form: Form, change: Change): TemplateResult {
  const input = ({ target }: InputEvent) => {
    const { value } = target as HTMLTextAreaElement;
    change((now) => (value.trim() ? set(now, id, value) : unset(now, id)));
  };
  return html`<div class="field"><label class="box-label" for="box-${id}">${label}</label>
    <textarea class="input" id="box-${id}" rows=${rows} maxlength=${LONGEST_TEXT} placeholder=${placeholder ?? nothing}
      aria-invalid=${error ? "true" : nothing} aria-describedby=${error ? `error-${id}` : nothing}
      .value=${live(String(form.answers[id] ?? ""))} @input=${input}></textarea>
    ${error ? html`<p class="field-error" id="error-${id}">${error}</p>` : nothing}</div>`;
}
