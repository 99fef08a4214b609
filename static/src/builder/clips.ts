// Clips of the library in the forms: one of them, or a part's stimuli with their stills.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import type { Clip } from "../library/model";
import type { Field } from "./fields";
import { idOf, notes, type Editing } from "./form";
import { at, listOf, textOf, type Json, type Path } from "./model";
import { isMade } from "./stimulus";

const FIRST = 6;

/** What is known of a stimulus: the clip of the library, if it is there, and a name for people. */
export interface Shown {
  clip: Clip | undefined;
  name: string;
}

export function shownOf(stimulus: Json | undefined, clips: readonly Clip[]): Shown {
  const made = at(stimulus, ["made"]);
  const reference = textOf(stimulus) || textOf(at(stimulus, ["clip"])) || textOf(at(made, ["source"]));
  const clip = clips.find(({ id, name }) => id === reference || name === reference);
  const called = textOf(at(stimulus, ["name"])) || clip?.name || reference.slice(0, 40);
  if (at(made, ["space"])) return { clip, name: called || `a motion of ${textOf(at(made, ["space"]))}` };
  const how = textOf(at(made, ["preset"])).replaceAll("_", " ") || "edited";
  return { clip, name: isMade(stimulus) ? `${called} · ${how}` : called };
}

export function clipField(field: Extract<Field, { type: "clip" }>, path: Path, value: Json | undefined, editing: Editing): TemplateResult {
  const choose = () => editing.pick(false, ([id]) => editing.set(path, id));
  const shown = value ? shownOf(value, editing.clips) : null;
  return html`<div class="field"><span class="label" id=${`${idOf(path)}-label`}>${field.label}</span>
    <div class="one-clip">${shown ? html`${still(shown.clip)}<span>${shown.name}</span>` : nothing}
      <button class="button quiet" type="button" id=${idOf(path)} aria-describedby=${`${idOf(path)}-label`} @click=${choose}>${shown ? "Change" : "Choose a clip"}</button>
      ${shown && field.optional ? html`<button class="button quiet icon-button" type="button" aria-label="Remove the clip" @click=${() => editing.set(path, undefined)}>${icon("close")}</button>` : nothing}</div>
    ${notes(field, path, editing)}</div>`;
}

export function clipsField(field: Extract<Field, { type: "clips" }>, path: Path, value: Json | undefined, editing: Editing): TemplateResult {
  const stimuli = listOf(value);
  const shown = editing.allClips ? stimuli : stimuli.slice(0, stimuli.length === FIRST + 1 ? FIRST + 1 : FIRST);
  const add = () => editing.pick(true, (ids) => {
    const there = stimuli.map((one) => shownOf(one, editing.clips).clip?.id);
    editing.set(path, [...stimuli, ...ids.filter((id) => !there.includes(id)).map((clip) => ({ clip }))]);
  });
  const more = stimuli.length - shown.length;
  return html`<fieldset class="field" id=${idOf(path)} tabindex="-1"><legend class="label">${field.label} ${stimuli.length ? html`<span class="quiet">· ${stimuli.length}</span>` : nothing}</legend>
    <ul class="stimuli">${shown.map((one, index) => stimulus(one, [...path, index], editing))}
      ${more > 0 ? html`<li><button class="more" type="button" aria-label=${`Show ${more} more clips`} @click=${editing.showAllClips}>+ ${more}</button></li>` : nothing}</ul>
    <div class="buttons"><button class="button quiet add" type="button" @click=${add}>${icon("plus")}Add clips</button>
      ${stimuli.length > 1 && editing.allClips ? html`<button class="button quiet" type="button" @click=${() => editing.set(path, [])}>Remove all</button>` : nothing}</div>
    ${notes(field, path, editing)}</fieldset>`;
}

function stimulus(value: Json, path: Path, editing: Editing): TemplateResult {
  const { clip, name } = shownOf(value, editing.clips);
  const faulty = editing.problems.some(({ where }) => path.every((step, index) => where[index] === step));
  return html`<li class=${faulty ? "faulty" : ""} data-card><button class="look" type="button" aria-haspopup="dialog" aria-label=${`Look at ${name}`} @click=${() => editing.look(path)}>${still(clip)}</button>
    <span class="stimulus-name" title=${name}>${name}</span>
    <button class="remove" type="button" aria-label=${`Remove ${name}`} @click=${() => editing.set(path, undefined)}>${icon("close")}</button>
    ${faulty ? notes({}, path, { problems: editing.problems }, true) : nothing}</li>`;
}

const still = (clip: Clip | undefined): TemplateResult | typeof nothing =>
  clip?.figure_url
    ? html`<span class="still"><motion-thumbnail src=${clip.glb_url} figure=${clip.figure_url} poster-time=${clip.poster_time}></motion-thumbnail></span>`
    : html`<span class="still">${icon("play")}</span>`;
