// One clip being edited: its recipe with what was before, the motion on the stage, its checks, what is saved.
import { ApiError, api } from "../api";
import { dropDraft, findDraft, keepDraft } from "./draft";
import { History } from "./history";
import { freeName } from "./names";
import { same, textOf, withGrid, type Steps } from "./recipe";
import * as server from "./server";
import { AGAIN_AFTER, Staging, type Show } from "./staging";

export interface Edit {
  steps: Steps;
  /** The preset that the edit began with. */
  preset: string | null;
}

/** Motions kept, so that undo and redo need no server. */
const KEPT = 12;

export class Session extends Staging<Edit> {
  readonly history: History<Edit>;
  name: string;
  /** What the variants of this clip are called. */
  names: readonly string[] = [];
  saved: { id: string; name: string; steps: Steps };
  checked: server.Checked | null = null;
  /** The checks are those of an earlier recipe. */
  checking = false;
  /** A draft of an earlier visit is what is shown. */
  fromDraft = false;
  private readonly motions = new Map<string, Promise<ArrayBuffer>>();
  constructor(
    readonly source: server.Clip,
    opened: server.ClipDetail,
    private readonly stage: Show,
    changed: () => void,
  ) {
    super(changed);
    const steps = server.stepsOf(opened.provenance?.recipe ?? []);
    this.saved = { id: opened.id, name: opened.name, steps };
    this.name = steps.length ? opened.name : "";
    const draft = findDraft(opened.id);
    this.fromDraft = draft !== null && !same(draft.steps, steps);
    if (draft && this.fromDraft) this.name = draft.name;
    this.history = new History<Edit>(draft && this.fromDraft ? draft : { steps, preset: null });
  }

  get steps(): Steps {
    return this.history.present.steps;
  }

  get preset(): string | null {
    return this.history.present.preset;
  }

  get edited(): server.Edited {
    return { source: this.source.id, operations: this.steps };
  }

  /** A name to save under when nobody has given one. */
  get suggestedName(): string {
    return this.steps.length ? `${this.source.name} ${this.preset?.replaceAll("_", " ") ?? "edited"}` : this.source.name;
  }

  protected override get wish(): Edit {
    return this.history.present;
  }

  get isSaved(): boolean {
    const named = !this.steps.length || !this.name || this.name === this.saved.name;
    return same(this.steps, this.saved.steps) && named;
  }

  /** The first motion and the first checks. A fresh stage shows the source as it is. */
  begin(fresh: boolean): void {
    if (this.steps.length || !fresh) this.shows.ask(this.history.present);
    else this.shown = this.history.present;
    this.checking = true;
    this.checkSoon(this.history.present);
    this.changed();
    // The nine motions are made once for a clip; the first drag shall not wait for them.
    void server.preview({ source: this.source.id, operations: withGrid([], { path: 1.5, timing: 1.5 }) }).catch(() => {});
  }

  change(steps: Steps, control: string, preset = this.preset): void {
    this.history.set({ steps, preset }, control);
    this.refresh();
  }

  call(name: string): void {
    this.name = name;
    this.keep();
    this.changed();
  }

  /** Throw the draft away and stand where the saved clip stands. */
  startOver(): void {
    this.fromDraft = false;
    this.name = this.saved.steps.length ? this.saved.name : "";
    this.change(this.saved.steps, "start over", null);
  }

  /** Keep the variant on the server; a source without edits is there already. */
  async save(): Promise<string> {
    if (!this.steps.length) return this.source.id;
    const { steps } = this;
    const wanted = this.name || this.suggestedName;
    const name = same(steps, this.saved.steps) ? wanted : freeName(wanted, this.names);
    const clip = await server.save({ source: this.source.id, operations: steps }, name);
    const named = [name, wanted].includes(clip.name) ? clip : await server.rename(clip.id, name);
    dropDraft(this.saved.id);
    this.saved = { id: named.id, name: named.name, steps };
    this.name = named.name;
    this.fromDraft = false;
    this.keep();
    this.changed();
    return named.id;
  }

  /** Lower the edit until its checks are clean; tells to which share. */
  async easeOff(): Promise<number> {
    const { operations, share } = await server.easeOff(this.edited);
    this.change(server.stepsOf(operations), "ease off");
    return share;
  }

  /** The place among the steps of the one that the server could not do. */
  get faultyStep(): number | null {
    const step = this.problem?.where?.step;
    return typeof step === "number" ? step - 1 : null;
  }

  protected override refresh(): void {
    const { present } = this.history;
    this.keep();
    this.shows.ask(present);
    this.checking = true;
    this.checkSoon(present);
    this.changed();
  }

  private keep(): void {
    if (this.isSaved) dropDraft(this.saved.id);
    else keepDraft(this.saved.id, { ...this.history.present, name: this.name });
  }

  protected override async put({ steps }: Edit, askedAt: number): Promise<void> {
    this.stage(await this.motionOf(steps), askedAt);
  }

  private motionOf(steps: Steps): Promise<ArrayBuffer> {
    const key = textOf(steps);
    const known = this.motions.get(key);
    if (known) return known;
    const motion = steps.length ? server.preview({ source: this.source.id, operations: steps }) : api.bytes(this.source.glb_url);
    this.motions.set(key, motion);
    motion.catch(() => this.motions.delete(key));
    const [oldest] = this.motions.keys();
    if (this.motions.size > KEPT && oldest !== undefined) this.motions.delete(oldest);
    return motion;
  }

  private checkLater(edit: Edit): void {
    setTimeout(() => edit === this.history.present && this.checks.ask(edit), AGAIN_AFTER);
  }

  protected override async check(edit: Edit): Promise<void> {
    try {
      const checked = await server.check({ source: this.source.id, operations: edit.steps });
      if (edit !== this.history.present) return;
      this.checked = checked;
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      // The stage says what is wrong with the recipe; checks of the one before would mislead.
      this.checked = null;
      if (error.transient && edit === this.history.present) return this.checkLater(edit);
    }
    this.checking = false;
    this.changed();
  }
}

export { asApiError } from "./staging";
