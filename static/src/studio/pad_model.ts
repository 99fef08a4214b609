// The pad of path length and timing: nine motions, and how much of each a point takes. No DOM in here.
import { clamped, rounded, type GridPoint } from "./recipe";

export interface GridMotion extends GridPoint {
  /** Share of the motion shown; the nine add up to 1. */
  weight: number;
}

const LINES = [0, 1, 2];
const hat = (position: number, line: number): number => Math.max(0, 1 - Math.abs(position - line));

/** The nine motions, the four around the point with a weight above 0. */
export function nineMotions({ path, timing }: GridPoint): GridMotion[] {
  return LINES.flatMap((row) =>
    LINES.map((column) => ({
      path: column,
      timing: row,
      weight: hat(path, column) * hat(timing, row),
    })),
  );
}

export function inReach({ path, timing }: GridPoint): GridPoint {
  return { path: rounded(clamped(path, 0, 2)), timing: rounded(clamped(timing, 0, 2)) };
}

export const pathWord = (path: number): string =>
  path < 1 ? "shorter" : path > 1 ? "longer" : "as it is";
export const timingWord = (timing: number): string =>
  timing < 1 ? "even" : timing > 1 ? "pauses" : "as it is";

/** "path 0.55, shorter; timing 1.62, pauses". */
export const pointWords = ({ path, timing }: GridPoint): string =>
  `path ${path.toFixed(2)}, ${pathWord(path)}; timing ${timing.toFixed(2)}, ${timingWord(timing)}`;

const STEPS: Record<string, [path: number, timing: number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Where an arrow key leads from a point; null for any other key. */
export function stepped(point: GridPoint, key: string, far: boolean): GridPoint | null {
  const step = STEPS[key];
  if (!step) return null;
  const size = far ? 0.25 : 0.05;
  return inReach({ path: point.path + step[0] * size, timing: point.timing + step[1] * size });
}
