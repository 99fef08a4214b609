// Where a person stands in the study: which trials are answered, with what, and which one comes now.

import type { components } from "../api-types";
import type { Outbox } from "../outbox";
import { blank, same, type Form } from "../trials/semantic_differential";
import { NOTHING_YET, type Attention } from "./clock";
import type { Store } from "./store";

type Schemas = components["schemas"];
/** A session as the server tells it. */
export type Session = Schemas["SessionView"];
export type Trial = Schemas["TrialView"];
/** An answer as it is handed in. */
export type GivenAnswer = Schemas["Answer"];
/** An answer that is known here. */
export type StoredAnswer = Schemas["ResponseView"];

/** How the clip was watched; counts and milliseconds, summed over reloads within the trial. */
export interface Viewing {
  plays: number;
  viewing_ms: number;
  camera_moves: number;
  dropped_frames: number;
}

export interface Draft {
  form: Form;
  attention: Attention;
  viewing: Viewing;
}

/** What goes with the form when it is handed in. */
export type Measures = Pick<GivenAnswer, "rt_ms" | "time_elapsed_ms" | "client_time" | "record">;

export const UNWATCHED: Viewing = { plays: 0, viewing_ms: 0, camera_moves: 0, dropped_frames: 0 };

export class Course {
  readonly #known = new Map<number, StoredAnswer>();
  #index = 0;

  constructor(
    readonly session: Session,
    private readonly store: Store,
    private readonly outbox: Outbox<GivenAnswer>,
  ) {
    for (const [index, answer] of Object.entries(session.responses)) this.#learn(Number(index), answer);
    for (const answer of outbox.pending) this.#learn(answer.trial_index, answer);
    const place = store.get<number>("place");
    this.goTo(place === null ? this.firstOpen : Math.min(place, this.firstOpen));
  }

  /** The current trial's place, or the number of trials once all are answered. */
  get index(): number {
    return this.#index;
  }

  get length(): number {
    return this.session.trials.length;
  }

  get trial(): Trial | undefined {
    return this.session.trials[this.#index];
  }

  get answered(): number {
    return this.#known.size;
  }

  get finished(): boolean {
    return this.#index >= this.length;
  }

  /** The first trial that nobody has answered yet, or the number of trials. */
  get firstOpen(): number {
    const open = this.session.trials.find(({ index }) => !this.#known.has(index));
    return open?.index ?? this.length;
  }

  goTo(index: number): void {
    this.#index = Math.max(0, Math.min(index, this.length));
    this.store.set("place", this.#index);
  }

  /** What the current trial shows at first: the draft of before a reload, else the answer given, else the preselection. */
  draft(): Draft {
    const kept = this.store.get<Draft>(`draft/${this.#index}`);
    return kept ?? { form: this.#given(), attention: NOTHING_YET, viewing: UNWATCHED };
  }

  keepDraft(draft: Draft): void {
    this.store.set(`draft/${this.#index}`, draft);
  }

  /** Hand in the current trial and go on. Going back and changing nothing hands nothing in. */
  answer(form: Form, measures: Measures): void {
    const before = this.#known.get(this.#index);
    if (!before || !same(form, this.#given())) {
      const revision = (before?.revision ?? 0) + 1;
      const given = { trial_index: this.#index, revision, ...form, comment: form.comment.trim(), ...measures };
      this.outbox.put(given);
      this.#learn(this.#index, given);
    }
    this.store.remove(`draft/${this.#index}`);
    this.goTo(this.#index + 1);
  }

  /** The server holds another answer to this trial (given on another device): that one counts. */
  accept(index: number, stored: StoredAnswer | undefined): void {
    if (stored) this.#known.set(index, stored);
  }

  /** The server lacks these answers after all: ask for them again. */
  reopen(missing: readonly number[]): void {
    for (const index of missing) this.#known.delete(index);
    this.goTo(this.firstOpen);
  }

  #learn(index: number, answer: StoredAnswer): void {
    const { revision, answers, comment, touched } = answer;
    if ((this.#known.get(index)?.revision ?? 0) > revision) return;
    this.#known.set(index, { revision, answers, touched, comment });
  }

  #given(): Form {
    const known = this.#known.get(this.#index);
    if (!known) return blank(this.session.study);
    return { answers: { ...known.answers }, touched: [...known.touched], comment: known.comment };
  }
}
