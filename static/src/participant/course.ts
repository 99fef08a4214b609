// Where a person stands in the study: which steps are answered, with what, and which one comes now.

import type { components } from "../api-types";
import type { Outbox } from "../outbox";
import { empty, same, type Form, type Step } from "../trials/kind";
import { NOTHING_YET, type Attention } from "./clock";
import { asked, isTrial, kindOf } from "./kinds";
import { UNWATCHED, type Viewing } from "./measures";
import type { Store } from "./store";

type Schemas = components["schemas"];
/** A session as the server tells it. */
export type Session = Schemas["SessionView"];
/** An answer as it is handed in. */
export type GivenAnswer = Schemas["Answer"];
/** An answer that is known here. */
export type StoredAnswer = Schemas["ResponseView"];

export interface Draft {
  form: Form;
  attention: Attention;
  viewing: Viewing;
  /** Of several figures, how long each was in view and moving, ms. */
  figures: readonly number[];
  /** The positions that sliders showed before they were touched. */
  start: Record<string, number>;
}

/** What goes with the form when it is handed in. */
export type Measures = Pick<GivenAnswer, "rt_ms" | "time_elapsed_ms" | "client_time" | "record">;

/** Where a person was, and how many steps had an answer then. */
interface Place {
  index: number;
  answered: number;
}

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
    // A preview begins where its researcher wants to look, with nothing answered before.
    this.goTo(session.study.preview ? session.next : this.#placeBefore());
  }

  /** The current step's place, or the number of steps once all are answered. */
  get index(): number {
    return this.#index;
  }

  get length(): number {
    return this.session.steps.length;
  }

  get step(): Step | undefined {
    return this.session.steps[this.#index];
  }

  /** The number of the current trial among all trials, from 1; pages do not count. */
  get trial(): number {
    return this.session.steps.slice(0, this.#index + 1).filter(isTrial).length;
  }

  get trials(): number {
    return this.session.steps.filter(isTrial).length;
  }

  /** Where a person can go back to, or null. */
  get before(): number | null {
    return this.session.study.back && this.#index > 0 ? this.#index - 1 : null;
  }

  get answered(): number {
    return this.#known.size;
  }

  get finished(): boolean {
    return this.#index >= this.length;
  }

  /** The first step that nobody has answered yet, or the number of steps. */
  get firstOpen(): number {
    const open = this.session.steps.find(({ index }) => !this.#known.has(index));
    return open?.index ?? this.length;
  }

  goTo(index: number): void {
    this.#index = Math.max(0, Math.min(index, this.length));
    this.store.set("place", { index: this.#index, answered: this.answered } satisfies Place);
  }

  /** Where the person was before; a place from before the latest answers (the browser crashed) is none. */
  #placeBefore(): number {
    const place = this.store.get<Place>("place");
    const holds = place?.answered === this.answered;
    return holds ? Math.min(place.index, this.firstOpen) : this.firstOpen;
  }

  /** What the current step shows at first: the draft of before a reload, else the answer given, else the preselection. */
  draft(): Draft {
    const kept = this.store.get<Draft>(`draft/${this.#index}`);
    const form = this.#given();
    return kept ?? { form, attention: NOTHING_YET, viewing: UNWATCHED, figures: [], start: this.#shownBefore(form) };
  }

  keepDraft(draft: Draft): void {
    this.store.set(`draft/${this.#index}`, draft);
  }

  /** Hand in the current step and go on. Going back and changing nothing hands nothing in. */
  answer(form: Form, measures: Measures): void {
    const before = this.#known.get(this.#index);
    if (!before || !same(form, this.#given())) {
      const revision = (before?.revision ?? 0) + 1;
      const { answers, touched, comment } = form;
      const given = { trial_index: this.#index, revision, answers, touched, comment: comment.trim(), ...measures };
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
    const { revision, answers, comment = "", touched } = answer;
    if ((this.#known.get(index)?.revision ?? 0) > revision) return;
    this.#known.set(index, { revision, answers, touched, comment });
  }

  /** Sliders hide their knob until they are touched; only one that is come back to shows a position. */
  #shownBefore({ answers }: Form): Record<string, number> {
    if (!this.step || !("record.start" in kindOf(this.step).data)) return {};
    return Object.fromEntries(Object.entries(answers).filter(isNumber));
  }

  #given(): Form {
    const known = this.#known.get(this.#index);
    if (!known) return this.step ? kindOf(this.step).blank(asked(this.session, this.step)) : empty();
    return { answers: { ...known.answers } as Form["answers"], touched: [...known.touched], comment: known.comment };
  }
}

function isNumber(entry: [string, unknown]): entry is [string, number] {
  return typeof entry[1] === "number";
}
