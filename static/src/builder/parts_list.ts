// The left side: the study's parts in their order, how long it takes, and what is still missing.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import { minutes, trialsOf } from "./estimate";
import { at, inWords, listOf, moved, partsOf, said, textOf, type Json, type Obj, type Path, type Problem } from "./model";
import { handle } from "./sortable";

/** What is being edited: a page that every study has, or a part by its place. */
export type Selected = "about" | "welcome" | "thanks" | number;

export interface PartsList {
  study: Json;
  problems: readonly Problem[];
  selected: Selected;
  editable: boolean;
  select(what: Selected): void;
  order(parts: Obj[]): void;
  add(): void;
  goTo(where: Path): void;
}

export function partsList(given: PartsList): TemplateResult {
  const parts = partsOf(given.study);
  const consent = textOf(at(given.study, ["consent", "version"]));
  return html`<nav class="parts" aria-label="Parts of the study">
    <div class="fixed">${entry(given, "about", "The study", "")}${entry(given, "welcome", "Welcome and consent", consent && `v${consent}`)}</div>
    <ol>${parts.map((part, index) => html`<li>${given.editable ? handle(`“${inWords(part["id"])}”`, index, parts.length, (from, to) => given.order(moved(parts, from, to))) : nothing}
      ${entry(given, index, inWords(part["id"]) || `Part ${index + 1}`, countOf(part))}</li>`)}</ol>
    <div class="fixed">${entry(given, "thanks", "Thanks and code", "")}</div>
    ${given.editable ? html`<button class="button quiet add-part" type="button" @click=${given.add}>${icon("plus")}Add a part</button>` : nothing}
    <footer><p class="label">About ${minutes(given.study)} ${minutes(given.study) === 1 ? "minute" : "minutes"}</p>${summary(parts)}${problemList(given)}</footer>
  </nav>`;
}

/** The part, or page, that a place belongs to. */
export function selectedBy([first, second]: Path): Selected {
  if (first === "parts" && typeof second === "number") return second;
  if (first === "welcome" || first === "consent") return "welcome";
  return first === "thanks" ? "thanks" : "about";
}

function entry({ problems, selected, select }: PartsList, what: Selected, name: string, count: string): TemplateResult {
  const faulty = problems.some(({ where }) => selectedBy(where) === what);
  return html`<button class="part" type="button" aria-current=${selected === what ? "true" : nothing} @click=${() => select(what)}>
    <span>${name}</span>${faulty ? html`<span class="faulty">${icon("warning")}<span class="visually-hidden">needs mending</span></span>` : nothing}
    ${count ? html`<span class="count">${count}</span>` : nothing}</button>`;
}

/** What a place is called in the list: the name of its field; a text's language says nothing there. */
function nameAt(where: Path): string {
  const names = where.filter((step) => typeof step === "string" && !["en", "fi", "ja"].includes(step));
  const name = String(names.at(-1) ?? "");
  return { left: "The left word", right: "The right word" }[name] ?? inWords(name);
}

const countOf = (part: Obj): string => {
  if (part["kind"] === "trials") return String(listOf(part["stimuli"]).length || "");
  return part["kind"] === "form" ? String(listOf(part["fields"]).length || "") : "";
};

function summary(parts: readonly Obj[]): TemplateResult {
  const trials = parts.filter(({ kind }) => kind === "trials").reduce((sum, part) => sum + trialsOf(part), 0);
  return html`<p class="small">${trials ? `${trials} ${trials === 1 ? "answer" : "answers"} about clips from each participant.` : "No clips yet."}</p>`;
}

function problemList({ problems, goTo, study }: PartsList): TemplateResult | typeof nothing {
  if (!problems.length) return nothing;
  return html`<details class="problems" open><summary>${problems.length} to mend before publishing</summary>${problemLinks(study, problems, goTo)}</details>`;
}

/** What is to be mended, each with the way to its field. */
export function problemLinks(study: Json, problems: readonly Problem[], goTo: (where: Path) => void): TemplateResult {
  const nameOf = (where: Path) => {
    const what = selectedBy(where);
    return typeof what === "number" ? inWords(at(study, ["parts", what, "id"])) : { about: "The study", welcome: "Welcome and consent", thanks: "Thanks" }[what];
  };
  return html`<ul>${problems.map((problem) => html`<li><button class="link-button" type="button" @click=${() => goTo(problem.where)}>${nameOf(problem.where)}</button> ${said(problem, nameAt(problem.where))}</li>`)}</ul>`;
}
