// Draws the fields of any part from their descriptions (fields.ts). What a field changes goes to `set`.
import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { icon } from "../icons";
import type { Clip } from "../library/model";
import { typed } from "../typed";
import { checksField } from "./checks";
import { clipField, clipsField } from "./clips";
import type { Field } from "./fields";
import { at, isObj, languagesOf, LANGUAGES, listOf, objOf, partsOf, problemsAt, said, textOf, wordsIn, wordsWith, type Json, type Language, type Path, type Problem } from "./model";
import { sortable } from "./sortable";
import { spaceField, targetsField } from "./spaces";

/** What the forms work on, and how they change it. */
export interface Editing {
  study: Json;
  language: Language;
  problems: readonly Problem[];
  clips: readonly Clip[];
  /** Whether anything may be changed. */
  editable: boolean;
  /** Whether clips beyond the first few are shown. */
  allClips: boolean;
  set(path: Path, value: Json | undefined): void;
  pick(several: boolean, chosen: (ids: string[]) => void): void;
  /** Show the stimulus that stands there. */
  look(path: Path): void;
  showAllClips(): void;
}

type Of<T extends Field["type"]> = Extract<Field, { type: T }>;
type Draw<T extends Field["type"]> = (field: Of<T>, path: Path, value: Json | undefined, editing: Editing) => TemplateResult;

/** The fields of the object that stands at `base`. */
export function form(fields: readonly Field[], base: Path, editing: Editing): TemplateResult {
  const whole = objOf(at(editing.study, base));
  return html`${fields.filter(({ when }) => when?.(whole) ?? true).map((field) => {
    const path = field.at ? [...base, ...field.at.split(".")] : base; // a list of texts has no members
    return (DRAW[field.type] as Draw<typeof field.type>)(field as never, path, at(editing.study, path), editing);
  })}`;
}

/** The id of a place's control, by which problems lead to it. */
export const idOf = (path: Path): string => `at-${path.join("-")}`;

const DRAW: { [T in Field["type"]]: Draw<T> } = {
  words: (field, path, value, editing) => {
    const [first] = languagesOf(editing.study) as [Language];
    const { language } = editing;
    const change = (event: Event) => editing.set(path, orLeftOut(field, wordsWith(value, language, first, valueOf(event))));
    const given = wordsIn(value, language, first);
    const other = language === first ? "" : wordsIn(value, first, first);
    const input = field.long
      ? html`<textarea class="input" id=${idOf(path)} rows="3" lang=${language} placeholder=${other} .value=${live(given)} @input=${change} aria-describedby=${`${idOf(path)}-note`} aria-invalid=${invalid(path, editing, true)}></textarea>`
      : html`<input class="input" id=${idOf(path)} lang=${language} placeholder=${other} .value=${live(given)} @input=${change} aria-describedby=${`${idOf(path)}-note`} aria-invalid=${invalid(path, editing, true)}>`;
    return labelled(field, path, input, editing, true);
  },
  text: (field, path, value, editing) =>
    labelled(field, path, html`<input class="input" id=${idOf(path)} spellcheck="false" autocomplete="off" placeholder=${field.placeholder ?? ""}
      .value=${live(textOf(value))} @input=${(event: Event) => editing.set(path, orLeftOut(field, valueOf(event)))}
      aria-describedby=${`${idOf(path)}-note`} aria-invalid=${invalid(path, editing)}>`, editing),
  number: (field, path, value, editing) => {
    const change = (event: Event) => {
      const input = event.target as HTMLInputElement;
      if (input.value !== "") editing.set(path, input.valueAsNumber);
      else if (!input.validity.badInput) editing.set(path, field.optional ? undefined : (field.start ?? 0));
    };
    return labelled(field, path, html`<input class="input short" id=${idOf(path)} type="number" min=${field.min ?? nothing} max=${field.max ?? nothing} step=${field.step ?? 1}
      ${typed(String(typeof value === "number" ? value : (field.start ?? "")))} @change=${change} aria-describedby=${`${idOf(path)}-note`} aria-invalid=${invalid(path, editing)}>`, editing);
  },
  time: (field, path, value, editing) => {
    const change = (event: Event) => {
      const given = valueOf(event);
      editing.set(path, given ? new Date(given).toISOString() : undefined);
    };
    return labelled(field, path, html`<input class="input short" id=${idOf(path)} type="datetime-local" ${typed(localTime(textOf(value)))} @change=${change}
      aria-describedby=${`${idOf(path)}-note`} aria-invalid=${invalid(path, editing)}>`, editing);
  },
  switch: (field, path, value, editing) => {
    const change = (event: Event) => editing.set(path, (event.target as HTMLInputElement).checked);
    return html`<div class="field"><label class="toggle"><input type="checkbox" role="switch" id=${idOf(path)} .checked=${live(value === undefined ? field.start === true : value === true)} @change=${change}><span>${field.label}</span></label>${notes(field, path, editing)}</div>`;
  },
  choice: (field, path, value, editing) => {
    const chosen = textOf(value) || (field.options[0]?.[0] ?? "");
    return labelled(field, path, html`<select class="input" id=${idOf(path)} @change=${(event: Event) => editing.set(path, valueOf(event) || undefined)} aria-describedby=${`${idOf(path)}-note`}>
      ${field.options.map(([option, label]) => html`<option value=${option} ?selected=${option === chosen}>${label}</option>`)}</select>`, editing);
  },
  list: listField,
  lines: linesField,
  group: (field, path, value, editing) => html`<div class="field group"><label class="toggle"><input type="checkbox" role="switch" id=${idOf(path)} .checked=${live(isObj(value))}
      @change=${(event: Event) => editing.set(path, (event.target as HTMLInputElement).checked ? field.blank : undefined)}><span>${field.label}</span></label>
    ${isObj(value) ? html`<div class="group-fields">${form(field.fields, path, editing)}</div>` : nothing}${notes(field, path, editing)}</div>`,
  clip: clipField,
  clips: clipsField,
  checks: checksField,
  space: spaceField,
  targets: targetsField,
  several: (field, path, value, editing) => {
    const ids = field.options.map(([id]) => id);
    const chosen = value === undefined ? ids : listOf(value).map(textOf);
    const toggle = (id: string) => editing.set(path, ids.filter((one) => (one === id) !== chosen.includes(one)));
    return html`<fieldset class="field" id=${idOf(path)} tabindex="-1"><legend class="label">${field.label}</legend><div class="chips">
      ${field.options.map(([id, label]) => html`<button class="chip" type="button" aria-pressed=${chosen.includes(id)} ?disabled=${chosen.length === 1 && chosen[0] === id} @click=${() => toggle(id)}>${label}</button>`)}
      </div>${notes(field, path, editing)}</fieldset>`;
  },
  sets: (field, path, value, editing) => {
    const lines = listOf(value).map((set) => listOf(set).join(", ")).join("\n");
    const change = (event: Event) => {
      const sets = valueOf(event).split("\n").map((line) => line.split(",").map((name) => name.trim()).filter(Boolean));
      const given = sets.filter((set) => set.length);
      editing.set(path, given.length ? given : undefined);
    };
    const hint = "One line a page: the clips’ names with commas between. Empty: all at once, or every pair.";
    return labelled({ ...field, hint }, path, html`<textarea class="input" id=${idOf(path)} rows="3" spellcheck="false" ${typed(lines)} @change=${change} aria-describedby=${`${idOf(path)}-note`}></textarea>`, editing);
  },
  groups: (field, path, value, editing) => {
    const groups = listOf(at(editing.study, ["groups"])).map(objOf);
    const named = listOf(value);
    const toggle = (id: Json) => {
      const next = groups.map((group) => group["id"]!).filter((one) => (one === id) !== named.includes(one));
      editing.set(path, next.length ? next : undefined);
    };
    if (!groups.length && !named.length) return html``;
    return html`<fieldset class="field"><legend class="label">${field.label}</legend><div class="chips">
      ${groups.map(({ id, label }) => html`<button class="chip" type="button" aria-pressed=${named.includes(id!)} @click=${() => toggle(id!)}>${textOf(label) || textOf(id)}</button>`)}
      </div><p class="hint">${named.length ? "Only these." : "All of them."}</p>${notes(field, path, editing)}</fieldset>`;
  },
  blocks: (field, path, value, editing) => {
    const names = partsOf(editing.study).map(({ id }) => textOf(id));
    const block = listOf(listOf(value)[0]);
    const toggle = (name: string) => {
      const next = names.filter((one) => (one === name) !== block.includes(one));
      const rest = listOf(value).slice(1);
      editing.set(path, next.length || rest.length ? [...(next.length ? [next] : []), ...rest] : undefined);
    };
    if (names.length < 2) return html``;
    return html`<fieldset class="field"><legend class="label">${field.label}</legend><div class="chips">
      ${names.map((name) => html`<button class="chip" type="button" aria-pressed=${block.includes(name)} @click=${() => toggle(name)}>${name.replaceAll("_", " ")}</button>`)}
      </div><p class="hint">Choose two or more, or none.</p>${notes(field, path, editing, true)}</fieldset>`;
  },
  languages: (field, path, _, editing) => {
    const chosen = languagesOf(editing.study);
    const toggle = (id: Language) =>
      editing.set(path, chosen.includes(id) ? chosen.filter((one) => one !== id) : [...chosen, id]);
    return html`<fieldset class="field" id=${idOf(path)}><legend class="label">${field.label}</legend><div class="chips">
      ${LANGUAGES.map(([id, name]) => html`<button class="chip" type="button" aria-pressed=${chosen.includes(id)} ?disabled=${chosen.length === 1 && chosen[0] === id} @click=${() => toggle(id)}><span lang=${id}>${name}</span></button>`)}
      </div><p class="hint">${LANGUAGES.find(([id]) => id === chosen[0])![1]} is shown where a text or a browser has none of these.</p>${notes(field, path, editing)}</fieldset>`;
  },
};

function listField(field: Of<"list">, path: Path, value: Json | undefined, editing: Editing): TemplateResult {
  const entries = listOf(value);
  const ids = entries.map((entry) => textOf(at(entry, ["id"])));
  const add = () => editing.set(path, [...entries, field.blank(entries.length, ids)]);
  const row = (_: Json, index: number) => html`<div class=${field.inline ? "row-fields inline" : "row-fields"}>${form(field.rows, [...path, index], editing)}</div>`;
  return html`<fieldset class="field" id=${idOf(path)} tabindex="-1"><legend class="label">${field.label}</legend>
    ${sortable(entries, { word: field.one, row, change: (next) => editing.set(path, next.length || !field.optional ? next : undefined) })}
    <button class="button quiet add" type="button" @click=${add}>${icon("plus")}Add ${withArticle(field.one)}</button>${notes(field, path, editing)}</fieldset>`;
}

const withArticle = (word: string): string => `${/^[aeiou]/.test(word) ? "an" : "a"} ${word}`;

/** Texts one below the other, each in the languages of the study. */
function linesField(field: Of<"lines">, path: Path, value: Json | undefined, editing: Editing): TemplateResult {
  const entries = listOf(value);
  const line = (_: Json, index: number) => {
    const label = `${field.one.charAt(0).toUpperCase()}${field.one.slice(1)} ${index + 1}`;
    return html`<div class="row-fields inline">${form([{ type: "words", at: "", label }], [...path, index], editing)}</div>`;
  };
  return html`<fieldset class="field" id=${idOf(path)} tabindex="-1"><legend class="label">${field.label}</legend>
    ${sortable(entries, { word: field.one, row: line, change: (next) => editing.set(path, next) })}
    <button class="button quiet add" type="button" @click=${() => editing.set(path, [...entries, ""])}>${icon("plus")}Add ${withArticle(field.one)}</button>${notes(field, path, editing)}</fieldset>`;
}

function labelled(field: Field, path: Path, control: TemplateResult, editing: Editing, deep = false): TemplateResult {
  return html`<div class="field"><label for=${idOf(path)}>${field.label}</label>${control}${notes(field, path, editing, deep)}</div>`;
}

/** The hint of a field, or what is wrong with it. */
export function notes(field: { hint?: string }, path: Path, { problems }: Pick<Editing, "problems">, deep = false): TemplateResult {
  const found = problemsAt(problems, path, deep);
  return html`<div id=${`${idOf(path)}-note`} class="field-note">${found.length
    ? found.map((problem) => html`<p class="fault">${icon("warning")}<span>${said(problem, "This")} ${problem.mend ?? ""}</span></p>`)
    : field.hint ? html`<p class="hint">${field.hint}</p>` : nothing}</div>`;
}

const invalid = (path: Path, { problems }: Editing, deep = false): string => String(problemsAt(problems, path, deep).length > 0);
const valueOf = (event: Event): string => (event.target as HTMLInputElement).value;
const orLeftOut = (field: Field, value: Json): Json | undefined => (field.optional && value === "" ? undefined : value);

function localTime(iso: string): string {
  if (!iso) return "";
  const time = new Date(iso);
  return new Date(time.getTime() - time.getTimezoneOffset() * 60_000).toISOString().slice(0, 16);
}
