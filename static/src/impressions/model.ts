// An adjective part's analysis as numbers and words. No DOM in here.
import type { components } from "../api-types";

type Schemas = components["schemas"];
export type Impressions = Schemas["Impressions"];
export type Choices = Impressions["choices"];
export type Pair = Schemas["Pair"];
export type Cluster = Schemas["Cluster"];
export type Merge = Schemas["Merge"];
export type Stability = Schemas["Stability"];
export type Comparison = Schemas["Comparison"];
export type Comparable = Schemas["Comparable"];
export type Job = Schemas["JobDetail"];
export type SpaceLine = Schemas["SpaceLine"];
type Words = Pair["left"];

/** What a slider or the cut changes; each is one number. */
export type Limits = Pick<Choices, "least_peak" | "most_spread" | "clusters">;
export const limitsOf = ({ least_peak, most_spread, clusters }: Limits): Limits => ({ least_peak, most_spread, clusters });
export const sameLimits = (one: Limits, other: Limits): boolean =>
  one.least_peak === other.least_peak && one.most_spread === other.most_spread && one.clusters === other.clusters;

/** A text of the study, in English where it has that, or else in the language that stands first. */
export const textOf = (words: Words): string =>
  typeof words === "string" ? words : words.en ?? Object.values(words)[0] ?? "";

export const pairWords = ({ left, right }: Pick<Pair, "left" | "right">): string => `${textOf(left)} – ${textOf(right)}`;

/** `.62`, as style guides write what cannot pass 1; nothing known is a dash. */
export const share = (value: number | null | undefined): string =>
  value === null || value === undefined ? "–" : value.toFixed(2).replace(/^(-?)0(?=\.)/, (_, minus) => (minus ? "−" : ""));

/** Where a number from 0 to 1 lies on a ramp of five colours: which gap, and how far into it (0 … 1). */
export function shade(value: number): { gap: number; into: number } {
  const at = Math.min(Math.max(value, 0), 1) * 4;
  const gap = Math.min(Math.floor(at), 3);
  return { gap, into: at - gap };
}

/** Group colours are four; more clusters begin with the first again, and their words tell them apart. */
export const groupOf = (cluster: number | null | undefined): number =>
  cluster === null || cluster === undefined ? 5 : (cluster % 4) + 1;

/** Why a pair is left out, in a few words: its numbers stand beside them. */
export function reasons({ peak, spread, dropped }: Pair, { least_peak, most_spread }: Choices): string | null {
  if (!dropped) return null;
  const found = [
    ...(peak !== null && peak < least_peak! ? ["no clip stands out"] : []),
    ...(spread !== null && spread > most_spread! ? ["people disagree"] : []),
  ];
  return found.join(", ") || dropped;
}

/** What a comparison is called in the menu: a study's name, with the part where it has several. */
export function comparableName({ slug, title, part }: Comparable, all: readonly Comparable[]): string {
  const several = all.filter((one) => one.slug === slug).length > 1;
  return several ? `${title} · ${part.replaceAll("_", " ")}` : title;
}

/** Units stay with their numbers: a line never breaks before the sign. */
export const together = (sentence: string): string => sentence.replaceAll(" %", "\u00a0%");

export interface Span {
  cluster: number;
  from: number;
  length: number;
}

/** Neighbours of one cluster, taken together. */
export function spans(clusters: readonly number[]): Span[] {
  const found: Span[] = [];
  clusters.forEach((cluster, place) => {
    const last = found.at(-1);
    if (last?.cluster === cluster) last.length += 1;
    else found.push({ cluster, from: place, length: 1 });
  });
  return found;
}

/** The cluster of every kept pair as they stand under the tree. */
export function clustersOfLeaves({ leaves, pairs }: Pick<Impressions, "leaves" | "pairs">): number[] {
  const of = new Map(pairs.map(({ id, cluster }) => [id, cluster ?? 0]));
  return leaves.map((id) => of.get(id) ?? 0);
}

/** The ends of the scales that thresholds move on: no mean lies beyond the outermost step, and every spread has room. */
export function reaches({ pairs, reach }: Pick<Impressions, "pairs" | "reach">): { peak: number; spread: number } {
  const widest = Math.max(...pairs.map(({ spread }) => spread ?? 0));
  return { peak: reach, spread: Math.max(0.75 * reach, Math.ceil(widest * 4) / 4) };
}

/** What was decided by hand. The server tells what is in force; what the present cut has no place for is remembered here. */
export interface Decided {
  names: Record<string, string>;
  moved: Record<string, string>;
}

export function remembered(before: Decided, { names = {}, moved = {} }: Choices): Decided {
  const taken = new Set(Object.values(names).map((name) => name.toLowerCase()));
  const older = Object.entries(before.names).filter(([, name]) => !taken.has(name.toLowerCase()));
  return { names: { ...Object.fromEntries(older), ...names }, moved: { ...before.moved, ...moved } };
}

const NUMBERS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"];
/** `four clusters`. */
export const counted = (count: number, one: string): string => `${NUMBERS[count] ?? count} ${one}${count === 1 ? "" : "s"}`;
