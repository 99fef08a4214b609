// Where moments lie on the strip, and which of them the ruler names. No DOM in here.

/** Seconds. */
export interface Range {
  start: number;
  end: number;
}

export interface Tick {
  time: number;
  /** Null for the short ones between. */
  label: string | null;
}

/** Seconds between two labels. */
const STEPS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600];
/** Pixels that a label needs at least. */
const LABEL = 80;

/** Percent of the strip's width. */
export const placeOf = (time: number, duration: number): number =>
  duration > 0 ? (100 * Math.min(Math.max(time, 0), duration)) / duration : 0;

/** A moment on the nearest frame within the motion. */
export function onFrame(time: number, duration: number, frames: number): number {
  const frameTime = frames > 1 ? duration / (frames - 1) : duration;
  const nearest = frameTime > 0 ? Math.round(time / frameTime) * frameTime : 0;
  return Math.min(Math.max(nearest, 0), duration);
}

export const frameOf = (time: number, duration: number, frames: number): number =>
  duration > 0 ? Math.round((time / duration) * (frames - 1)) : 0;

export function ticks(duration: number, width: number): Tick[] {
  if (duration <= 0 || width <= 0) return [];
  const step = STEPS.find((one) => (one * width) / duration >= LABEL) ?? STEPS.at(-1)!;
  const digits = step < 1 ? 1 : 0;
  const count = Math.floor((2 * duration) / step + 1e-9);
  return Array.from({ length: count + 1 }, (_, half) => {
    const time = (half * step) / 2;
    return { time, label: half % 2 ? null : `${time.toFixed(digits)} s` };
  });
}

/** Two moments as a range, in order; null when they are too near to be meant as one. */
export function rangeOf(one: number, other: number, shortest: number): Range | null {
  const range = { start: Math.min(one, other), end: Math.max(one, other) };
  return range.end - range.start > shortest ? range : null;
}

/** Where a key takes the current time; undefined for a key that means nothing here. */
export function keyed(
  key: string,
  shift: boolean,
  at: { time: number; duration: number; frames: number },
): number | undefined {
  const { time, duration, frames } = at;
  const frame = (frames > 1 ? duration / (frames - 1) : 0) * (shift ? 10 : 1);
  const moves: Record<string, number> = {
    ArrowLeft: time - frame,
    ArrowDown: time - frame,
    ArrowRight: time + frame,
    ArrowUp: time + frame,
    PageDown: time - 1,
    PageUp: time + 1,
    Home: 0,
    End: duration,
  };
  const wanted = moves[key];
  return wanted === undefined ? undefined : onFrame(wanted, duration, frames);
}
