import { expect, test } from "vitest";
import { inReach, nineMotions, pointWords, stepped } from "./pad_model";

test("a point takes from the four motions around it, in all 1", () => {
  for (const point of [{ path: 0.55, timing: 1.62 }, { path: 1.9, timing: 0.1 }]) {
    const used = nineMotions(point).filter(({ weight }) => weight > 0);
    expect(used).toHaveLength(4);
    expect(used.reduce((sum, { weight }) => sum + weight, 0)).toBeCloseTo(1, 12);
    const mean = (axis: "path" | "timing") => used.reduce((sum, one) => sum + one.weight * one[axis], 0);
    expect(mean("path")).toBeCloseTo(point.path, 12);
    expect(mean("timing")).toBeCloseTo(point.timing, 12);
  }
});

test("on a motion's own place it is that motion alone", () => {
  const used = nineMotions({ path: 2, timing: 0 }).filter(({ weight }) => weight > 0);
  expect(used).toEqual([{ path: 2, timing: 0, weight: 1 }]);
});

test("a point outside is brought to the edge", () => {
  expect(inReach({ path: -3, timing: 2.7 })).toEqual({ path: 0, timing: 2 });
});

test("arrow keys go by small steps, with Shift by large ones, and stop at the edge", () => {
  const middle = { path: 1, timing: 1 };
  expect(stepped(middle, "ArrowLeft", false)).toEqual({ path: 0.95, timing: 1 });
  expect(stepped(middle, "ArrowUp", true)).toEqual({ path: 1, timing: 1.25 });
  expect(stepped({ path: 2, timing: 0 }, "ArrowDown", true)).toEqual({ path: 2, timing: 0 });
  expect(stepped(middle, "Enter", false)).toBeNull();
});

test("a point is told in words", () => {
  expect(pointWords({ path: 0.55, timing: 1.62 })).toBe("path 0.55, shorter; timing 1.62, pauses");
  expect(pointWords({ path: 1, timing: 1 })).toBe("path 1.00, as it is; timing 1.00, as it is");
});
