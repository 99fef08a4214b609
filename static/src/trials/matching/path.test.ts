import { expect, it } from "vitest";
import { seeded } from "../../participant/testing";
import type { Move } from "../kind";
import { gapOf, withMove } from "./path";

it("keeps where every slider came to rest, in order, and of one slider at most one move in a while", () => {
  const random = seeded(5);
  const gap = gapOf(300_000);
  const last = new Map<string, number>();
  let path: Move[] = [];
  for (let ms = 0; ms < 60_000; ms += 200 * random()) {
    const [slider, position] = [random() < 0.9 ? "a" : "b", Math.round(100 * random()) / 100];
    path = withMove(path, [ms, slider, position], gap);
    last.set(slider, position);
  }
  for (const [slider, position] of last) expect(path.filter(([, id]) => id === slider).at(-1)![2]).toBe(position);
  path.slice(1).forEach(([ms, slider], index) => {
    const [before, other] = path[index]!;
    expect(ms).toBeGreaterThanOrEqual(before);
    if (other === slider) expect(ms - before).toBeGreaterThanOrEqual(gap);
  });
});

it("an hour of dragging stays within what the server takes", () => {
  let path: Move[] = [];
  const limit = 3_600_000;
  for (let ms = 0; ms < limit; ms += 120) path = withMove(path, [ms, "a", 0.5], gapOf(limit));
  expect(path.length).toBeLessThanOrEqual(10_000);
}, 60_000);

it("a full path still ends where the sliders came to rest", () => {
  const full: Move[] = Array.from({ length: 20_000 }, (_, index) => [index, "a", 0.1]);
  const path = withMove(full, [1e6, "b", 0.9], 100);
  expect(path.length).toBe(20_000);
  expect(path.at(-1)!.slice(1)).toEqual(["b", 0.9]);
});
