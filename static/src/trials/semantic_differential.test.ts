import { expect, it } from "vitest";
import type { Step } from "./kind";
import { nameOf, semanticDifferential, shown, values, type Parameters } from "./semantic_differential";

const task: Parameters = {
  scales: ["a", "b", "c"].map((id) => ({ id, left: `un${id}`, right: id })),
  steps: ["very", "rather", "neither", "rather", "very"],
  preselected: true,
};
const step: Step = { index: 0, part: "p", kind: "semantic_differential", figures: [] };

it("steps are numbered around the middle", () => {
  expect(values(task.steps)).toEqual([-2, -1, 0, 1, 2]);
  expect(values(["yes", "neither", "no"])).toEqual([-1, 0, 1]);
});

it("a step is named by its word and the pole that it leans to", () => {
  expect(values(task.steps).map((value) => nameOf(value, task.scales[0]!, task.steps))).toEqual([
    "very una", "rather una", "neither", "rather a", "very a",
  ]);
});

it("a preselected form has every scale in the middle, none touched, and can be handed in", () => {
  const blank = semanticDifferential.blank({ task, step });
  expect(blank).toEqual({ answers: { a: 0, b: 0, c: 0 }, touched: [], comment: "" });
  expect(semanticDifferential.isComplete({ task, step }, blank)).toBe(true);
});

it("without a preselection every scale must be answered", () => {
  const open = { task: { ...task, preselected: false }, step };
  const blank = semanticDifferential.blank(open);
  expect(blank.answers).toEqual({});
  expect(semanticDifferential.remaining(open, blank)).toBe("3 pairs to go");
  expect(semanticDifferential.remaining(open, { ...blank, answers: { a: 1, c: 0 } })).toBe("1 pair to go");
});

it("scales stand in the participant's own order", () => {
  expect(shown({ task, step: { ...step, scales: ["c", "a", "b"] } }).map(({ id }) => id)).toEqual(["c", "a", "b"]);
  expect(shown({ task, step }).map(({ id }) => id)).toEqual(["a", "b", "c"]);
});

it("a simulated person answers every scale with one of its steps, each step about as often", () => {
  let state = 1;
  const random = () => (state = (state * 16807) % 2147483647) / 2147483647;
  const seen = new Map<unknown, number>();
  for (let person = 0; person < 2000; person++) {
    const form = semanticDifferential.simulate({ task, step }, random);
    expect(form.touched).toEqual(["a", "b", "c"]);
    for (const value of Object.values(form.answers)) seen.set(value, (seen.get(value) ?? 0) + 1);
  }
  expect([...seen.keys()].sort((one, other) => Number(one) - Number(other))).toEqual([-2, -1, 0, 1, 2]);
  for (const count of seen.values()) expect(Math.abs(count / 6000 - 0.2)).toBeLessThan(0.03);
});
