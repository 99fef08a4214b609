import { render } from "lit";
import { beforeEach, describe, expect, it } from "vitest";
import { seeded } from "../participant/testing";
import { trials, type AnyKind } from ".";
import { same, set, unset, type CellParts, type Change, type Form, type Step, type Value } from "./kind";
import { move, order, toggle } from "./ranking";

const scales = [{ id: "a_b", left: "a", right: "b" }, { id: "c_d", left: "c", right: "d" }];
const items = [{ id: "warm", label: "warm" }, { id: "kind", label: "kind" }];
const whole = (low: number, high: number) => (value: Value) => Number.isInteger(value) && low <= Number(value) && Number(value) <= high;

/** What each kind asks, how many figures it shows, and which values an answer may have. */
const CASES: Record<string, { task: object; figures: number; step?: Partial<Step>; ids: string[]; fits: (value: Value) => boolean }> = {
  semantic_differential: { task: { scales, steps: ["x", "y", "z"], preselected: false }, figures: 1, ids: ["a_b", "c_d"], fits: whole(-1, 1) },
  unipolar: { task: { items, steps: ["no", "some", "very"] }, figures: 1, ids: ["warm", "kind"], fits: whole(0, 2) },
  likert: { task: { items, steps: ["no", "so", "yes", "sure"] }, figures: 1, ids: ["warm", "kind"], fits: whole(1, 4) },
  analogue: { task: { scales }, figures: 1, ids: ["a_b", "c_d"], fits: whole(0, 100) },
  choose: { task: { allow_none: true }, figures: 10, ids: ["choice"], fits: whole(-1, 9) },
  ab: { task: { allow_same: false }, figures: 2, ids: ["choice"], fits: whole(0, 1) },
  abx: { task: {}, figures: 3, ids: ["choice"], fits: whole(0, 1) },
  parallel: { task: { low: "bad", high: "good" }, figures: 4, ids: ["0", "1", "2", "3"], fits: whole(0, 100) },
  ranking: { task: { first: "best", last: "worst" }, figures: 4, ids: ["0", "1", "2", "3"], fits: whole(1, 4) },
  free_text: { task: { required: true }, figures: 1, ids: ["text"], fits: (value) => typeof value === "string" && value !== "" },
  match: {
    task: { seconds: 300, threshold: 0.06, start: 0.5, sliders: { weights: [{ id: "e0", title: "1" }, { id: "e1", title: "2" }] }, example_figures: [] },
    figures: 1, step: { interface: "weights", seen: true }, ids: ["e0", "e1", "seconds"], fits: (value) => Number(value) >= 0 && Number(value) <= 300,
  },
};

const figure = { glb_url: "/c", figure_url: null, cyclic: true };
const askedOf = (name: string) => {
  const { task, figures, step: more } = CASES[name]!;
  const step: Step = { index: 0, part: "p", kind: name, figures: Array.from({ length: figures }, () => figure), ...more };
  return { task, step };
};

let place: HTMLElement;
beforeEach(() => {
  place = document.createElement("div");
  document.body.replaceChildren(place);
});

/** Draws a kind, whole, again after every change; returns what the form is now. */
function drawn(kind: AnyKind, name: string): { form: () => Form; parts: () => CellParts[] } {
  let form = kind.blank(askedOf(name));
  let parts: CellParts[] = [];
  const draw = () => {
    const change: Change = (act) => { form = act(form); draw(); };
    const view = { ...askedOf(name), form, change, pressed: false };
    parts = kind.layout === "cells" ? view.step.figures.map((_, index) => kind.cell!(view, index)) : [];
    render([kind.panel(view), ...parts.map(({ corner, foot }) => [corner, foot])], place);
  };
  draw();
  return { form: () => form, parts: () => parts };
}

it("there is a case here for every kind", () => {
  expect(Object.keys(CASES).sort()).toEqual(Object.keys(trials).sort());
});

describe.each(Object.entries(trials))("%s", (name, kind) => {
  it("begins without an answer, says what is left to do, and cannot be handed in", () => {
    const blank = kind.blank(askedOf(name));
    expect(blank).toEqual({ answers: {}, touched: [], comment: "" });
    expect(kind.isComplete(askedOf(name), blank)).toBe(false);
    expect(kind.remaining(askedOf(name), blank)).toMatch(/\S/);
  });

  it("a made-up answer is complete and within bounds, and no answer more is left open", () => {
    const random = seeded(7);
    const { ids, fits } = CASES[name]!;
    for (let person = 0; person < 200; person++) {
      const form = kind.simulate(askedOf(name), random);
      expect(Object.keys(form.answers).sort()).toEqual([...ids].sort());
      expect(Object.values(form.answers).every(fits)).toBe(true);
      expect(kind.isComplete(askedOf(name), form)).toBe(true);
      expect(kind.remaining(askedOf(name), form)).toBeNull();
    }
  });

  it("two people make up different answers, the same chance the same one", () => {
    const made = (seed: number) => Array.from({ length: 20 }, () => kind.simulate(askedOf(name), seeded(seed)));
    expect(made(1)).toEqual(made(1));
    const random = seeded(1);
    const many = Array.from({ length: 20 }, () => JSON.stringify(kind.simulate(askedOf(name), random)));
    expect(new Set(many).size).toBeGreaterThan(1);
  });

  it("says of everything that it stores what it is", () => {
    expect(Object.values(kind.data).every((words) => words.length > 3)).toBe(true);
    expect(Object.keys(kind.data).length).toBeGreaterThan(0);
  });

  it("names every control for those who cannot see it", () => {
    drawn(kind, name);
    for (const control of document.querySelectorAll("input, button, textarea")) {
      const label = control.getAttribute("aria-label") ?? control.closest("label")?.textContent ?? control.textContent;
      const other = control.id && document.querySelector(`label[for="${control.id}"]`)?.textContent;
      expect(`${label ?? ""}${other ?? ""}`.trim()).not.toBe("");
    }
  });
});

describe("a slider", () => {
  it("has no answer until it is touched, not even where its middle is pressed", () => {
    const { form } = drawn(trials["analogue"]!, "analogue");
    const sliders = [...document.querySelectorAll<HTMLInputElement>("input[type=range]")];
    expect(sliders.map(({ dataset }) => dataset["answered"])).toEqual(["false", "false"]);
    sliders[1]!.dispatchEvent(new Event("pointerup"));
    expect(form().answers).toEqual({ c_d: 50 });
    sliders[0]!.value = "81";
    sliders[0]!.dispatchEvent(new Event("input"));
    expect(form().answers).toEqual({ a_b: 81, c_d: 50 });
  });

  it("takes the space bar for the position that it is at", () => {
    const { form } = drawn(trials["parallel"]!, "parallel");
    document.querySelectorAll("input")[2]!.dispatchEvent(new KeyboardEvent("keydown", { key: " " }));
    expect(form().answers).toEqual({ 2: 50 });
  });
});

describe("choosing", () => {
  it("takes a tap on a figure or on its button, and changes its mind", () => {
    const { form, parts } = drawn(trials["choose"]!, "choose");
    parts()[3]!.tap!();
    expect(form().answers).toEqual({ choice: 3 });
    expect(parts().map(({ chosen }) => chosen).indexOf(true)).toBe(3);
    document.querySelectorAll<HTMLInputElement>("input")[0]!.click();
    expect(form().answers).toEqual({ choice: -1 });
  });

  it("offers no way out where the study allows none", () => {
    drawn(trials["ab"]!, "ab");
    expect([...document.querySelectorAll("input")].map(({ value }) => value)).toEqual(["0", "1"]);
  });

  it("X itself cannot be chosen", () => {
    const { parts } = drawn(trials["abx"]!, "abx");
    expect(parts().map(({ head, tap }) => [head, tap !== undefined])).toEqual([["A", true], ["B", true], ["X", false]]);
  });
});

describe("a ranking", () => {
  const empty: Form = { answers: {}, touched: [], comment: "" };

  it("gives places in the order of the taps, and takes one back", () => {
    const form = ["2", "0", "3", "1"].reduce(toggle, empty);
    expect(order(form)).toEqual(["2", "0", "3", "1"]);
    expect(toggle(form, "0").answers).toEqual({ 2: 1, 3: 2, 1: 3 });
  });

  it("holds the ranks 1 … n after any taps and moves", () => {
    const random = seeded(3);
    let form = empty;
    for (let act = 0; act < 500; act++) {
      const id = String(Math.floor(random() * 5));
      form = random() < 0.3 ? toggle(form, id) : move(form, id, random() < 0.5 ? -1 : 1);
      const ranks = Object.values(form.answers).sort((one, other) => Number(one) - Number(other));
      expect(ranks).toEqual(ranks.map((_, index) => index + 1));
    }
  });

  it("a move changes places with the neighbour, and stops at the ends", () => {
    const form = ["a", "b", "c"].reduce(toggle, empty);
    expect(order(move(form, "c", -1))).toEqual(["a", "c", "b"]);
    expect(order(move(form, "a", -1))).toEqual(["a", "b", "c"]);
    expect(order(move(form, "c", 1))).toEqual(["a", "b", "c"]);
  });
});

it("setting and taking back leave the form that they came from as it was", () => {
  const before: Form = { answers: { a: 0 }, touched: [], comment: "" };
  const after = set(set(before, "a", 2), "b", ["x"]);
  expect(before).toEqual({ answers: { a: 0 }, touched: [], comment: "" });
  expect(after).toMatchObject({ answers: { a: 2, b: ["x"] }, touched: ["a", "b"] });
  expect(unset(after, "a")).toMatchObject({ answers: { b: ["x"] }, touched: ["b"] });
});

it("a chosen middle differs from a preselected one, a new answer from none", () => {
  const blank: Form = { answers: { a: 0 }, touched: [], comment: "" };
  expect(same(blank, { ...blank, comment: " " })).toBe(true);
  expect(same(blank, set(blank, "a", 0))).toBe(false);
  expect(same(blank, { ...blank, answers: { a: 0, b: 1 } })).toBe(false);
});
