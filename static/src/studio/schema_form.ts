// The form of any operation, made from the JSON Schema of its parameters.
import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { typed } from "../typed";
import { hasSlider, inWords, isWhole, kindOf, mayBeNull, readJson, startOf, stepOf, type Schema } from "./form_model";
import { textOf, type Json, type Parameters } from "./recipe";
import type { Clip } from "./server";
import { amountSlider } from "./slider";

type Set = (value: Json) => void;
type Named = Pick<Clip, "id" | "name">;

export function schemaForm(schema: Schema, parameters: Parameters, clips: readonly Named[], set: (parameters: Parameters, name: string) => void): TemplateResult {
  return html`${Object.entries(schema.properties ?? {}).map(([name, member]) =>
    control(name, member, parameters[name] ?? startOf(member), clips, (value) => set({ ...parameters, [name]: value }, name)),
  )}`;
}

function control(name: string, schema: Schema, value: Json, clips: readonly Named[], set: Set): TemplateResult {
  const label = schema.title ?? inWords(name);
  const kind = kindOf(schema);
  if (kind === "clip") return clipChoice(label, schema, value, clips, set);
  const makers = { number, choice, choices, flag, text, json };
  return makers[kind](label, schema, value, set);
}

function number(label: string, schema: Schema, value: Json, set: Set): TemplateResult {
  const { minimum = 0, maximum = 1, neutral, unit, description } = schema;
  const step = stepOf(schema);
  if (hasSlider(schema)) {
    const start = typeof schema.default === "number" ? schema.default : minimum;
    return amountSlider(
      {
        label, value: Number(value), min: minimum, max: maximum, step, neutral: neutral ?? start,
        ...(unit ? { unit } : {}), ...(description ? { hint: description } : {}),
      },
      set,
    );
  }
  const change = (event: Event) => {
    const field = event.target as HTMLInputElement;
    if (field.value === "" && mayBeNull(schema)) set(null);
    else if (field.reportValidity() && field.value !== "") set(field.valueAsNumber);
  };
  return row(label, schema, html`<input class="input" type="number" min=${minimum} max=${maximum} step=${isWhole(schema) ? 1 : "any"}
    placeholder=${mayBeNull(schema) ? "as usual" : nothing} ${typed(value === null ? "" : String(value))} @change=${change}>`);
}

function choice(label: string, schema: Schema, value: Json, set: Set): TemplateResult {
  const choose = (event: Event) => set((event.target as HTMLSelectElement).value);
  return row(label, schema, html`<select class="input" @change=${choose}>
    ${schema.enum!.map((option) => html`<option value=${String(option)} ?selected=${option === value}>${inWords(option)}</option>`)}
  </select>`);
}

/** Another clip by its name; one that is not known here keeps its id. */
function clipChoice(label: string, schema: Schema, value: Json, clips: readonly Named[], set: Set): TemplateResult {
  const unknown = clips.every(({ id }) => id !== value);
  const choose = (event: Event) => set((event.target as HTMLSelectElement).value);
  return row(label, schema, html`<select class="input" @change=${choose}>
    ${unknown ? html`<option value=${String(value)} selected>${String(value).slice(0, 8)}</option>` : nothing}
    ${clips.map(({ id, name }) => html`<option value=${id} ?selected=${id === value}>${name}</option>`)}
  </select>`);
}

/** Several of a list; none chosen means what null means, where null may stand. */
function choices(label: string, schema: Schema, value: Json, set: Set): TemplateResult {
  const chosen = Array.isArray(value) ? value : [];
  const options = schema.items!.enum!;
  const toggle = (option: Json) => {
    const next = options.filter((other) => (other === option) !== chosen.includes(other));
    set(next.length || !mayBeNull(schema) ? next : null);
  };
  return html`<fieldset class="form-choices"><legend class="label">${label}</legend>
    <div class="chips">${options.map(
      (option) => html`<button class="chip" type="button" aria-pressed=${chosen.includes(option)} @click=${() => toggle(option)}>
        ${inWords(option)}</button>`,
    )}</div>${hint(schema)}</fieldset>`;
}

function flag(label: string, _: Schema, value: Json, set: Set): TemplateResult {
  const change = (event: Event) => set((event.target as HTMLInputElement).checked);
  return html`<label class="choice"><input type="checkbox" .checked=${live(value === true)} @change=${change}><span>${label}</span></label>`;
}

function text(label: string, schema: Schema, value: Json, set: Set): TemplateResult {
  const names = (schema.anyOf ?? []).flatMap((one) => one.enum ?? []).map(inWords);
  const change = (event: Event) => set((event.target as HTMLInputElement).value.trim());
  return row(label, schema, html`<input class="input" type="text" spellcheck="false" ${typed(String(value ?? ""))} @change=${change}
    placeholder=${names.length ? names.join(", ") : "64 characters 0–9, a–f"}>`);
}

/** Anything larger is written as JSON; what is none stays in the field, and is told. */
function json(label: string, schema: Schema, value: Json, set: Set): TemplateResult {
  const change = (event: Event) => {
    const field = event.target as HTMLTextAreaElement;
    const read = readJson(field.value);
    field.setCustomValidity("problem" in read ? `This is not JSON: ${read.problem}` : "");
    field.setAttribute("aria-invalid", String("problem" in read));
    if (field.reportValidity() && "value" in read && textOf(read.value) !== textOf(value)) set(read.value);
  };
  return row(`${label}, as JSON`, schema, html`<textarea class="input code" rows="3" spellcheck="false" .value=${JSON.stringify(value)} @change=${change}></textarea>`);
}

const row = (label: string, schema: Schema, field: TemplateResult): TemplateResult =>
  html`<div class="field"><label><span class="label">${label}${schema.unit ? ` (${schema.unit})` : ""}</span>${field}</label>${hint(schema)}</div>`;

const hint = ({ description }: Schema) => (description ? html`<p class="hint">${description}</p>` : nothing);
