/** The way the camera follows: the hips' path over the floor with the sway and bounce taken out. */

/** Seconds over which the path is smoothed (standard deviation): longer than a step's sway. */
const SPREAD = 0.4;

/**
 * Smooths the roots' x and z over time.
 *
 * A cyclic clip's path goes on beyond its ends by its own travel, so that it has no seam. Any other
 * path is mirrored through its end points, which keeps the traveller over the disc there.
 */
export function smoothPath(roots: Float32Array, frameTime: number, cyclic: boolean): Float32Array {
  const frames = roots.length / 3;
  const path = new Float32Array(frames * 2);
  const radius = Math.ceil((3 * SPREAD) / frameTime);
  const weights = Float64Array.from({ length: radius + 1 }, (_, k) =>
    Math.exp(-0.5 * ((k * frameTime) / SPREAD) ** 2),
  );
  const total = weights.reduce((sum, weight, k) => sum + (k ? 2 * weight : weight), 0);
  for (let axis = 0; axis < 2; axis += 1) {
    const at = cyclic ? endless(roots, axis * 2) : mirrored(roots, axis * 2);
    const way = Float64Array.from({ length: frames + 2 * radius }, (_, k) => at(k - radius));
    for (let frame = 0; frame < frames; frame += 1) {
      const here = frame + radius;
      let sum = weights[0]! * way[here]!;
      for (let k = 1; k <= radius; k += 1) sum += weights[k]! * (way[here - k]! + way[here + k]!);
      path[frame * 2 + axis] = sum / total;
    }
  }
  return path;
}

function endless(roots: Float32Array, axis: number): (frame: number) => number {
  const steps = roots.length / 3 - 1;
  const travel = roots[steps * 3 + axis]! - roots[axis]!;
  return (frame) => {
    const cycle = Math.floor(frame / steps);
    return roots[(frame - cycle * steps) * 3 + axis]! + cycle * travel;
  };
}

function mirrored(roots: Float32Array, axis: number): (frame: number) => number {
  const last = roots.length / 3 - 1;
  const value = (frame: number) => roots[frame * 3 + axis]!;
  if (last === 0) return () => value(0);
  const at = (frame: number): number => {
    if (frame < 0) return 2 * value(0) - at(-frame);
    if (frame > last) return 2 * value(last) - at(2 * last - frame);
    return value(frame);
  };
  return at;
}

/** Seconds that the followed path remembers; more would lag in turns and run on at a stop. */
const MEMORY = 0.45;
/** Metres from the expected place beyond which the traveller was put elsewhere. */
const LEAP = 1.5;
/** Seconds without a pose after which the pace of before means nothing. */
const LONGEST_GAP = 1;

/**
 * Follows a traveller whose way is not known beforehand, smoothing out the sway of the steps.
 *
 * The fading-memory filter of first degree (N. Morrison, Introduction to Sequential Smoothing and
 * Prediction, 1969): it does not lag behind an even pace, and any time between two poses will do.
 */
export class FollowedPath {
  private readonly place = [0, 0];
  private readonly pace = [0, 0];
  private time = -Infinity;

  /** Notes where the hips are at a time, in seconds; writes x and z of the path. */
  follow(x: number, z: number, time: number, out: Float32Array): void {
    const { place, pace } = this;
    const now = [x, z];
    const seconds = time - this.time;
    this.time = time;
    const off = now.map((value, axis) => value - place[axis]! - pace[axis]! * seconds);
    if (seconds > LONGEST_GAP || Math.hypot(...off) > LEAP) this.restart(now);
    else if (seconds > 0) {
      const fade = Math.exp(-seconds / MEMORY);
      for (let axis = 0; axis < 2; axis += 1) {
        place[axis] = now[axis]! - fade * fade * off[axis]!;
        pace[axis]! += ((1 - fade) ** 2 * off[axis]!) / seconds;
      }
    }
    out.set(place);
  }

  private restart(place: number[]): void {
    this.place.splice(0, 2, ...place);
    this.pace.fill(0);
  }
}
