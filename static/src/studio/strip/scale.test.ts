import { expect, test } from "vitest";
import { frameOf, keyed, onFrame, placeOf, rangeOf, ticks } from "./scale";

const clip = { duration: 8, frames: 241, time: 4 };

test("a moment lies at its share of the strip, and never beyond it", () => {
  expect([placeOf(2, 8), placeOf(-1, 8), placeOf(9, 8), placeOf(0, 0)]).toEqual([25, 0, 100, 0]);
});

test("a moment between two frames is put on the nearer one", () => {
  expect(onFrame(1.01, 8, 241)).toBeCloseTo(1, 9);
  expect(onFrame(1.02, 8, 241)).toBeCloseTo(1 + 1 / 30, 9);
  expect(onFrame(99, 8, 241)).toBe(8);
  expect(onFrame(0.4, 0, 1)).toBe(0);
});

test("frames are counted from the first to the last", () => {
  expect([0, 4, 8].map((time) => frameOf(time, 8, 241))).toEqual([0, 120, 240]);
  expect(frameOf(0, 0, 1)).toBe(0);
});

test("labels are round numbers and never closer than they can be read", () => {
  for (const duration of [0.4, 1, 8.23, 61, 1000]) {
    for (const width of [250, 640, 1300]) {
      const named = ticks(duration, width).filter(({ label }) => label);
      named.slice(1).forEach(({ time }, index) => {
        expect(((time - named[index]!.time) / duration) * width).toBeGreaterThanOrEqual(80);
      });
      expect(ticks(duration, width).at(-1)!.time).toBeLessThanOrEqual(duration);
    }
  }
  expect(ticks(3, 300).map(({ label }) => label)).toEqual(["0 s", null, "1 s", null, "2 s", null, "3 s"]);
});

test("there is no scale without a motion or a width", () => {
  expect([...ticks(0, 300), ...ticks(3, 0)]).toEqual([]);
});

test("keys step by frames, tens of frames and to the ends", () => {
  expect(keyed("ArrowRight", false, clip)).toBeCloseTo(4 + 1 / 30, 9);
  expect(keyed("ArrowLeft", true, clip)).toBeCloseTo(4 - 10 / 30, 9);
  expect([keyed("Home", false, clip), keyed("End", false, clip)]).toEqual([0, 8]);
  expect(keyed("ArrowRight", true, { ...clip, time: 7.9 })).toBe(8);
  expect(keyed("x", false, clip)).toBeUndefined();
});

test("a range is in order, and too short a one is none", () => {
  expect(rangeOf(5, 2, 0.1)).toEqual({ start: 2, end: 5 });
  expect(rangeOf(2, 2.05, 0.1)).toBeNull();
});
