import { expect, test } from "vitest";
import { freeName } from "./names";

test("a name that is free stays as it is", () => {
  expect(freeName("walk sad", ["walk", "walk tired"])).toBe("walk sad");
});

test("a name that is taken gets the first number that is free", () => {
  expect(freeName("walk sad", ["walk sad", "walk sad 2"])).toBe("walk sad 3");
  expect(freeName("walk sad 2", ["walk sad", "walk sad 2"])).toBe("walk sad 3");
});
