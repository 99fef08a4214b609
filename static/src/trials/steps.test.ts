import { render } from "lit";
import { beforeEach, describe, expect, it } from "vitest";
import { empty, type Form } from "./kind";
import { answeredOf, focusNextOpen, stepLines, targetOf, type Line, type Steps } from "./steps";

const words = ["very", "rather", "neither", "rather", "very"];
const poles = [["sad", "happy"], ["weak", "strong"]] as const;
const lineOf = (left: string, right: string): Line => ({ id: `${left}_${right}`, left, right, name: `${left} or ${right}` });
let lines: Line[];
let form: Form;
let place: HTMLElement;

function draw(): void {
  const nameOf = (at: number, line: Line) => `${words[at]} ${at < 2 ? line.left : line.right}`;
  const steps: Steps = { lines, words, values: [-2, -1, 0, 1, 2], nameOf, tone: "bipolar" };
  render(stepLines(steps, form, (act) => { form = act(form); draw(); }), place);
}

const checked = () => [...document.querySelectorAll<HTMLInputElement>("input:checked")];
const input = (line: string, value: number) =>
  document.querySelector<HTMLInputElement>(`input[name="${line}"][value="${value}"]`)!;

function press(key: string): void {
  document.activeElement!.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
}

function begin(answers: Form["answers"], shown = poles.map(([left, right]) => lineOf(left, right))): void {
  place = document.createElement("div");
  document.body.replaceChildren(place);
  lines = shown;
  form = { ...empty(), answers };
  draw();
}

describe("a line whose middle is preselected", () => {
  beforeEach(() => begin({ sad_happy: 0, weak_strong: 0 }));

  it("begins with its middle untouched", () => {
    expect(checked().map(({ value, dataset }) => [value, dataset["touched"]])).toEqual([["0", "false"], ["0", "false"]]);
    expect(form.touched).toEqual([]);
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

  it("names every step in words", () => {
    const names = [...document.querySelectorAll('input[name="sad_happy"]')].map((step) => step.getAttribute("aria-label"));
    expect(names).toEqual(["very sad", "rather sad", "neither happy", "rather happy", "very happy"]);
  });
});

describe("a long list without a preselection", () => {
  const many = Array.from({ length: 41 }, (_, index) => lineOf(`a${index}`, `b${index}`));
  beforeEach(() => begin({}, many));

  it("begins with nothing chosen, and is entered in the middle", () => {
    expect(checked()).toEqual([]);
    const entries = [...document.querySelectorAll<HTMLInputElement>('input[tabindex="0"]')];
    expect(entries.map(({ value }) => value)).toEqual(many.map(() => "0"));
  });

  it("is answered by the keyboard alone, from one open line to the next", () => {
    expect(focusNextOpen(document.body, document.activeElement)).toBe(true);
    for (let index = 0; index < many.length; index++) {
      expect((document.activeElement as HTMLInputElement).name).toBe(many[index]!.id);
      press(String(1 + (index % 5)));
      expect(focusNextOpen(document.body, document.activeElement)).toBe(index + 1 < many.length);
    }
    expect(Object.values(form.answers)).toEqual(many.map((_, index) => (index % 5) - 2));
  });

  it("leads on to open lines before the present one once those after it are answered", () => {
    input("a40_b40", 1).click();
    input("a40_b40", 1).focus();
    focusNextOpen(document.body, document.activeElement);
    expect((document.activeElement as HTMLInputElement).name).toBe("a0_b0");
  });

  it("says how many lines are answered", () => {
    input("a3_b3", 1).click();
    const note = document.createElement("div");
    render(answeredOf(many, form), note);
    expect(note.textContent?.replace(/\s+/g, " ")).toContain("1 of 41 pairs answered");
  });
});

it("keys that mean nothing to a line are left to the browser", () => {
  for (const key of ["Tab", "Enter", "a", "0", "Escape", "F5", "12"]) expect(targetOf(key, 2, 5)).toBeNull();
});

it("zero is the tenth step where there are ten", () => {
  expect(targetOf("0", 2, 11)).toBe(9);
});
