// The three faces of a step: a stage beside a panel, a cell for each of several figures, a page of text.

import { html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { icon } from "../icons";
import type { AnyKind } from "../trials";
import type { Step, View } from "../trials/kind";
import { LONGEST_TEXT } from "../trials/text";
import { t } from "../words";
import { brand } from "./brand";
import { cells } from "./cells";
import { isTrial } from "./kinds";
import type { Course } from "./course";
import { lineNote, savedMark, type Line } from "./notices";

/** Everything that a face is drawn from. */
export interface Scene {
  course: Course;
  kind: AnyKind;
  // What the kind itself is given; its parameters are its own business.
  view: View<any>;
  viewer: TemplateResult | typeof nothing;
  line: Line;
  /** Answers are taken. */
  ready: boolean;
  /** The step's files are there; the viewer does the rest. */
  fetched: boolean;
  paused: boolean;
  isSeen: (place: number) => boolean;
  unseen: number;
  back: () => void;
  next: () => void;
  togglePause: () => void;
}

export function face(scene: Scene): TemplateResult {
  const { course, line, kind } = scene;
  const body = { stage, cells: cellsFace, page }[kind.layout];
  return html`<header class="trial-bar">${brand()}${place(course)}${savedMark(line, course.answered)}</header>
    ${lineNote(line)}${body(scene)}`;
}

function place({ step, trial, trials, index, length }: Course): TemplateResult {
  const counted = step && isTrial(step);
  const noun = counted ? nounOf(step, trial) : "";
  const words = html`<span aria-live="polite"><strong>${noun}</strong> ${t("of {count}", { count: trials })}</span>`;
  return html`<div class="place">${counted ? words : nothing}
    <progress max=${length} .value=${index} aria-label=${t("Answered so far")}></progress></div>`;
}

function nounOf({ kind, figures }: Step, index: number): string {
  if (kind === "match") return t("Task {index}", { index });
  return figures.length > 1 ? t("Series {index}", { index }) : t("Clip {index}", { index });
}

function question({ view: { task, step } }: Scene): TemplateResult {
  return html`<h1>${task.question}</h1>
    ${task.hint ? html`<p class="trial-hint">${task.hint}</p>` : nothing}
    ${step.instruction ? html`<p class="instruction">${step.instruction}</p>` : nothing}`;
}

function submit(scene: Scene): (event: Event) => void {
  return (event) => {
    event.preventDefault();
    scene.next();
  };
}

function stage(scene: Scene): TemplateResult {
  const { kind, view, viewer } = scene;
  return html`<main class="trial-body ${view.step.reference ? "pair" : ""}" id="content" tabindex="-1">
    <section class="stage" aria-label=${t("The clip")}>${viewer}</section>
    <form class="panel" novalidate @submit=${submit(scene)}>
      <div class="panel-scroll">${question(scene)}${kind.panel(view)}${comment(view)}</div>
      ${footer(scene, nothing)}
    </form>
  </main>`;
}

function cellsFace(scene: Scene): TemplateResult {
  const { kind, view, paused } = scene;
  return html`<main class="cells-body" id="content" tabindex="-1">
    <form class="whole" novalidate @submit=${submit(scene)}>
      <div class="cells-scroll">
        <div class="cells-head"><div>${question(scene)}</div>
          <button class="button pause" type="button" @click=${scene.togglePause}>${icon(paused ? "play" : "pause")}
            <span>${paused ? t("Play all") : t("Pause all")}</span></button></div>
        ${grid(scene, true)}
        ${comment(view)}
      </div>
      ${footer(scene, html`<div class="cells-foot">${kind.panel(view)}${unseenNote(scene)}</div>`)}
    </form>
  </main>`;
}

function grid({ kind, view, viewer, isSeen }: Scene, says: boolean): TemplateResult {
  const parts = view.step.figures.map((_, place) => kind.cell?.(view, place) ?? { head: "" });
  return cells({ parts, viewer, seen: isSeen, says });
}

function unseenNote({ unseen, ready }: Scene): TemplateResult | typeof nothing {
  if (!ready || unseen === 0) return nothing;
  return html`<span class="unseen">${unseen === 1 ? t("One is not yet seen.") : t("{n} are not yet seen.", { n: unseen })}</span>`;
}

function page(scene: Scene): TemplateResult {
  const { kind, view } = scene;
  return html`<main class="page-body" id="content" tabindex="-1">
    <form class="whole" novalidate @submit=${submit(scene)}>
      <div class="page-scroll"><div class="page-text">${kind.panel(view)}
        ${view.step.figures.length ? grid(scene, false) : nothing}</div></div>
      ${footer(scene, nothing)}
    </form>
  </main>`;
}

/** The box below a trial. */
function comment({ task, form, change }: View<any>): TemplateResult | typeof nothing {
  if (!task.comment) return nothing;
  const { label, placeholder } = task.comment;
  const input = ({ target }: InputEvent) => {
    const { value } = target as HTMLTextAreaElement;
    change((now) => ({ ...now, comment: value }));
  };
  return html`<label class="field comment"><span><strong>${label}</strong> ${t("Optional")}</span>
    <textarea class="input" rows="1" maxlength=${LONGEST_TEXT} placeholder=${placeholder ?? nothing}
      .value=${live(form.comment)} @input=${input}></textarea></label>`;
}

/** Both buttons rest until the figures are shown; while they are still being fetched, Next also looks it. */
function footer(scene: Scene, between: TemplateResult | typeof nothing): TemplateResult {
  const { course, kind, view, ready, fetched } = scene;
  const left = kind.remaining(view, view.form);
  return html`<footer class="panel-footer ${fetched && left === null ? "resting" : ""}">
    <button class="button quiet back" type="button" ?hidden=${course.before === null} ?disabled=${!ready} @click=${scene.back}>
      ${icon("back")} ${t("Back")}</button>${between}
    <button class="button primary next" type="submit" ?disabled=${!ready || left !== null} @click=${firstOnly}>
      ${left ?? html`${onward(scene)} ${icon("arrow")}`}</button>
  </footer>`;
}

function onward({ course, kind, view }: Scene): string {
  const { index, length, session } = course;
  if (index + 1 >= length) return t("Finish");
  if (kind.onward) return kind.onward();
  const next = session.steps[index + 1];
  const alike = next && next.kind === view.step.kind && kind.layout === "stage";
  return alike ? t("Next clip") : t("Continue");
}

/**
 * The second click of a double click answers nothing. A busy device may deliver it long after the first, when the next
 * clip is already there; the browser still knows that the two belong together.
 */
function firstOnly(event: MouseEvent): void {
  if (event.detail > 1) event.preventDefault();
}
