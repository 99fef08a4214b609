// Where an author stands in a space: by adjectives, by features, or by bare weights. No DOM in here.
import type { Choosable, Cluster } from "./pair_chooser";
import type { Point, Sliders, Space } from "./server";
import { wordsIn } from "./words";

/** Slider's or example's id to its value; in the order in which they stand. */
export type Values = Readonly<Record<string, number>>;
export type Kind = "adjectives" | "features";
export type Interface = Kind | "weights";

export interface Place {
  readonly by: Interface;
  readonly adjectives: Values;
  readonly features: Values;
  /** Of every example, by its clip. */
  readonly weights: Values;
  /** Where one stood before changing from one interface to another; back there, if nothing was moved since. */
  readonly before?: Place;
}

/** One slider: a primary one or a single pair, with its place in words and every example's value. */
export interface Slider {
  id: string;
  primary: boolean;
  title: string;
  /** What is measured, of a feature. */
  about: string;
  left: string;
  right: string;
  values: readonly number[];
  /** Of a feature: what 0 and 1 stand for. */
  reach: { lowest: number; highest: number; unit: string } | null;
}

export const MIDDLE = 0.5;
/** A space without primary sliders begins with so many single ones. */
const FIRST = 4;
/** Words of a primary slider's members that stand at its ends. */
const POLES = 3;

export const rounded = (value: number): number => Math.round(value * 100) / 100;

export function slidersOf(space: Space, kind: Kind, language: string): Slider[] {
  const sliders = space.definition[kind];
  if (!sliders) return [];
  const pairs = sliders.parameters.map((one) => {
    const { lowest, highest, unit } = one;
    const reach = typeof lowest === "number" && typeof highest === "number" ? { lowest, highest, unit: unit ?? "" } : null;
    const [left, right] = [wordsIn(one.left, language), wordsIn(one.right, language)];
    const title = one.title ? wordsIn(one.title, language) : `${left}–${right}`;
    return { id: one.id, primary: false, title, about: one.about ?? "", left, right, values: one.values, reach };
  });
  const ends = (members: readonly string[], side: "left" | "right") => {
    const words = members.flatMap((id) => pairs.filter((pair) => pair.id === id).map((pair) => pair[side]));
    return [...new Set(words)].slice(0, POLES).join(language === "ja" ? "、" : ", ");
  };
  const primary = sliders.primary.map(({ id, title, members, values }) => ({
    id, primary: true, title: wordsIn(title, language), about: "", left: ends(members, "left"), right: ends(members, "right"), values, reach: null,
  }));
  return [...primary, ...pairs];
}

/** The single sliders in the order of their clusters, each cluster under its title; those without one come last. */
export function clustersOf(sliders: Sliders, all: readonly Slider[], language: string): Cluster[] {
  // A pair of words is named by its ends.
  const pairs: Choosable[] = all.filter(({ primary }) => !primary).map((one) => (one.reach ? one : { ...one, title: undefined }));
  const clusters = sliders.primary.map(({ title, members }) => ({
    title: wordsIn(title, language), pairs: members.flatMap((id) => pairs.filter((pair) => pair.id === id)),
  }));
  const taken = new Set(sliders.primary.flatMap(({ members }) => members));
  const rest = pairs.filter(({ id }) => !taken.has(id));
  return [...clusters, { title: clusters.length ? "others" : "", pairs: rest }].filter(({ pairs }) => pairs.length);
}

/** The interfaces that a space has. */
export function interfacesOf({ definition }: Space): Interface[] {
  const has = (sliders: Sliders | null | undefined) => Boolean(sliders?.parameters.length || sliders?.primary.length);
  return [...(has(definition.adjectives) ? ["adjectives" as const] : []), ...(has(definition.features) ? ["features" as const] : []), "weights"];
}

export function start(space: Space): Place {
  const { definition } = space;
  const middle = (sliders: Sliders | null | undefined): Values => {
    const primary = sliders?.primary ?? [];
    const first = primary.length ? primary : (sliders?.parameters ?? []).slice(0, FIRST);
    return Object.fromEntries(first.map(({ id }) => [id, MIDDLE]));
  };
  const even = 1 / definition.examples.length;
  return {
    by: interfacesOf(space)[0]!,
    adjectives: middle(definition.adjectives),
    features: middle(definition.features),
    weights: Object.fromEntries(definition.examples.map(({ clip }) => [clip, even])),
  };
}

/**
 * A place as it is in another version of its space: sliders that are not there any more are gone, new primary ones stand
 * in the middle, and an example that has come weighs nothing.
 */
export function carried({ before: _, ...place }: Place, space: Space): Place {
  const fresh = start(space);
  const having = (kind: Kind): Values => {
    const { primary = [], parameters = [] } = space.definition[kind] ?? {};
    const known = new Set([...primary, ...parameters].map(({ id }) => id));
    return { ...fresh[kind], ...Object.fromEntries(Object.entries(place[kind]).filter(([id]) => known.has(id))) };
  };
  const weights = Object.fromEntries(space.definition.examples.map(({ clip }) => [clip, place.weights[clip] ?? 0]));
  const by = interfacesOf(space).includes(place.by) ? place.by : fresh.by;
  return { by, adjectives: having("adjectives"), features: having("features"), weights };
}

/** The adjective sliders that another version has no longer: the names of primary ones, how many single ones. */
export function lost(before: Space, after: Space, language: string): string {
  const kept = new Set(slidersOf(after, "adjectives", language).map(({ id }) => id));
  const gone = slidersOf(before, "adjectives", language).filter(({ id }) => !kept.has(id));
  const pairs = gone.filter(({ primary }) => !primary).length;
  const words = gone.filter(({ primary }) => primary).map(({ title }) => title);
  return [...words, ...(pairs ? [pairs === 1 ? "1 pair" : `${pairs} pairs`] : [])].join(", ");
}

/** What the server is asked for. An example without weight need not be named. */
export function pointOf({ by, ...place }: Place): Point {
  const values = place[by];
  if (by !== "weights") return { interface: by, values: { ...values } };
  return { interface: by, values: Object.fromEntries(Object.entries(values).filter(([, weight]) => weight > 0)) };
}

/** The sliders that are on show, with the place changed; nothing of an earlier interface is kept. */
const having = (place: Place, values: Values): Place => {
  const { before: _, ...rest } = place;
  return { ...rest, [place.by]: values };
};

export const moved = (place: Place, changes: Values): Place => having(place, { ...place[place.by], ...changes });
export const added = (place: Place, id: string, value: number): Place => moved(place, { [id]: rounded(value) });

export function removed(place: Place, id: string): Place {
  return having(place, Object.fromEntries(Object.entries(place[place.by]).filter(([other]) => other !== id)));
}

/** Another slider where this one stood. */
export function swapped(place: Place, id: string, by: string, value: number): Place {
  const entries = Object.entries(place[place.by]);
  return having(place, Object.fromEntries(entries.map((entry) => (entry[0] === id ? [by, rounded(value)] : entry))));
}

/** An example gets this weight; the others keep their proportions, and all together stay 1. */
export function weighed(place: Place, clip: string, weight: number): Place {
  const others = Object.entries(place.weights).filter(([other]) => other !== clip);
  const sum = others.reduce((total, [, one]) => total + one, 0);
  const share = (one: number) => (sum > 0 ? (one / sum) * (1 - weight) : (1 - weight) / others.length);
  const scaled = new Map(others.map(([other, one]) => [other, share(one)]));
  const values = Object.keys(place.weights).map((id) => [id, id === clip && others.length ? weight : (scaled.get(id) ?? 1)]);
  return { ...having(place, place[place.by]), by: "weights", weights: Object.fromEntries(values) };
}

/** Where a mix of the examples lies on a slider. */
export const mixed = (values: readonly number[], weights: readonly number[]): number =>
  values.reduce((sum, value, index) => sum + value * (weights[index] ?? 0), 0);

/** Another interface, set to where the mix on the stage lies, so that the figure changes as little as it can. */
export function switched(place: Place, by: Interface, space: Space, weights: readonly number[]): Place {
  if (by === place.by) return place;
  if (place.before?.by === by) return place.before;
  const clips = space.definition.examples.map(({ clip }) => clip);
  const values = by === "weights"
    ? Object.fromEntries(clips.map((clip, index) => [clip, weights[index] ?? 0]))
    : located(place[by], space, by, (values) => mixed(values, weights));
  return { ...place, by, [by]: values, before: place };
}

/** The place of one example: its own values on the sliders on show, or all the weight. */
export function placeOfExample(place: Place, space: Space, index: number): Place {
  if (place.by !== "weights") return having(place, located(place[place.by], space, place.by, (values) => values[index] ?? MIDDLE, (value) => value));
  return having(place, Object.fromEntries(space.definition.examples.map(({ clip }, other) => [clip, other === index ? 1 : 0])));
}

/** Every slider on show in its middle; of weights, all alike. */
export function middle(place: Place): Place {
  const names = Object.keys(place[place.by]);
  const value = place.by === "weights" ? 1 / names.length : MIDDLE;
  return having(place, Object.fromEntries(names.map((name) => [name, value])));
}

function located(shown: Values, space: Space, kind: Kind, where: (values: readonly number[]) => number, fine = rounded): Values {
  const sliders = space.definition[kind];
  const known = new Map([...(sliders?.primary ?? []), ...(sliders?.parameters ?? [])].map(({ id, values }) => [id, values]));
  return Object.fromEntries(Object.keys(shown).map((id) => [id, fine(where(known.get(id) ?? []))]));
}

/** Farther than this from the middle a slider says something. */
const SAYS = 0.1;

/** "slow, happy": what the farthest sliders say, or whom a mix takes most of. */
export function nameOf(place: Place, space: Space): string {
  const { by } = place;
  if (by !== "weights") {
    const known = new Map(slidersOf(space, by, "en").map((slider) => [slider.id, slider]));
    const far = Object.entries(place[by]).filter(([, value]) => Math.abs(value - MIDDLE) > SAYS)
      .sort(([, a], [, b]) => Math.abs(b - MIDDLE) - Math.abs(a - MIDDLE));
    const words = far.slice(0, 2).map(([id, value]) => wordOf(known.get(id)!, value));
    return words.join(", ") || "in the middle";
  }
  const [clip] = Object.entries(place.weights).reduce((most, one) => (one[1] > most[1] ? one : most));
  return `mix of ${space.definition.examples.find((one) => one.clip === clip)?.name ?? "examples"}`;
}

function wordOf({ title, left, right, reach, primary }: Slider, value: number): string {
  const end = (value < MIDDLE ? left : right).split(", ")[0]!;
  // “less” and “more” say nothing without what is measured.
  return reach || (primary && ["less", "more"].includes(end)) ? `${value < MIDDLE ? "less" : "more"} ${title.toLowerCase()}` : end;
}

/** "0.42 m": a value of a feature, as it is measured. */
export function measured(value: number, { lowest, highest, unit }: NonNullable<Slider["reach"]>): string {
  const real = lowest + value * (highest - lowest);
  const digits = Math.abs(highest - lowest) >= 20 ? 0 : Math.abs(highest - lowest) >= 2 ? 1 : 2;
  return `${real.toFixed(digits).replace("-", "−")}${unit === "°" ? "°" : unit && ` ${unit}`}`;
}
