import { expect, it } from "vitest";
import { seeded } from "../participant/testing";
import { blank, choose, nameOf, same, simulate, values, type Parameters } from "./semantic_differential";

const study: Parameters = {
  question: "", hint: "", comment_label: "", comment_placeholder: "",
  scales: ["a", "b", "c"].map((id) => ({ id, left: `un${id}`, right: id })),
  steps: ["very", "rather", "neither", "rather", "very"],
};

it("steps are numbered around the middle", () => {
  expect(values(study.steps)).toEqual([-2, -1, 0, 1, 2]);
  expect(values(["yes", "neither", "no"])).toEqual([-1, 0, 1]);
});

it("a step is named by its word and the pole that it leans to", () => {
  expect(values(study.steps).map((value) => nameOf(value, study.scales[0]!, study.steps))).toEqual([
    "very una", "rather una", "neither", "rather a", "very a",
  ]);
});

it("a blank form has every scale in the middle and none touched", () => {
  expect(blank(study)).toEqual({ answers: { a: 0, b: 0, c: 0 }, touched: [], comment: "" });
});

it("choosing leaves the form that it came from as it was", () => {
  const before = blank(study);
  const after = choose(choose(before, "b", 2), "b", 1);
  expect(before).toEqual(blank(study));
  expect(after).toMatchObject({ answers: { a: 0, b: 1, c: 0 }, touched: ["b"] });
});

it("a chosen middle differs from a preselected one", () => {
  expect(same(blank(study), choose(blank(study), "a", 0))).toBe(false);
  expect(same(blank(study), blank(study))).toBe(true);
});

it("a simulated person answers every scale with one of its steps, each step about as often", () => {
  const random = seeded(1);
  const seen = new Map<number, number>();
  for (let person = 0; person < 2000; person++) {
    const form = simulate(study, random);
    expect(form.touched).toEqual(["a", "b", "c"]);
    for (const value of Object.values(form.answers)) seen.set(value, (seen.get(value) ?? 0) + 1);
  }
  expect([...seen.keys()].sort((one, other) => one - other)).toEqual([-2, -1, 0, 1, 2]);
  for (const count of seen.values()) expect(Math.abs(count / 6000 - 0.2)).toBeLessThan(0.03);
});
