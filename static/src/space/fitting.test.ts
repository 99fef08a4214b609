import { expect, test } from "vitest";
import { fittingSteps, fittingWords } from "./fitting";

const like = { id: "a", figure_url: "/media/one.glb", cyclic: true };

test("a clip that fits needs nothing", () => {
  expect(fittingSteps({ ...like, id: "b" }, like)).toEqual([]);
});

test("another skeleton is put onto that of the examples, and a walk becomes one cycle", () => {
  const steps = fittingSteps({ id: "b", figure_url: "/media/other.glb", cyclic: false }, like);
  expect(steps).toEqual([{ operation: "retarget@1", parameters: { clip: "a" } }, { operation: "cycle@1", parameters: {} }]);
  expect(fittingWords(steps)).toBe("on the examples’ skeleton, one cycle of it");
});

test("a cycle among motions that are none stays whole", () => {
  expect(fittingSteps({ ...like, id: "b" }, { ...like, cyclic: false })).toEqual([]);
});
