// Where one stood in a space, kept in this browser, so that a reload loses nothing.
import { interfacesOf, type Kind, type Place, type Values } from "./model";
import type { Keytimes, Space } from "./server";

/** What undo and redo go through: the place, and the events that were moved in examples. */
export interface State {
  readonly place: Place;
  readonly keytimes: Readonly<Record<string, Keytimes>>;
}

const at = (space: string): string => `manner-space-draft:${space}`;

export function keepState(space: string, { place: { before: _, ...place }, keytimes }: State): void {
  try {
    localStorage.setItem(at(space), JSON.stringify({ place, keytimes }));
  } catch {
    // Full or forbidden: then a reload begins in the middle.
  }
}

/** Null where nothing is kept, or something that does not fit the space. */
export function findState(space: Space): State | null {
  try {
    const kept = JSON.parse(localStorage.getItem(at(space.id)) ?? "null") as State | null;
    return kept && fits(kept, space) ? kept : null;
  } catch {
    return null;
  }
}

function fits({ place, keytimes }: State, space: Space): boolean {
  const { definition } = space;
  const clips = definition.examples.map(({ clip }) => clip);
  const known = (kind: Kind) => [...(definition[kind]?.primary ?? []), ...(definition[kind]?.parameters ?? [])].map(({ id }) => id);
  const isPart = (values: Values, of: readonly string[]) =>
    Object.entries(values).every(([id, value]) => of.includes(id) && value >= 0 && value <= 1);
  return interfacesOf(space).includes(place.by)
    && isPart(place.adjectives, known("adjectives")) && isPart(place.features, known("features"))
    && isPart(place.weights, clips) && clips.every((clip) => clip in place.weights)
    && Object.keys(place[place.by]).length > 0 && Object.keys(keytimes).every((clip) => clips.includes(clip));
}
