// What a match needs of an authoring space: which one, and targets drawn in it.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api, ApiError } from "../api";
import type { components } from "../api-types";
import { icon } from "../icons";
import { spaces as listed } from "../space/server";
import { clipsField } from "./clips";
import type { Field } from "./fields";
import { idOf, notes, type Editing } from "./form";
import { at, listOf, textOf, type Json, type Path } from "./model";

type Schemas = components["schemas"];
type Space = Schemas["SpaceLine"];

/** Loaded once for all fields of the page. */
let known: Promise<Space[]> | null = null;

async function spaces(): Promise<Space[]> {
  try {
    known ??= listed();
    return await known;
  } catch (error) {
    known = null;
    throw error;
  }
}

/** The id of the newest space of this name; an id stays what it is. */
export async function newestOf(called: string): Promise<string> {
  const found = (await spaces()).find(({ id, name, newest }) => id === called || (newest && name === called));
  return found?.id ?? called;
}

/** What the space of this id is called: a published study names it by the id alone. A name stays what it is. */
export async function calledOf(space: string): Promise<string> {
  const found = (await spaces()).find(({ id }) => id === space);
  return found ? `${found.name}, version ${found.number}` : space;
}

export function spaceField(field: Extract<Field, { type: "space" }>, path: Path, value: Json | undefined, editing: Editing): TemplateResult {
  const choose = ({ detail }: CustomEvent<string>) => editing.set(path, detail);
  return html`<div class="field"><label for=${idOf(path)}>${field.label}</label>
    <space-choice control=${idOf(path)} value=${textOf(value)} @choose=${choose}></space-choice>${notes(field, path, editing)}</div>`;
}

/** Stimuli that are drawn at random points of the task's space, or taken from the library. */
export function targetsField(field: Extract<Field, { type: "targets" }>, path: Path, value: Json | undefined, editing: Editing): TemplateResult {
  const space = textOf(at(editing.study, [...path.slice(0, 2), "task", "space"]));
  const { count, seed, word } = field;
  const drawn = ({ detail }: CustomEvent<Json>) => editing.set(path, detail);
  return html`${clipsField({ ...field, type: "clips" }, path, value, editing)}
    <target-drawer .space=${space} .count=${listOf(value).length || count} .seed=${seed} .word=${word} @draw=${drawn}></target-drawer>`;
}

const saidOf = (error: unknown): string => {
  if (!(error instanceof ApiError)) throw error;
  return [error.message, error.mend].filter(Boolean).join(" ");
};

@customElement("space-choice")
export class SpaceChoice extends LitElement {
  @property() value = "";
  /** The id of the control, which its label and its problems name. */
  @property() control = "";
  @state() private spaces: readonly Space[] = [];
  @state() private fault = "";

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    void spaces().then((found) => (this.spaces = found), (error: unknown) => (this.fault = saidOf(error)));
  }

  protected override render(): TemplateResult {
    const newest = this.spaces.filter(({ newest }) => newest);
    const chosen = this.spaces.find(({ id, name, newest }) => id === this.value || (newest && name === this.value));
    const choose = (event: Event) => this.dispatchEvent(new CustomEvent("choose", { detail: (event.target as HTMLSelectElement).value }));
    const older = chosen && !chosen.newest;
    return html`<select class="input" id=${this.control} @change=${choose} aria-describedby=${`${this.control}-note`}>
      ${chosen ? nothing : html`<option value=${this.value} selected>${this.value || "Choose a space"}</option>`}
      ${older ? html`<option value=${chosen.id} selected>${chosen.name}, version ${chosen.number}</option>` : nothing}
      ${newest.map((space) => html`<option value=${space.name} ?selected=${space === chosen}>${space.name} · ${space.examples} examples</option>`)}</select>
      ${this.fault ? html`<p class="fault">${icon("warning")}<span>${this.fault}</span></p>` : nothing}`;
  }
}

@customElement("target-drawer")
export class TargetDrawer extends LitElement {
  @property({ attribute: false }) space = "";
  @property({ attribute: false }) count = 5;
  @property({ attribute: false }) seed = 1;
  /** What a target is called, before its number. */
  @property({ attribute: false }) word = "Target";
  @state() private busy = false;
  @state() private said = "";

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  private async draw(): Promise<void> {
    const [count = 5, seed = 1] = [...this.querySelectorAll("input")].map(({ valueAsNumber }) => valueAsNumber);
    this.busy = true;
    this.said = "";
    try {
      const { targets } = await api.post<Schemas["TargetList"]>(`/api/v1/spaces/${await newestOf(this.space)}/targets`, { count, seed });
      const detail = targets.map(({ values }, index) => {
        const name = `${this.word} ${index + 1}`;
        return { made: { space: this.space, values }, name, label: name };
      });
      this.dispatchEvent(new CustomEvent("draw", { detail }));
      this.said = `${targets.length} targets are drawn.`;
    } catch (error) {
      this.said = saidOf(error);
    }
    this.busy = false;
  }

  protected override render(): TemplateResult {
    return html`<div class="drawing"><label>How many <input class="input short" type="number" min="1" max="50" .value=${String(this.count)}></label>
      <label>Seed <input class="input short" type="number" min="0" .value=${String(this.seed)}></label>
      <button class="button quiet" type="button" ?disabled=${this.busy || !this.space} @click=${() => void this.draw()}>${icon("replay")}Draw targets</button></div>
      <p class="hint" role="status">${this.said || (this.space ? "Drawn at random from the adjectives, far from each other. The same seed draws the same ones." : "Choose a space first.")}</p>`;
  }
}
