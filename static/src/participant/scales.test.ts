import { render } from "lit";
import { beforeEach, describe, expect, it } from "vitest";
import { blank, choose, type Form, type Parameters } from "../trials/semantic_differential";
import { scales, targetOf } from "./scales";

const study: Parameters = {
  question: "?",
  hint: "",
  scales: [
    { id: "sad_happy", left: "sad", right: "happy" },
    { id: "weak_strong", left: "weak", right: "strong" },
  ],
  steps: ["very", "rather", "neither", "rather", "very"],
  comment_label: "",
  comment_placeholder: "",
};
let form: Form;
let place: HTMLElement;

function draw(): void {
  const change = (scale: string, value: number) => {
    form = choose(form, scale, value);
    draw();
  };
  render(scales(study, form, change), place);
}

const checked = () => [...document.querySelectorAll<HTMLInputElement>("input:checked")];
const input = (scale: string, value: number) =>
  document.querySelector<HTMLInputElement>(`input[name="${scale}"][value="${value}"]`)!;

function press(key: string): void {
  document.activeElement!.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
}

beforeEach(() => {
  place = document.createElement("div");
  document.body.replaceChildren(place);
  form = blank(study);
  draw();
});

describe("a scale", () => {
  it("begins with its middle preselected and untouched", () => {
    expect(checked().map(({ value, dataset }) => [value, dataset["touched"]])).toEqual([["0", "false"], ["0", "false"]]);
    expect(form.touched).toEqual([]);
  });

  it("names every step in words", () => {
    const names = [...document.querySelectorAll('input[name="sad_happy"]')].map((step) => step.getAttribute("aria-label"));
    expect(names).toEqual(["very sad", "rather sad", "neither", "rather happy", "very happy"]);
  });

  it("moves by arrows and stops at its ends instead of jumping to the other pole", () => {
    input("sad_happy", 0).focus();
    for (let times = 0; times < 4; times++) press("ArrowRight");
    expect(form.answers).toEqual({ sad_happy: 2, weak_strong: 0 });
    expect(document.activeElement).toBe(input("sad_happy", 2));
    for (let times = 0; times < 9; times++) press("ArrowLeft");
    expect(form.answers["sad_happy"]).toBe(-2);
  });

  it("takes the digits 1 to 5 as places from the left", () => {
    input("weak_strong", 0).focus();
    for (const [key, value] of [["1", -2], ["2", -1], ["3", 0], ["4", 1], ["5", 2]] as const) {
      press(key);
      expect(form.answers["weak_strong"]).toBe(value);
    }
    press("6");
    expect(form.answers["weak_strong"]).toBe(2);
  });

  it("notes that the middle was chosen rather than left", () => {
    input("sad_happy", 0).focus();
    press(" ");
    expect(form).toMatchObject({ answers: { sad_happy: 0 }, touched: ["sad_happy"] });
    input("weak_strong", 0).click();
    expect(form.touched).toEqual(["sad_happy", "weak_strong"]);
  });

  it("has one chosen step, the one that the form says", () => {
    input("sad_happy", -1).click();
    input("sad_happy", 2).click();
    expect(checked().map(({ name, value }) => `${name} ${value}`)).toEqual(["sad_happy 2", "weak_strong 0"]);
  });
});

it("keys that mean nothing to a scale are left to the browser", () => {
  for (const key of ["Tab", "Enter", "a", "0", "Escape", "F5", "12"]) expect(targetOf(key, 2, 5)).toBeNull();
});
