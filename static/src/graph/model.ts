// What a graph is to its page, and the words for it. No DOM in here.

import type { components } from "../api-types";

export type GraphView = components["schemas"]["GraphView"];
export type GraphDetail = components["schemas"]["GraphDetail"];
export type GraphTransitions = components["schemas"]["GraphTransitions"];
export type Transition = components["schemas"]["TransitionView"];
export type Key = components["schemas"]["TransitionKey"];
export type Manner = components["schemas"]["Manner"];
export type Place = components["schemas"]["Place"];
export type Piece = components["schemas"]["Piece"];

/** What a person asks for by a key or a button. */
export type Direction = "ahead" | "left" | "right" | "stop";

const SIGNS: Record<Direction, RegExp> = {
  stop: /stand|idle|stop|rest/i,
  left: /left/i,
  right: /right/i,
  ahead: /walk|run|ahead|forward|step/i,
};

/**
 * The clip that each direction means, told by the clips' names.
 *
 * A graph need not have all four. What no name tells is taken in the order of the clips, so that
 * there is always something to walk to.
 */
export function directionsOf(names: readonly string[]): Partial<Record<Direction, string>> {
  const found: Partial<Record<Direction, string>> = {};
  const free = new Set(names);
  for (const [direction, sign] of Object.entries(SIGNS) as [Direction, RegExp][]) {
    const name = [...free].find((one) => sign.test(one));
    if (!name) continue;
    found[direction] = name;
    free.delete(name);
  }
  for (const direction of ["ahead", "stop"] as const) {
    const [next] = free;
    if (found[direction] || !next) continue;
    found[direction] = next;
    free.delete(next);
  }
  return found;
}

export const keyOf = ({ source, source_frame, target, target_frame }: Key): Key => ({
  source,
  source_frame,
  target,
  target_frame,
});

export const sameKey = (one: Key, other: Key): boolean =>
  one.source === other.source &&
  one.source_frame === other.source_frame &&
  one.target === other.target &&
  one.target_frame === other.target_frame;

/** How many transitions lead from each clip to each: the arrows of the drawing. */
export interface Arrow {
  source: string;
  target: string;
  count: number;
}

export function arrowsOf(transitions: readonly Key[]): Arrow[] {
  const arrows = new Map<string, Arrow>();
  for (const { source, target } of transitions) {
    const name = JSON.stringify([source, target]);
    const arrow = arrows.get(name) ?? { source, target, count: 0 };
    arrow.count += 1;
    arrows.set(name, arrow);
  }
  return [...arrows.values()];
}

/** Where somebody begins: standing, or in the first clip that can be left. */
export function startOf(graph: GraphDetail): Place | null {
  const begins = graph.members.map(({ name }) => name).filter((name) =>
    graph.transitions.some(({ source }) => source === name),
  );
  const name = begins.find((one) => SIGNS.stop.test(one)) ?? begins[0];
  if (name === undefined) return null;
  return { clip: name, frame: 0, turn: 0, x: 0, z: 0, manner: neutral() };
}

export const neutral = (): Manner => ({ path: 1, timing: 1, postures: {} });

/** "turn_left" as a person says it. */
export const clipWords = (name: string): string => name.replaceAll("_", " ");
export const centimetres = (metres: number): string => `${(100 * metres).toFixed(1)} cm`;
export const degrees = (radians: number): string => {
  const rounded = Math.round((radians * 180) / Math.PI);
  return `${rounded < 0 ? "−" : ""}${Math.abs(rounded)}°`;
};
export const seconds = (frames: number, frameTime: number): string =>
  `${(frames * frameTime).toFixed(2)} s`;
