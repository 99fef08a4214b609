import { describe, expect, it } from "vitest";
import { demandSameSkeleton, MotionClip, type ClipData } from "./clip";

/** A root that walks 2 m along z in 1 s while swaying, and turns about y. */
function walking(rate: number, cyclic: boolean, change: Partial<ClipData> = {}): MotionClip {
  const times = Array.from({ length: rate + 1 }, (_, k) => k / rate);
  return new MotionClip({
    names: ["hips"],
    parents: Int16Array.of(-1),
    offsets: new Float32Array(3),
    roots: Float32Array.from(
      times.flatMap((t) => [0.03 * Math.sin(2 * Math.PI * t), 0.9, 2 * t]),
    ),
    rotations: Float32Array.from(
      times.flatMap((t) => {
        const half = 0.2 * Math.sin(2 * Math.PI * t);
        return [0, Math.sin(half), 0, Math.cos(half)];
      }),
    ),
    frameTime: 1 / rate,
    cyclic,
    ...change,
  });
}

function at(clip: MotionClip, time: number) {
  const pose = clip.makePose();
  clip.sample(time, pose);
  return { root: [...pose.root], path: [...pose.path], turn: [...pose.rotations] };
}

describe("a clip sampled by time", () => {
  it("gives each frame back exactly at its own time", () => {
    const clip = walking(30, false);
    for (const frame of [0, 7, 30]) {
      expect(at(clip, frame / 30).root[2]).toBeCloseTo((2 * frame) / 30, 5);
    }
  });

  it("is nearly the same motion at 30 and at 120 frames a second", () => {
    const [slow, fast] = [walking(30, false), walking(120, false)];
    for (let step = 0; step <= 97; step += 1) {
      const [a, b] = [at(slow, step / 97), at(fast, step / 97)];
      a.turn.forEach((value, k) => expect(value).toBeCloseTo(b.turn[k]!, 2));
      a.root.forEach((value, k) => expect(value).toBeCloseTo(b.root[k]!, 3));
    }
  });

  it("turns halfway between two frames by half the angle, and stays a unit quaternion", () => {
    const quarter = [0, Math.SQRT1_2, 0, Math.SQRT1_2];
    const clip = walking(1, false, { rotations: Float32Array.of(0, 0, 0, 1, ...quarter) });
    const { turn } = at(clip, 0.5);
    expect(turn[1]).toBeCloseTo(Math.sin(Math.PI / 8), 6);
    expect(Math.hypot(...turn)).toBeCloseTo(1, 6);
  });

  it("takes the short way where the next frame has the other sign", () => {
    const angle = 0.1;
    const next = [0, -Math.sin(angle), 0, -Math.cos(angle)];
    const clip = walking(1, false, { rotations: Float32Array.of(0, 0, 0, 1, ...next) });
    expect(at(clip, 0.5).turn[1]).toBeCloseTo(Math.sin(angle / 2), 6);
  });

  it("crosses the seam of a cycle without a jump, going on by its travel", () => {
    const clip = walking(60, true);
    const step = 1e-4;
    for (const cycle of [1, 2, 10]) {
      const [before, after] = [at(clip, cycle - step), at(clip, cycle + step)];
      before.root.forEach((value, k) => expect(Math.abs(after.root[k]! - value)).toBeLessThan(1e-3));
      before.turn.forEach((value, k) => expect(Math.abs(after.turn[k]! - value)).toBeLessThan(1e-3));
      expect(after.root[2]).toBeCloseTo(2 * cycle, 2);
    }
  });

  it("keeps the same distance from its followed path in every cycle", () => {
    const clip = walking(60, true);
    for (const time of [0.1, 0.63]) {
      const [first, tenth] = [at(clip, time), at(clip, time + 9)];
      const away = (pose: typeof first) => pose.root[2]! - pose.path[1]!;
      expect(away(tenth)).toBeCloseTo(away(first), 4);
    }
  });

  it("holds its ends where it is no cycle", () => {
    const clip = walking(30, false);
    expect(at(clip, -5)).toEqual(at(clip, 0));
    expect(at(clip, 50)).toEqual(at(clip, 1));
  });

  it("shows the one pose of a clip of one frame at any time", () => {
    const clip = walking(30, false, {
      roots: Float32Array.of(1, 2, 3),
      rotations: Float32Array.of(0, 0, 0, 1),
    });
    expect(at(clip, 3).root).toEqual([1, 2, 3]);
    expect(clip.duration).toBe(0);
  });
});

describe("the path that the camera follows", () => {
  it("leaves out the sway of a long walk but keeps its way", () => {
    const long = Array.from({ length: 301 }, (_, k) => k / 30);
    const clip = walking(30, false, {
      roots: Float32Array.from(
        long.flatMap((t) => [0.03 * Math.sin(2 * Math.PI * t), 0.9, 1.4 * t]),
      ),
      rotations: Float32Array.from(long.flatMap(() => [0, 0, 0, 1])),
    });
    for (const time of [3, 5.2, 7]) {
      expect(Math.abs(at(clip, time).path[0]!)).toBeLessThan(0.003);
      expect(at(clip, time).path[1]).toBeCloseTo(1.4 * time, 2);
    }
  });

  it("begins and ends exactly under the traveller", () => {
    const clip = walking(30, false);
    expect(at(clip, 0).path[1]).toBeCloseTo(0, 6);
    expect(at(clip, 1).path[1]).toBeCloseTo(2, 6);
  });
});

describe("a clip that takes another's place", () => {
  const two = (change: Partial<ClipData>) =>
    walking(1, false, {
      names: ["hips", "head"],
      parents: Int16Array.of(-1, 0),
      offsets: Float32Array.of(0, 0.9, 0, 0, 0.6, 0),
      rotations: Float32Array.from([0, 1, 2, 3].flatMap(() => [0, 0, 0, 1])),
      ...change,
    });

  it("may begin anywhere and be of another rate and length", () => {
    const elsewhere = two({ offsets: Float32Array.of(5, 0, 5, 0, 0.6, 0), frameTime: 0.2 });
    expect(() => demandSameSkeleton(elsewhere, two({}))).not.toThrow();
  });

  it("is refused by the first thing that differs", () => {
    const names = two({ names: ["hips", "tail"] });
    expect(() => demandSameSkeleton(names, two({}))).toThrow(/joint 2 is “tail”.*“head”/);
    expect(() => demandSameSkeleton(walking(1, false), two({}))).toThrow(/1 joints.* 2/);
    const tall = two({ offsets: Float32Array.of(0, 0.9, 0, 0, 0.7, 0) });
    expect(() => demandSameSkeleton(tall, two({}))).toThrow(/bone to “head”/);
  });
});
