import { render } from "lit";
import { afterEach, expect, test } from "vitest";
import { pseudo, speak } from "../words";
import { wordSliders, type SliderActs, type WordSlider } from "./sliders";

const SLIDERS: WordSlider[] = [
  { id: "quickness", title: "quickness", left: "slow", right: "fast", value: 0.25 },
  { id: "sad_happy", left: "sad", right: "happy", value: 0.5 },
];

afterEach(() => {
  document.body.replaceChildren();
  speak(null);
});

function shown(acts: Partial<SliderActs> = {}): HTMLElement {
  const place = document.createElement("div");
  document.body.append(place);
  render(wordSliders(SLIDERS, { set: () => {}, swap: () => {}, remove: () => {}, ...acts }, (id) => id === "sad_happy"), place);
  return place;
}

test("a slider says where it stands between its words", () => {
  const [quickness, mood] = shown().querySelectorAll("input");
  expect(quickness!.getAttribute("aria-label")).toBe("quickness");
  expect(quickness!.getAttribute("aria-valuetext")).toBe("25 from slow to fast");
  expect(mood!.getAttribute("aria-label")).toBe("sad or happy");
});

test("what is moved is told, and only loose sliders can be swapped and deleted", () => {
  const told: unknown[] = [];
  const place = shown({ set: (...told_) => told.push(told_), remove: (id) => told.push(id) });
  const input = place.querySelector("input")!;
  input.value = "0.7";
  input.dispatchEvent(new Event("input"));
  const buttons = place.querySelectorAll("button");
  expect([...buttons].map((button) => button.getAttribute("aria-label"))).toEqual(["Swap sad or happy for another pair", "Delete sad or happy"]);
  buttons[1]!.click();
  expect(told).toEqual([["quickness", 0.7], "sad_happy"]);
});

test("all that it says has gone through the catalog", () => {
  speak(pseudo());
  expect([...shown().querySelectorAll("button")].map((button) => button.textContent)).toEqual(["⟦Swap⟧", "⟦Delete⟧"]);
});
