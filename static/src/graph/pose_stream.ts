// Pieces of motion put end to end, and the pose of any moment between their frames. No DOM in here.

import type { Piece, Place } from "./model";

/** A piece that is queued: its frames, where it began and where it leads. */
export interface Queued {
  piece: Piece;
  start: Place;
  frames: Float32Array;
  /** Number of its first frame in the whole stream. */
  first: number;
  /** Frames of it that are played; fewer than it has when it was cut short. */
  count: number;
}

export class PoseStream {
  private readonly queue: Queued[] = [];
  private lastFrame: Float32Array | null = null;
  private next = 0;

  constructor(readonly frameTime: number) {}

  /** Seconds of motion that are there in all. */
  get end(): number {
    return Math.max(0, this.next - 1) * this.frameTime;
  }

  /** Where the motion goes on, or null before the first piece. */
  get place(): Place | null {
    const last = this.queue.at(-1);
    if (!last) return null;
    return last.count < last.piece.frames ? placeIn(last, last.count) : last.piece.after;
  }

  append(piece: Piece, start: Place): void {
    const frames = decode(piece);
    this.queue.push({ piece, start, frames, first: this.next, count: piece.frames });
    this.next += piece.frames;
  }

  /**
   * Leaves out what comes after a moment, so that something else can come there sooner.
   *
   * Only a stretch of one clip can be cut: a cross-fade once begun is finished.
   */
  cutAfter(time: number): void {
    const last = this.queue.at(-1);
    if (!last || last.piece.blended) return;
    const wanted = Math.ceil(time / this.frameTime) + 1 - last.first;
    last.count = Math.min(last.count, Math.max(1, wanted));
    this.next = last.first + last.count;
  }

  /** What is shown at a moment. */
  at(time: number): Queued | null {
    const frame = Math.floor(time / this.frameTime + 1e-6);
    return this.queued(frame) ?? this.queue[0] ?? null;
  }

  /** The pose of a moment: root x, y, z, then a quaternion x, y, z, w a joint; null before the first. */
  sample(time: number, out: { root: Float32Array; rotations: Float32Array }): boolean {
    const exact = Math.min(Math.max(time, 0), this.end) / this.frameTime;
    const before = Math.floor(exact);
    const one = this.frame(before);
    if (!one) return false;
    const other = this.frame(before + 1) ?? one;
    mix(one, other, exact - before, out);
    return true;
  }

  /** Forgets what has been played. */
  forgetBefore(time: number): void {
    const frame = Math.floor(time / this.frameTime) - 1;
    while (this.queue.length > 1 && this.queue[1]!.first <= frame) {
      const gone = this.queue.shift()!;
      this.lastFrame = row(gone, gone.count - 1);
    }
  }

  /** The piece that a frame belongs to. */
  private queued(frame: number): Queued | undefined {
    return [...this.queue].reverse().find(({ first }) => first <= frame);
  }

  private frame(number: number): Float32Array | null {
    const piece = this.queued(number);
    if (!piece) return this.lastFrame;
    return number < piece.first + piece.count ? row(piece, number - piece.first) : null;
  }
}

/** The place so many frames into a piece that is a stretch of one clip. */
function placeIn({ start }: Queued, frames: number): Place {
  return { ...start, frame: start.frame + frames };
}

function row({ frames, piece }: Queued, index: number): Float32Array {
  const size = 3 + 4 * piece.joints;
  return frames.subarray(index * size, (index + 1) * size);
}

export function decode({ motion }: Pick<Piece, "motion">): Float32Array {
  const bytes = Uint8Array.from(atob(motion), (letter) => letter.charCodeAt(0));
  return new Float32Array(bytes.buffer);
}

/** Between two frames: roots on the straight line, rotations on the shorter arc (normalised lerp). */
function mix(
  one: Float32Array,
  other: Float32Array,
  share: number,
  out: { root: Float32Array; rotations: Float32Array },
): void {
  for (let i = 0; i < 3; i += 1) out.root[i] = one[i]! + share * (other[i]! - one[i]!);
  for (let i = 3; i < one.length; i += 4) {
    let dot = 0;
    for (let k = 0; k < 4; k += 1) dot += one[i + k]! * other[i + k]!;
    const sign = dot < 0 ? -1 : 1;
    let length = 0;
    for (let k = 0; k < 4; k += 1) {
      const value = (1 - share) * one[i + k]! + share * sign * other[i + k]!;
      out.rotations[i - 3 + k] = value;
      length += value * value;
    }
    for (let k = 0; k < 4; k += 1) out.rotations[i - 3 + k]! /= Math.sqrt(length);
  }
}
