// What a match is about: sliders, where they stand, the way they went, and when they rest.

import type { Asked, Figure, Form } from "../kind";
import { gapOf, withMove } from "./path";

export interface MatchSlider {
  id: string;
  title: string;
  left: string;
  right: string;
}

/** What a study sets, and what its space brings. */
export interface Parameters {
  seconds: number;
  threshold: number;
  /** Where every slider stands at first. */
  start: number;
  sliders: Readonly<Record<string, readonly MatchSlider[]>>;
  example_figures: readonly Figure[];
}

export type Positions = Record<string, number>;

export const slidersOf = ({ task, step }: Asked<Parameters>): readonly MatchSlider[] => task.sliders[step.interface ?? ""] ?? [];

/** Where all sliders of the step stand. */
export function positions(asked: Asked<Parameters>, { answers }: Form): Positions {
  return Object.fromEntries(slidersOf(asked).map(({ id }) => [id, Number(answers[id] ?? asked.task.start)]));
}

/** The form after a slider was moved, so many milliseconds after the figures came. */
export function moved(asked: Asked<Parameters>, form: Form, id: string, position: number, ms: number): Form {
  const path = withMove(form.trace?.path ?? [], [ms, id, position], gapOf(1000 * asked.task.seconds));
  const touched = form.touched.includes(id) ? form.touched : [...form.touched, id];
  const seconds = asked.step.seen ? {} : { seconds: inSeconds(ms) };
  const answers = { ...positions(asked, form), [id]: position, ...seconds };
  return { ...form, answers, touched, trace: { ms, path } };
}

/** The form once the clock has stopped, with the sliders where they were when it did. */
export function ended(asked: Asked<Parameters>, form: Form, stood: Positions, ms: number): Form {
  const strayed = Object.entries(stood).filter(([id, position]) => positions(asked, form)[id] !== position);
  const back = strayed.reduce((now, [id, position]) => moved(asked, now, id, position, ms), form);
  const path = back.trace?.path ?? [];
  return { ...back, answers: { ...stood, seconds: inSeconds(Math.min(ms, 1000 * asked.task.seconds)) }, trace: { ms, path } };
}

/** Whether the sliders rest: the clock has stopped, or a guess was handed in before. */
export function rests({ step }: Asked<Parameters>, { answers, trace }: Form): boolean {
  return answers["seconds"] !== undefined && (step.seen === true || trace === undefined);
}

export const inSeconds = (ms: number): number => Math.round(ms) / 1000;
