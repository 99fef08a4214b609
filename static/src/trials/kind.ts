// What every kind of step has in common: a trial about figures, or a page between trials.

import { html, type TemplateResult } from "lit";

export interface Figure {
  glb_url: string;
  figure_url: string | null;
  cyclic: boolean;
  caption?: string | null;
}

/** One step of a session, as the server tells it. */
export interface Step {
  index: number;
  part: string;
  kind: string;
  figures: readonly Figure[];
  reference?: Figure | null;
  /** What an attention check says to answer. */
  instruction?: string | null;
  /** Scale ids in the order in which they are shown. */
  scales?: readonly string[] | null;
  /** Which sliders make the motion that is to match, and whether it is seen. */
  interface?: string | null;
  seen?: boolean | null;
}

export type Value = number | string | string[];

/** A move of a slider: ms of the trial's own clock, the slider, its position from 0 to 1. */
export type Move = readonly [ms: number, slider: string, position: number];

/** How an answer comes about, of a kind that keeps that: all moves, and what its clock has counted. */
export interface Trace {
  ms: number;
  path: readonly Move[];
}

/** What a person has set so far. */
export interface Form {
  /** Only what is set, or was set beforehand. */
  answers: Record<string, Value>;
  /** What was set by hand; the rest was preselected. */
  touched: string[];
  comment: string;
  /** Only while the step is being answered: an answer that is come back to has none. */
  trace?: Trace;
}

/** What a step asks, and where it stands. */
export interface Asked<P> {
  task: P;
  step: Step;
}

/** Makes the form another one. It is given the newest form: several changes may come before the page is drawn again. */
export type Change = (act: (form: Form) => Form) => void;

/** A motion that sliders made, and what the server measured of it. */
export interface Made {
  glb: ArrayBuffer;
  /** Metres from the target, and whether that is near enough. */
  distance: number;
  solved: boolean;
}

/** Where the blue figure's motions come from and go to. */
export interface Workshop {
  /** Rejects with an ApiError. */
  make(step: number, values: Readonly<Record<string, number>>): Promise<Made>;
  /** Resolves with the first picture of the motion. */
  show(glb: ArrayBuffer): Promise<void>;
  /** Green behind blue, or the two side by side. */
  arrange(way: "ghost" | "beside"): void;
}

/** What a kind draws from, and whom it tells of a change. */
export interface View<P> extends Asked<P> {
  form: Form;
  change: Change;
  /** The person wanted to go on although something is missing. */
  pressed: boolean;
  /** Once the figures are there and answers are taken. */
  workshop?: Workshop | null;
}

/** What a kind of several figures puts around each of them. */
export interface CellParts {
  /** In the upper left corner: a number, a letter. */
  head: string;
  /** In the upper right corner, above the figure. */
  corner?: TemplateResult;
  foot?: TemplateResult;
  chosen?: boolean;
  /** A tap on the figure. */
  tap?: () => void;
}

export interface Kind<P> {
  /** One stage beside a panel, a cell for each figure, or a page of text. */
  layout: "stage" | "cells" | "page";
  /** What is stored, with its unit. */
  data: Readonly<Record<string, string>>;
  blank(asked: Asked<P>): Form;
  /** Whether the answer can be handed in. */
  isComplete(asked: Asked<P>, form: Form): boolean;
  /** What is left to do, as the button says it; null where the button is open all the same. */
  remaining(asked: Asked<P>, form: Form): string | null;
  /** An answer as a made-up person would give it; `random` gives numbers from 0 up to 1. */
  simulate(asked: Asked<P>, random: () => number): Form;
  /** The question's own part of the page: beside the stage, below the cells, or all of a page. */
  panel(view: View<P>): TemplateResult;
  cell?(view: View<P>, place: number): CellParts;
  /** What the button says once the answer is complete, where that is not “Next”. */
  onward?(): string;
}

export const NOTHING = html``;
export const empty = (): Form => ({ answers: {}, touched: [], comment: "" });

/** Sets an answer by hand; the form that it came from stays as it was. */
export function set(form: Form, id: string, value: Value): Form {
  const touched = form.touched.includes(id) ? form.touched : [...form.touched, id];
  return { ...form, answers: { ...form.answers, [id]: value }, touched };
}

/** Takes an answer back. */
export function unset(form: Form, id: string): Form {
  const { [id]: _, ...answers } = form.answers;
  return { ...form, answers, touched: form.touched.filter((other) => other !== id) };
}

export function same(one: Form, other: Form): boolean {
  const keys = new Set([...Object.keys(one.answers), ...Object.keys(other.answers)]);
  const equal = (key: string) => JSON.stringify(one.answers[key]) === JSON.stringify(other.answers[key]);
  return (
    one.comment.trim() === other.comment.trim() &&
    [...keys].every(equal) &&
    one.touched.length === other.touched.length
  );
}

/** The ids that have no answer yet. */
export function open(ids: readonly string[], form: Form): string[] {
  return ids.filter((id) => form.answers[id] === undefined);
}

/** A whole number from `low` to `high`, each as likely. */
export function draw(low: number, high: number, random: () => number): number {
  return low + Math.floor(random() * (high - low + 1));
}
