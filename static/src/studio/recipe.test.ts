import { expect, test } from "vitest";
import {
  allBands, bandsOf, extrasOf, gridOf, insert, mixedOf, postureOf, put, rounded, same, withBands, withGrid, withPosture,
  type Steps,
} from "./recipe";

const FULL: Steps = [
  { operation: "grid@1", parameters: { path: 0.4, timing: 2 } },
  { operation: "posture@1", parameters: { offsets: [{ pose: "head_down", neutral: "neutral", amount: 0.8 }] } },
  { operation: "tempo@1", parameters: { factor: 1.2 } },
  { operation: "grid@1", parameters: { path: 2, timing: 1 } },
];

test("controls read what a recipe says, and neutral where it says nothing", () => {
  expect(gridOf(FULL)).toEqual({ path: 0.4, timing: 2 });
  expect(gridOf([])).toEqual({ path: 1, timing: 1 });
  expect([...postureOf(FULL)]).toEqual([["head_down", 0.8]]);
  expect(bandsOf([])).toEqual([]);
});

test("a control changes its own step and leaves every other as it was", () => {
  const changed = withGrid(FULL, { path: 1.5, timing: 0.5 });
  expect(gridOf(changed)).toEqual({ path: 1.5, timing: 0.5 });
  expect(changed.slice(1)).toEqual(FULL.slice(1));
  expect(FULL[0]!.parameters.path).toBe(0.4);
});

test("back at neutral a step is gone, so that a reset recipe is the empty one", () => {
  let steps = withGrid([], { path: 0.3, timing: 1.2 });
  steps = withPosture(steps, "head_down", 0.5);
  steps = withBands(steps, [{ frequency: 1, gain: 2 }]);
  steps = withGrid(steps, { path: 1, timing: 1 });
  steps = withPosture(steps, "head_down", 0);
  expect(withBands(steps, [{ frequency: 1, gain: 1 }])).toEqual([]);
});

test("one posture changes without its neighbours", () => {
  const two = withPosture(FULL, "elbows_away", -0.4);
  expect([...postureOf(two)]).toEqual([["head_down", 0.8], ["elbows_away", -0.4]]);
  expect([...postureOf(withPosture(two, "head_down", 0))]).toEqual([["elbows_away", -0.4]]);
});

test("a new step goes where it belongs, whatever came first", () => {
  const steps = insert(withGrid([{ operation: "tempo@1", parameters: { factor: 2 } }], { path: 0, timing: 1 }), {
    operation: "cut@1", parameters: {},
  });
  expect(steps.map(({ operation }) => operation)).toEqual(["cut@1", "grid@1", "tempo@1"]);
});

test("an unknown operation and a second grid are extras, which no control loses", () => {
  expect(extrasOf(FULL).map(({ step, place }) => [step.operation, place])).toEqual([["tempo@1", 2], ["grid@1", 3]]);
  expect(put(FULL, "nothing@1", null)).toBe(FULL);
});

test("an equaliser shows the recipe's own bands, or the usual ones", () => {
  const usual = [0.5, 1, 2];
  expect(allBands([], usual).map(({ gain }) => gain)).toEqual([1, 1, 1]);
  const own = withBands([], [{ frequency: 3, gain: 0.5 }, { frequency: 0.7, gain: 1 }]);
  expect(allBands(own, usual).map(({ frequency }) => frequency)).toEqual([0.7, 3]);
});

test("recipes are the same whatever the order of their members", () => {
  expect(same({ a: 1, b: [{ c: 2, d: 3 }] }, { b: [{ d: 3, c: 2 }], a: 1 })).toBe(true);
  expect(same([1, 2], [2, 1])).toBe(false);
});

test("rounding leaves no tail", () => {
  expect([rounded(0.1 + 0.2), rounded(1.005 * 100, 0.05), rounded(0.824)]).toEqual([0.3, 100.5, 0.82]);
});

test("a mix tells its examples", () => {
  const mix: Steps = [{ operation: "blend@1", parameters: { examples: [{ clip: "a", weight: 0.4 }, { clip: "b", weight: 0.6 }] } }];
  expect(mixedOf(mix)).toEqual(["a", "b"]);
  expect(mixedOf(FULL)).toBeNull();
});
