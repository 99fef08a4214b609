// One moving figure described in one's own words.

import { html } from "lit";
import { t } from "../words";
import { empty, set, type Form, type Kind } from "./kind";
import { textBox } from "./text";

/** What a study sets. */
export interface Parameters {
  required: boolean;
}

const written = (form: Form) => String(form.answers["text"] ?? "").trim() !== "";

export const freeText: Kind<Parameters> = {
  layout: "stage",
  data: { "answers.text": "text" },
  blank: empty,
  isComplete: ({ task }, form) => !task.required || written(form),
  remaining: ({ task }, form) => (task.required && !written(form) ? t("Write a few words") : null),
  simulate: (_, random) => set(empty(), "text", `made up ${random().toFixed(6)}`),
  panel: ({ form, change }) =>
    html`<div class="own-words">${textBox({ id: "text", label: t("In your own words") }, form, change)}</div>`,
};
