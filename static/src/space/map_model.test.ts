import { expect, test } from "vitest";
import { hull, nearest, neighbour, stepped } from "./map_model";

const spots = [{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 0.5, y: 0.4 }, { x: 1, y: 1 }, { x: 0, y: 1 }, { x: 0.5, y: 0 }];

test("the hull has the outer spots only, whatever lies within or on an edge", () => {
  expect(hull(spots)).toEqual([{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 1, y: 1 }, { x: 0, y: 1 }]);
});

test("the nearest spot is found within reach", () => {
  expect(nearest(spots, { x: 0.55, y: 0.35 }, 0.1)).toBe(2);
  expect(nearest(spots, { x: 0.75, y: 0.7 }, 0.1)).toBeNull();
});

test("keys move a spot and stop at the edge", () => {
  expect(stepped({ x: 0.5, y: 0.99 }, "ArrowUp", false)).toEqual({ x: 0.5, y: 1 });
  expect(stepped({ x: 0.5, y: 0.5 }, "ArrowLeft", true)).toEqual({ x: 0.4, y: 0.5 });
  expect(stepped({ x: 0.5, y: 0.5 }, "a", false)).toBeNull();
});

test("keys lead from example to example by where they lie", () => {
  expect(neighbour(spots, 2, "ArrowUp")).toBe(3);
  expect(neighbour(spots, 0, "ArrowDown")).toBeNull();
  expect(neighbour([{ x: 0.2, y: 0 }, { x: 0.9, y: 0 }, { x: 0.5, y: 0 }], 0, "ArrowRight")).toBe(2);
});
