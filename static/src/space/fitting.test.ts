import { expect, test } from "vitest";
import { fittingSteps, fittingWords } from "./fitting";

const like = { id: "a", skeleton_hash: "same", cyclic: true };

test("a clip that fits needs nothing", () => {
  expect(fittingSteps({ ...like, id: "b" }, like)).toEqual([]);
});

test("a walk is cut to one cycle, and another skeleton put onto that of the examples", () => {
  const steps = fittingSteps({ id: "b", skeleton_hash: "other", cyclic: false }, like);
  expect(steps).toEqual([{ operation: "cycle@1", parameters: {} }, { operation: "retarget@1", parameters: { clip: "a" } }]);
  expect(fittingWords(steps)).toBe("one cycle of it, on the examples’ skeleton");
});

test("a cycle among motions that are none stays whole", () => {
  expect(fittingSteps({ ...like, id: "b" }, { ...like, cyclic: false })).toEqual([]);
});
