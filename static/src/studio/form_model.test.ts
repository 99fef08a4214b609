import { expect, test } from "vitest";
import { hasSlider, kindOf, readJson, startingParameters, startOf, stepOf, type Schema } from "./form_model";

const AMOUNT: Schema = { type: "number", minimum: 0, maximum: 2, neutral: 0, default: 1 };
const SEED: Schema = { type: "integer", minimum: 0, maximum: 4294967295, default: 1 };
const LIMBS: Schema = { type: ["array", "null"], items: { type: "string", enum: ["left_arm", "head"] }, default: null };
const KEYS: Schema = { type: "array", items: { type: "object" } };
const POSE: Schema = { anyOf: [{ type: "string", enum: ["neutral"] }, { type: "string", pattern: "^[0-9a-f]{64}$" }] };

test("every parameter gets the control of its kind", () => {
  const kinds = [AMOUNT, SEED, LIMBS, KEYS, POSE, { type: "boolean" }, { enum: ["a"] }].map(kindOf);
  expect(kinds).toEqual(["number", "number", "choices", "json", "text", "flag", "choice"]);
});

test("a number gets a slider where one can hit its values", () => {
  expect([AMOUNT, SEED, { type: ["number", "null"], minimum: 0, maximum: 10 }].map(hasSlider)).toEqual([true, false, false]);
  expect([stepOf(AMOUNT), stepOf(SEED), stepOf({ type: "number", minimum: -180, maximum: 180 })]).toEqual([0.01, 1, 0.5]);
});

test("parameters start at their defaults, and required ones with what may stand there", () => {
  expect(startingParameters({ properties: { amount: AMOUNT, limbs: LIMBS, kind: { enum: ["even", "added"] }, keyframes: KEYS } }, "c1"))
    .toEqual({ amount: 1, limbs: null, kind: "even", keyframes: [] });
  expect(startingParameters({ properties: { other: { type: "string", pattern: "x", refers: "clip" } } }, "c1")).toEqual({ other: "c1" });
  expect(startOf({ type: "number", minimum: 3, maximum: 5 })).toBe(3);
});

test("text that is no JSON is told, not taken", () => {
  expect(readJson("[1, 2]")).toEqual({ value: [1, 2] });
  expect(readJson("[1,")).toHaveProperty("problem");
});
