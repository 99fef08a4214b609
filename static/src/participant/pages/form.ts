// Questions about the person. What is missing or wrong is said beside its field.

import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { draw, empty, set, unset, type Kind, type Value, type View } from "../../trials/kind";
import { textBox } from "../../trials/text";
import { t } from "../../words";
import { faultOf, toggled, typed, type Field } from "./form_fields";
import { paragraphs } from "./text";

/** What a study sets. */
export interface Parameters {
  heading: string;
  text: string | null;
  fields: readonly Field[];
}

/** More options than this are a list to open. */
const MOST_BUTTONS = 12;
const LONGEST_LINE = 500;

export const form: Kind<Parameters> = {
  layout: "page",
  data: { answers: "field id to its text, its number, the chosen option's id, or a list of the chosen options' ids" },
  blank: empty,
  isComplete: ({ task }, form) => task.fields.every((field) => faultOf(field, form) === null),
  remaining: () => null,
  simulate: ({ task }, random) =>
    task.fields.reduce((form, field) => set(form, field.id, madeUp(field, random)), empty()),
  panel: (view) => html`<h1>${view.task.heading}</h1>
    <div class="prose">${paragraphs(view.task.text)}</div>
    <div class="fields">${view.task.fields.map((field) => drawn(field, view))}</div>`,
};

function madeUp({ type, options, minimum, maximum }: Field, random: () => number): Value {
  const low = minimum ?? 0;
  if (type === "number") return draw(Math.ceil(low), Math.floor(maximum ?? low + 100), random);
  const option = options[draw(0, options.length - 1, random)]?.id ?? "";
  if (type === "choices") return [option];
  return type === "choice" ? option : `made up ${random().toFixed(6)}`;
}

function drawn(field: Field, view: View<Parameters>): TemplateResult {
  const { form, change } = view;
  const error = view.pressed ? faultOf(field, form) : null;
  const { id, type } = field;
  const label = html`${field.label} ${field.required ? nothing : html`<small>${t("Optional")}</small>`}`;
  if (type === "long_text") return textBox({ id, label, error }, form, change);
  if (type === "choices" || (type === "choice" && field.options.length <= MOST_BUTTONS)) {
    return buttons(field, label, error, view);
  }
  const input = type === "choice" ? list(field, error, view) : line(field, error, view);
  return html`<div class="field"><label class="box-label" for="box-${id}">${label}</label>${input}${said(id, error)}</div>`;
}

function line(field: Field, error: string | null, { form, change }: View<Parameters>): TemplateResult {
  const { id, type, unit } = field;
  const input = ({ target }: InputEvent) => change((now) => typed(field, (target as HTMLInputElement).value, now));
  // Not `live`: what is being typed (“3.”) may be the same number as before and must stay as it is.
  return html`<span class="with-unit ${type}"><input class="input" id="box-${id}" autocomplete="off" maxlength=${LONGEST_LINE}
    inputmode=${type === "number" ? "decimal" : "text"} .value=${String(form.answers[id] ?? "")}
    aria-required=${field.required} aria-invalid=${error ? "true" : nothing} aria-describedby=${error ? `error-${id}` : nothing}
    @input=${input} />${unit ? html`<span class="unit">${unit}</span>` : nothing}</span>`;
}

function list(field: Field, error: string | null, { form, change }: View<Parameters>): TemplateResult {
  const { id } = field;
  const pick = ({ target }: Event) => {
    const { value } = target as HTMLSelectElement;
    change((now) => (value ? set(now, id, value) : unset(now, id)));
  };
  return html`<select class="input" id="box-${id}" aria-required=${field.required} aria-invalid=${error ? "true" : nothing}
    aria-describedby=${error ? `error-${id}` : nothing} .value=${live(String(form.answers[id] ?? ""))} @change=${pick}>
    <option value="">${t("Choose …")}</option>
    ${field.options.map((option) => html`<option value=${option.id} ?selected=${form.answers[id] === option.id}>${option.label}</option>`)}
  </select>`;
}

function buttons(field: Field, label: TemplateResult, error: string | null, { form, change }: View<Parameters>): TemplateResult {
  const { id } = field;
  const several = field.type === "choices";
  const value = form.answers[id];
  const option = ({ id: option, label }: { id: string; label: string }) => {
    const chosen = several ? Array.isArray(value) && value.includes(option) : value === option;
    const choose = () => change((now) => (several ? toggled(field, option, now) : set(now, id, option)));
    return html`<label class="choice"><input type=${several ? "checkbox" : "radio"} name=${id} value=${option}
      .checked=${live(chosen)} @change=${choose} /><span>${label}</span></label>`;
  };
  return html`<fieldset class="field" aria-describedby=${error ? `error-${id}` : nothing}>
    <legend class="box-label">${label}</legend>${field.options.map(option)}${said(id, error)}</fieldset>`;
}

function said(id: string, error: string | null): TemplateResult | typeof nothing {
  return error ? html`<p class="field-error" id="error-${id}">${error}</p>` : nothing;
}
