// Free text about the whole study.

import { html, nothing } from "lit";
import { empty, set, type Form, type Kind } from "../../trials/kind";
import { textBox } from "../../trials/text";
import { t } from "../../words";

/** What a study sets. */
export interface Parameters {
  question: string;
  placeholder: string | null;
  required: boolean;
}

const written = (form: Form) => form.answers["text"] !== undefined;

export const comment: Kind<Parameters> = {
  layout: "page",
  data: { "answers.text": "text" },
  blank: empty,
  isComplete: ({ task }, form) => !task.required || written(form),
  remaining: () => null,
  simulate: (_, random) => set(empty(), "text", `made up ${random().toFixed(6)}`),
  panel({ task, form, change, pressed }) {
    const missing = pressed && task.required && !written(form);
    const label = html`<span class="visually-hidden">${task.question}</span>${task.required ? nothing : html`<small>${t("Optional")}</small>`}`;
    const error = missing ? t("Please write a few words.") : null;
    return html`<h1>${task.question}</h1>
      ${textBox({ id: "text", label, placeholder: task.placeholder, rows: 7, error }, form, change)}`;
  },
};
