import { beforeEach, expect, test } from "vitest";
import { findState, keepState } from "./draft";
import { moved, start } from "./model";
import type { Space } from "./server";

const features = { primary: [], parameters: [{ id: "step", title: "Step", left: "less", right: "more", unit: "m", lowest: 0, highest: 1, values: [0, 1] }] };
const space = {
  id: "s", name: "Walks", definition: { adjectives: null, features, examples: [{ clip: "a", name: "a" }, { clip: "b", name: "b" }] },
} as unknown as Space;

beforeEach(() => localStorage.clear());

test("a reload finds where one stood", () => {
  const state = { place: moved(start(space), { step: 0.8 }), keytimes: { a: { left_strike: 0.1 } } };
  keepState("s", state);
  expect(findState(space)).toEqual(state);
});

test("what does not fit the space is not taken up", () => {
  expect(findState(space)).toBeNull();
  const place = start(space);
  for (const other of [{ ...place, by: "adjectives" as const }, { ...place, features: { gone: 0.5 } }, { ...place, weights: { a: 1 } }, { ...place, features: { step: 2 } }]) {
    keepState("s", { place: other, keytimes: {} });
    expect(findState(space)).toBeNull();
  }
  localStorage.setItem("manner-space-draft:s", "{broken");
  expect(findState(space)).toBeNull();
});
