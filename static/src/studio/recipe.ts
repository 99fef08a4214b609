// A recipe as the controls see it: a list of steps that every control reads and gives back changed.
// Nothing is kept beside it, so that any recipe, whoever wrote it, can be opened and saved unharmed.

export type Json = null | boolean | number | string | Json[] | { [name: string]: Json };
export type Parameters = { [name: string]: Json };

export interface Step {
  operation: string;
  parameters: Parameters;
}

export type Steps = readonly Step[];

export interface GridPoint {
  /** 0 shorter, 1 as it is, 2 longer. */
  path: number;
  /** 0 even speed, 1 as it is, 2 pauses and bursts. */
  timing: number;
}

export interface Band {
  frequency: number;
  gain: number;
}

export const GRID = "grid@1";
export const POSTURE = "posture@1";
export const BANDS = "bands@1";
/** Puts the motion onto another body, on which the stage's figure cannot stand. */
export const RETARGET = "retarget@1";
/** Mixes the motions of an authoring space. */
export const BLEND = "blend@1";
export const NEUTRAL_POINT: GridPoint = { path: 1, timing: 1 };

/** What a recipe without such a step is given where it belongs: first what moves, then when, then feet. */
const ORDER = [
  "cut", "resample", "emotion", "fourier", "path_length", "bands", "grid", "posture", "waveshape",
  "warp", "vary", "timing", "contacts", "warp_time", "tempo", "repair_feet",
];

const rank = (operation: string): number => {
  const place = ORDER.indexOf(operation.split("@")[0]!);
  return place < 0 ? ORDER.length - 1 : place;
};

/** The first step of an operation. */
export const find = (steps: Steps, operation: string): Step | undefined =>
  steps.find((step) => step.operation === operation);

/** The steps with new parameters for the first step of an operation; none take it out. */
export function put(steps: Steps, operation: string, parameters: Parameters | null): Steps {
  const place = steps.findIndex((step) => step.operation === operation);
  if (place >= 0) return replaceAt(steps, place, parameters && { operation, parameters });
  return parameters ? insert(steps, { operation, parameters }) : steps;
}

/** The steps with one more, before the first that belongs behind it. */
export function insert(steps: Steps, step: Step): Steps {
  const after = steps.findIndex(({ operation }) => rank(operation) > rank(step.operation));
  const place = after < 0 ? steps.length : after;
  return [...steps.slice(0, place), step, ...steps.slice(place)];
}

export const replaceAt = (steps: Steps, place: number, step: Step | null): Steps =>
  steps.flatMap((old, index) => (index === place ? (step ? [step] : []) : [old]));

const numberOr = (value: Json | undefined, otherwise: number): number =>
  typeof value === "number" ? value : otherwise;
const listOf = (value: Json | undefined): Parameters[] =>
  Array.isArray(value) ? value.filter((item): item is Parameters => item !== null && typeof item === "object") : [];

export function gridOf(steps: Steps): GridPoint {
  const { path, timing } = find(steps, GRID)?.parameters ?? {};
  return { path: numberOr(path, 1), timing: numberOr(timing, 1) };
}

export function withGrid(steps: Steps, point: GridPoint): Steps {
  const { path, timing } = point;
  return put(steps, GRID, path === 1 && timing === 1 ? null : { path, timing });
}

/** Pose to amount. */
export function postureOf(steps: Steps): Map<string, number> {
  const offsets = listOf(find(steps, POSTURE)?.parameters.offsets);
  return new Map(offsets.map(({ pose, amount }) => [String(pose), numberOr(amount, 1)]));
}

export function withPosture(steps: Steps, pose: string, amount: number): Steps {
  const offsets = listOf(find(steps, POSTURE)?.parameters.offsets);
  const known = offsets.some((offset) => offset.pose === pose);
  const changed = known
    ? offsets.map((offset) => (offset.pose === pose ? { ...offset, amount } : offset))
    : [...offsets, { pose, neutral: "neutral", amount }];
  const left = changed.filter((offset) => offset.amount !== 0);
  return put(steps, POSTURE, left.length ? { offsets: left } : null);
}

export function bandsOf(steps: Steps): Band[] {
  const gains = listOf(find(steps, BANDS)?.parameters.gains);
  return gains.map(({ frequency, gain }) => ({
    frequency: numberOr(frequency, 0),
    gain: numberOr(gain, 1),
  }));
}

/** The equaliser's bands: those of the recipe, or the usual ones where it has none. */
export function allBands(steps: Steps, usual: readonly number[]): Band[] {
  const own = bandsOf(steps);
  if (!own.length) return usual.map((frequency) => ({ frequency, gain: 1 }));
  return own.sort((one, other) => one.frequency - other.frequency);
}

/** Every band is written, for between two of them the gain is on a straight line. */
export function withBands(steps: Steps, bands: readonly Band[]): Steps {
  if (bands.every(({ gain }) => gain === 1)) return put(steps, BANDS, null);
  return put(steps, BANDS, { gains: bands.map(({ frequency, gain }) => ({ frequency, gain })) });
}

/** The clips that a mix is made of; null for a motion that is none. */
export function mixedOf(steps: Steps): string[] | null {
  const mix = find(steps, BLEND);
  return mix ? listOf(mix.parameters.examples).map(({ clip }) => String(clip)) : null;
}

/** Steps without a control of their own, each with its place: a second grid among them. */
export function extrasOf(steps: Steps): { step: Step; place: number }[] {
  const own = [GRID, POSTURE, BANDS].map((operation) => steps.findIndex((step) => step.operation === operation));
  return steps.flatMap((step, place) => (own.includes(place) ? [] : [{ step, place }]));
}

/** The same text for the same recipe, however its members are ordered. */
export const textOf = (value: unknown): string => JSON.stringify(value, sorted);

const sorted = (_: string, value: unknown): unknown =>
  value && typeof value === "object" && !Array.isArray(value)
    ? Object.fromEntries(Object.entries(value).sort(([one], [other]) => (one < other ? -1 : 1)))
    : value;

export const same = (one: unknown, other: unknown): boolean => textOf(one) === textOf(other);

/** A value as fine as a control sets it, free of rounding's tails. */
export const rounded = (value: number, step = 0.01): number => Number((Math.round(value / step) * step).toFixed(4));
export const clamped = (value: number, low: number, high: number): number => Math.min(Math.max(value, low), high);
