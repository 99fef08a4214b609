import { expect, test } from "vitest";
import { stepped } from "./dendrogram";
import type { Merge } from "./model";
import { branches, clustersAt, commonest, cutHeight } from "./tree";

const merge = (left: number, right: number, height: number, size: number): Merge => ({ left, right, height, increase: height ** 2 / 2, size });
/** Leaves 0 and 2 are alike, 1 and 3 are, and the two twos are far apart. */
const MERGES = [merge(0, 2, 1, 2), merge(1, 3, 2, 2), merge(4, 5, 6, 4)];

test("branches hang in the middle of what they hold, in the order of the rows", () => {
  const found = branches(MERGES, [0, 2, 1, 3]);
  expect(found.map(({ places }) => places)).toEqual([[0, 1], [2, 3], [0, 1, 2, 3]]);
  expect(found[2]!.ends.map(({ at, height }) => [at, height])).toEqual([[0.5, 1], [2.5, 2]]);
});

test("the cut is drawn where it makes as many clusters as it says", () => {
  for (const clusters of [1, 2, 3, 4]) expect(clustersAt(MERGES, cutHeight(MERGES, clusters))).toBe(clusters);
  expect(clustersAt([], cutHeight([], 1))).toBe(1);
});

test("a merge exactly at the cut is not cut", () => {
  expect(clustersAt(MERGES, 2)).toBe(2);
});

test("a branch has the colour of most of its leaves", () => {
  expect(commonest([1, 0, 1])).toBe(1);
  expect(commonest([])).toBeNull();
});

test("keys move the cut by one cluster and never beyond the ends", () => {
  expect(["ArrowRight", "ArrowLeft", "Home", "End", "a"].map((key) => stepped(key, 4, 4))).toEqual([4, 3, 1, 4, null]);
  expect(stepped("ArrowDown", 1, 4)).toBe(1);
});
