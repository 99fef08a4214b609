import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Glances } from "./glances";

let tell: (entries: { target: Element; isIntersecting: boolean }[]) => void;

beforeEach(() => {
  vi.stubGlobal("IntersectionObserver", class {
    constructor(callback: typeof tell) { tell = callback; }
    observe(): void {}
    disconnect(): void {}
  });
});
afterEach(() => vi.unstubAllGlobals());

const cells = () => Array.from({ length: 3 }, () => document.createElement("div"));

it("only what is in view while the figures move is watched", () => {
  const all = cells();
  const [first, second, third] = [all[0]!, all[1]!, all[2]!];
  const glances = new Glances(all);
  tell([{ target: first, isIntersecting: true }, { target: second, isIntersecting: true }, { target: third, isIntersecting: false }]);
  glances.watched(0);
  glances.watched(400);
  tell([{ target: second, isIntersecting: false }, { target: third, isIntersecting: true }]);
  glances.watched(1_000);
  glances.watched(1_000); // paused: the viewer's time stands still
  expect(glances.ms).toEqual([1_000, 400, 600]);
});

it("a figure is seen after a second of its movement, and that is told once", () => {
  const all = cells();
  const glances = new Glances(all);
  tell([{ target: all[0]!, isIntersecting: true }]);
  const news = [0, 500, 999, 1_000, 1_500].map((total) => glances.watched(total));
  expect(news).toEqual([false, false, false, true, false]);
  expect(all.map((_, place) => glances.isSeen(place))).toEqual([true, false, false]);
  expect(glances.unseen).toBe(2);
});

it("goes on after a reload where the draft stopped", () => {
  const all = cells();
  const glances = new Glances(all, [900, 0, 2_000]);
  tell([{ target: all[0]!, isIntersecting: true }]);
  glances.watched(0);
  glances.watched(100);
  expect(glances.ms).toEqual([1_000, 0, 2_000]);
  expect(glances.unseen).toBe(1);
});
