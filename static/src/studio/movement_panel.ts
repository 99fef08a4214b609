// The left panel: how it moves. Preset, posture, path and timing, frequency bands, and all else.
import { html, noChange, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import { typed } from "../typed";
import { USUAL_BANDS, type BandChange } from "./equaliser";
import { inWords, startingParameters } from "./form_model";
import { inReach } from "./pad_model";
import {
  allBands, bandsOf, BANDS, extrasOf, GRID, gridOf, insert, NEUTRAL_POINT, POSTURE, postureOf, put, replaceAt,
  RETARGET,
  withBands, withGrid, withPosture, type GridPoint,
} from "./recipe";
import { schemaForm } from "./schema_form";
import { stepsOf, type Clip, type Operation, type Pose, type Preset } from "./server";
import type { Session } from "./session";
import { amountSlider, resetButton } from "./slider";
import "./equaliser";
import "./pad";

export interface Offers {
  presets: Preset[];
  operations: Operation[];
  poses: Pose[];
  clips: Clip[];
}

export type NamedPose = Pick<Pose, "id" | "name">;

export interface MovementActs {
  capture(): void;
  forget(pose: NamedPose): void;
}

/** The rows of the thesis's table come first; the rest are what it proposes beyond. */
const ROWS = 12;
const SHORT: Record<string, string> = {
  hands_and_feet_closer: "hands, feet closer",
  hands_away_and_feet_apart: "hands, feet apart",
  elbows_away: "elbows out",
};

export function movementPanel(session: Session, offers: Offers, acts: MovementActs): TemplateResult {
  // What opened once because it is in use stays open until it is closed by hand (`noChange`).
  return html`${presets(session, offers.presets)} ${postures(session, offers.poses, acts)} ${pathAndTiming(session)}
    ${bands(session)} ${more(session, offers)}`;
}

function presets(session: Session, all: Preset[]): TemplateResult {
  const choose = ({ name, operations }: Preset) => {
    const off = session.preset === name;
    session.change(off ? [] : stepsOf(operations), `preset ${name}`, off ? null : name);
  };
  const chip = (preset: Preset) => html`<button class="chip" type="button" title=${preset.summary}
    aria-pressed=${session.preset === preset.name} @click=${() => choose(preset)}>${inWords(preset.name)}</button>`;
  return html`<section><header><h2>Preset</h2><span class="tiny">a starting point</span></header>
    <div class="chips" role="group" aria-label="Presets">${all.slice(0, ROWS).map(chip)}</div>
    ${all.length > ROWS
      ? html`<details class="proposals" ?open=${all.slice(ROWS).some(({ name }) => name === session.preset) || noChange}><summary>Further presets</summary>
          <div class="chips" role="group" aria-label="Further presets">${all.slice(ROWS).map(chip)}</div></details>`
      : nothing}
    <p class="hint" role="status">${all.find(({ name }) => name === session.preset)?.summary ?? nothing}</p></section>`;
}

function postures(session: Session, poses: Pose[], { capture, forget }: MovementActs): TemplateResult {
  const amounts = postureOf(session.steps);
  const known = poses.filter(({ id }) => id !== "neutral");
  const unknown = [...amounts.keys()].filter((id) => known.every((pose) => pose.id !== id));
  const all = [...known, ...unknown.map((id) => ({ id, name: id.slice(0, 8), stance: false }))];
  return html`<section><header><h2>Posture</h2>
      ${resetButton("all postures", amounts.size > 0, () => session.change(put(session.steps, POSTURE, null), "postures"))}</header>
    ${all.map((pose) => {
      const { id, name, stance } = pose;
      const value = amounts.get(id) ?? 0;
      const captured = !stance && !unknown.includes(id);
      return amountSlider(
        {
          label: SHORT[id] ?? (stance ? inWords(id) : name), hint: name, value, min: value < -1 ? -2 : -1, max: 2, step: 0.01, neutral: 0,
          ...(captured ? { remove: () => forget(pose) } : {}),
        },
        (amount) => session.change(withPosture(session.steps, id, amount), `posture ${id}`),
      );
    })}
    <button class="link-button" type="button" @click=${capture}>${icon("plus")}Capture pose from this frame</button></section>`;
}

function pathAndTiming(session: Session): TemplateResult {
  const point = gridOf(session.steps);
  const set = (next: GridPoint) => session.change(withGrid(session.steps, inReach(next)), "path and timing");
  const field = (axis: keyof GridPoint, label: string) => html`<input class="bare" type="number" min="0" max="2" step="0.05" aria-label=${label}
    ${typed(point[axis].toFixed(2))} @change=${(event: Event) => {
      const { valueAsNumber } = event.target as HTMLInputElement;
      if (Number.isFinite(valueAsNumber)) set({ ...point, [axis]: valueAsNumber });
    }}>`;
  return html`<section><header><h2>Path and timing</h2>
      <span class="point">${field("path", "Path length")}<span aria-hidden="true">·</span>${field("timing", "Timing")}</span>
      ${resetButton("path and timing", session.steps.some(({ operation }) => operation === GRID), () => set(NEUTRAL_POINT))}</header>
    <div class="pad-frame">
      <div class="pad-side" aria-hidden="true"><span>pauses</span><span>even</span></div>
      <path-pad .point=${point} @point=${({ detail }: CustomEvent<GridPoint>) => set(detail)}></path-pad>
      <div class="pad-foot" aria-hidden="true"><span>shorter</span><span>path</span><span>longer</span></div>
    </div></section>`;
}

function bands(session: Session): TemplateResult {
  const all = allBands(session.steps, USUAL_BANDS);
  const set = ({ detail }: CustomEvent<BandChange>) => {
    const next = all.map((band) => (band.frequency === detail.frequency ? detail : band));
    session.change(withBands(session.steps, next), `band ${detail.frequency}`);
  };
  const changed = bandsOf(session.steps).length > 0;
  return html`<details ?open=${changed || noChange}><summary><h2>Frequency bands</h2><span class="tiny">gain, by Hz</span></summary>
    <band-equaliser .bands=${all} @band=${set}></band-equaliser>
    ${changed ? html`<div class="end"><button class="link-button" type="button" @click=${() => session.change(put(session.steps, BANDS, null), "bands")}>Reset all bands</button></div>` : nothing}</details>`;
}

function more(session: Session, { operations, clips }: Offers): TemplateResult {
  const extras = extrasOf(session.steps);
  const offered = operations.filter(({ name }) => ![GRID, POSTURE, BANDS, RETARGET].includes(name));
  const add = ({ name, parameters }: Operation) =>
    session.change(insert(session.steps, { operation: name, parameters: startingParameters(parameters, session.source.id) }), `add ${name}`);
  return html`<details ?open=${extras.length > 0 || noChange}><summary><h2>More</h2><span class="tiny">tempo, limbs, contacts …</span></summary>
    ${extras.map(({ step, place }) => {
      const known = operations.find(({ name }) => name === step.operation);
      const title = known?.title ?? step.operation;
      const set = (parameters: typeof step.parameters, name: string) =>
        session.change(replaceAt(session.steps, place, { ...step, parameters }), `${step.operation} ${place} ${name}`);
      const remove = () => session.change(replaceAt(session.steps, place, null), `remove ${place}`);
      return html`<div class="extra ${place === session.faultyStep ? "faulty" : ""}" role="group" aria-label=${title}>
        <header><h3>${title}</h3><button class="link-button" type="button" aria-label="Take out ${title}" @click=${remove}>Take out</button></header>
        ${known ? schemaForm(known.parameters, step.parameters, clips, set) : html`<p class="hint">This server does not know ${step.operation}.</p>`}</div>`;
    })}
    <div class="chips" role="group" aria-label="Add">${offered.map(
      (operation) => html`<button class="chip" type="button" title=${operation.summary} @click=${() => add(operation)}>${icon("plus")}${operation.title}</button>`,
    )}</div>
    <p class="hint">Another body has another figure: <a href="/library/${session.source.id}#body">put the motion onto it first</a>, then edit it there.</p></details>`;
}
