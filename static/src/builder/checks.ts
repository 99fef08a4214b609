// The attention checks of a part: an answer that is asked for, a clip that comes again, a clip that nobody can miss.
import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { icon } from "../icons";
import type { Field } from "./fields";
import { form, idOf, notes, type Editing } from "./form";
import { at, freeName, languagesOf, listOf, objOf, textOf, wordsIn, type Json, type Obj, type Path } from "./model";

interface Asked {
  id: string;
  label: string;
}

const KINDS: Record<string, { title: string; fields: readonly Field[]; blank: Obj; range: boolean | null }> = {
  instructed: {
    title: "Says what to answer", range: false,
    fields: [{ type: "words", at: "text", label: "What it says", long: true }],
    blank: { kind: "instructed", text: "Please choose the step on the far right here.", answers: {} },
  },
  repeated: {
    title: "A clip comes again", range: null,
    fields: [
      { type: "number", at: "count", label: "How many clips come again", min: 1, max: 20 },
      { type: "number", at: "within", label: "Largest mean difference", min: 0, max: 100, step: "any", optional: true, hint: "In steps of the scale, or points of a slider. More counts as not attentive; a choice must be the same. Empty: 1 step, or 20 points." },
    ],
    blank: { kind: "repeated", count: 1 },
  },
  catch: {
    title: "A clip that nobody can miss", range: true,
    fields: [{ type: "clip", at: "stimulus", label: "Clip" }],
    blank: { kind: "catch", stimulus: "", answers: {} },
  },
};

export function checksField(field: Extract<Field, { type: "checks" }>, path: Path, value: Json | undefined, editing: Editing): TemplateResult {
  const checks = listOf(value).map(objOf);
  const part = at(editing.study, path.slice(0, -1));
  const add = (kind: string) => {
    const id = freeName(kind === "instructed" ? "instruction" : kind, checks.map((check) => textOf(check["id"])));
    editing.set(path, [...checks, { ...KINDS[kind]!.blank, id }]);
  };
  const asked = askedBy(part, editing);
  const possible = Object.entries(KINDS).filter(([, { range }]) => range === null || asked.length);
  return html`<fieldset class="field" id=${idOf(path)} tabindex="-1"><legend class="label">${field.label}</legend>
    <ul class="checks">${checks.map((check, index) => one(check, [...path, index], asked, part, editing))}</ul>
    <div class="buttons">${possible.map(([kind, { title }]) => html`<button class="button quiet add" type="button" @click=${() => add(kind)}>${icon("plus")}${title}</button>`)}</div>
    ${notes(field, path, editing)}</fieldset>`;
}

function one(check: Obj, path: Path, asked: Asked[], part: Json | undefined, editing: Editing): TemplateResult {
  const kind = KINDS[textOf(check["kind"])];
  if (!kind) return html`<li><p class="quiet">${textOf(check["kind"])}</p></li>`;
  return html`<li><header><h3>${kind.title}</h3><button class="button quiet icon-button" type="button" aria-label=${`Remove the check “${textOf(check["id"])}”`}
      @click=${() => editing.set(path, undefined)}>${icon("close")}</button></header>
    ${form(kind.fields, path, editing)}
    ${kind.range === null ? nothing : html`<fieldset class="field" id=${idOf([...path, "answers"])} tabindex="-1"><legend class="label">${kind.range ? "Answers that count as seen" : "The right answer"}</legend>
      ${asked.map((line) => answer(line, kind.range!, [...path, "answers", line.id], stepsOf(part, editing), editing))}${notes({}, [...path, "answers"], editing)}</fieldset>`}
    ${form([{ type: "text", at: "id", label: "Name in the results" }], path, editing)}</li>`;
}

/** What a scale may be answered with: nothing in particular, one step, or from one step to another. */
function answer({ label }: Asked, range: boolean, path: Path, steps: [number, string][], editing: Editing): TemplateResult {
  const given = at(editing.study, path);
  const [low, high] = Array.isArray(given) ? [given[0], given[1]] : [given, given];
  const set = (from: string, to: string) => {
    if (from === "" || to === "") editing.set(path, undefined);
    else editing.set(path, range ? [Math.min(+from, +to), Math.max(+from, +to)] : +from);
  };
  const choice = (value: Json | undefined, name: string, change: (value: string) => void) => html`<select class="input" id=${name.startsWith("From") || !range ? idOf(path) : nothing} aria-label=${`${name} ${label}`} .value=${live(String(value ?? ""))}
    @change=${(event: Event) => change((event.target as HTMLSelectElement).value)}><option value="" ?selected=${value === undefined}>any</option>
    ${steps.map(([step, word]) => html`<option value=${step} ?selected=${step === value}>${word}</option>`)}</select>`;
  return html`<div class="check-answer"><span>${label}</span>${range
    ? html`${choice(low, "From, of", (value) => set(value, value === "" ? "" : String(high ?? steps.at(-1)![0])))}<span aria-hidden="true">–</span>${choice(high, "To, of", (value) => set(value === "" ? "" : String(low ?? steps[0]![0]), value))}`
    : choice(low, "Answer to", (value) => set(value, value))}</div>`;
}

/** The scales or items of a part's task, by their words. */
function askedBy(part: Json | undefined, { study, language }: Editing): Asked[] {
  const [first] = languagesOf(study) as ["en"];
  const said = (words: Json | undefined) => wordsIn(words, language, first) || wordsIn(words, first, first);
  const scales = listOf(at(part, ["task", "scales"])).map((scale) => ({
    id: textOf(at(scale, ["id"])), label: `${said(at(scale, ["left"]))} – ${said(at(scale, ["right"]))}`,
  }));
  const items = listOf(at(part, ["task", "items"])).map((item) => ({ id: textOf(at(item, ["id"])), label: said(at(item, ["label"])) }));
  return [...scales, ...items].filter(({ id }) => id);
}

/** The steps of a part's task with their numbers, as answers hold them. */
function stepsOf(part: Json | undefined, { study, language }: Editing): [number, string][] {
  const task = at(part, ["task"]);
  const kind = textOf(at(task, ["kind"]));
  if (kind === "analogue") return Array.from({ length: 11 }, (_, index) => [index * 10, String(index * 10)]);
  const [first] = languagesOf(study) as ["en"];
  const words = listOf(at(task, ["steps"])).map((step) => wordsIn(step, language, first) || wordsIn(step, first, first));
  const lowest = kind === "semantic_differential" ? -Math.floor(words.length / 2) : kind === "likert" ? 1 : 0;
  return words.map((word, index) => [index + lowest, `${String(index + lowest).replace("-", "−")} ${word}`]);
}
