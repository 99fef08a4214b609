import { expect, test } from "vitest";
import type { Piece, Place } from "./model";
import { PoseStream } from "./pose_stream";

const START: Place = { clip: "walk", frame: 10, turn: 0, x: 0, z: 0, manner: { path: 1, timing: 1, postures: {} } };

/** A piece of one joint whose root's x counts on from `x`; all frames turned about y by `angles`. */
function piece(x: number, frames: number, options: Partial<Piece> = {}, angle = 0): Piece {
  const rows = Array.from({ length: frames }, (_, k) => [x + k, 0, 0, 0, Math.sin(angle / 2), 0, Math.cos(angle / 2)]);
  const bytes = new Uint8Array(new Float32Array(rows.flat()).buffer);
  return {
    frames, joints: 1, motion: btoa(String.fromCharCode(...bytes)),
    after: { ...START, frame: START.frame + frames }, blended: false, taken: null, ahead: null, wait: 0, reaches: 0,
    ...options,
  };
}

const pose = () => ({ root: new Float32Array(3), rotations: new Float32Array(4) });

test("between frames and between pieces the pose goes evenly", () => {
  const stream = new PoseStream(0.1);
  stream.append(piece(0, 3), START);
  stream.append(piece(3, 3), START);
  const out = pose();
  expect(stream.end).toBeCloseTo(0.5);
  for (const time of [0, 0.05, 0.2, 0.25, 0.33, 0.5]) {
    expect(stream.sample(time, out)).toBe(true);
    expect(out.root[0]).toBeCloseTo(time * 10, 5);
  }
  stream.sample(9, out);
  expect(out.root[0]).toBeCloseTo(5); // it waits at its end
});

test("rotations take the shorter way, whatever their signs", () => {
  const stream = new PoseStream(0.1);
  const [one, other] = [piece(0, 1, {}, 0.2), piece(1, 1, {}, 2 * Math.PI + 0.6)];
  stream.append(one, START);
  stream.append(other, START);
  const out = pose();
  stream.sample(0.05, out);
  expect(2 * Math.atan2(Math.abs(out.rotations[1]!), Math.abs(out.rotations[3]!))).toBeCloseTo(0.4, 5);
  expect(Math.hypot(...out.rotations)).toBeCloseTo(1, 6);
});

test("a stretch is cut where it is not shown yet, and the place is that of the cut", () => {
  const stream = new PoseStream(0.1);
  stream.append(piece(0, 18), START);
  stream.cutAfter(0.42);
  expect(stream.place).toEqual({ ...START, frame: 16 });
  expect(stream.end).toBeCloseTo(0.5);
  stream.append(piece(6, 4), stream.place!);
  const out = pose();
  stream.sample(0.65, out);
  expect(out.root[0]).toBeCloseTo(6.5, 5);
});

test("a cross-fade once begun is finished", () => {
  const stream = new PoseStream(0.1);
  const whole = piece(0, 18, { blended: true });
  stream.append(whole, START);
  stream.cutAfter(0.1);
  expect(stream.place).toEqual(whole.after);
  expect(stream.end).toBeCloseTo(1.7);
});

test("what was played is forgotten without a gap", () => {
  const stream = new PoseStream(0.1);
  stream.append(piece(0, 3), START);
  stream.append(piece(3, 3), START);
  stream.forgetBefore(0.45);
  const out = pose();
  stream.sample(0.45, out);
  expect(out.root[0]).toBeCloseTo(4.5, 5);
  expect(stream.at(0.45)?.first).toBe(3);
});
