// The way that sliders go: every move, but of one slider at most one in a while, and always where it came to rest.

import type { Move } from "../kind";

/** The server keeps so many moves. */
const MOST = 20_000;
const OFTEN_MS = 100;
/** Only a limit of more than half an hour makes the moves rarer. */
const KEPT = 10_000;

/** Between two kept moves of a slider at least, where the whole may last so long. */
export function gapOf(limitMs: number): number {
  return Math.max(OFTEN_MS, limitMs / KEPT);
}

/** The path with one move more. A move soon after another of the same slider takes that one's place. */
export function withMove(path: readonly Move[], [ms, slider, position]: Move, gap: number): Move[] {
  const last = path.at(-1);
  const at = Math.round(ms);
  const replaces = last && ((last[1] === slider && at - last[0] < gap) || path.length >= MOST);
  if (!replaces) return [...path, [at, slider, position]];
  return [...path.slice(0, -1), [last[1] === slider ? last[0] : at, slider, position]];
}
