import { beforeEach, expect, it } from "vitest";
import { NOTHING_YET, TrialClock } from "./clock";

let time = 0;
let hidden = false;
const pass = (milliseconds: number) => void (time += milliseconds);
const hide = (value: boolean) => {
  hidden = value;
  document.dispatchEvent(new Event("visibilitychange"));
};

beforeEach(() => {
  time = 1_000;
  hidden = false;
  Object.defineProperty(document, "hidden", { configurable: true, get: () => hidden });
});

it("counts from the clip's first picture to the answer", () => {
  const clock = new TrialClock(() => time);
  clock.start();
  pass(2_500);
  expect(clock.read()).toEqual({ spent_ms: 2_500, hidden_ms: 0, blur_count: 0 });
});

it("counts apart how long the page was hidden, also while it still is", () => {
  const clock = new TrialClock(() => time);
  clock.start();
  pass(1_000);
  hide(true);
  pass(400);
  hide(false);
  pass(100);
  hide(true);
  pass(50);
  expect(clock.read()).toMatchObject({ spent_ms: 1_550, hidden_ms: 450 });
});

it("counts how often the window lost the focus", () => {
  const clock = new TrialClock(() => time);
  clock.start();
  window.dispatchEvent(new Event("blur"));
  window.dispatchEvent(new Event("blur"));
  expect(clock.read().blur_count).toBe(2);
});

it("goes on after a reload where the draft stopped", () => {
  const before = { spent_ms: 700, hidden_ms: 30, blur_count: 1 };
  const clock = new TrialClock(() => time);
  clock.start(before);
  pass(300);
  expect(clock.read()).toEqual({ spent_ms: 1_000, hidden_ms: 30, blur_count: 1 });
});

it("starts every trial anew, and says nothing between two", () => {
  const clock = new TrialClock(() => time);
  clock.start();
  pass(500);
  clock.stop();
  expect(clock.read()).toEqual(NOTHING_YET);
  pass(500);
  clock.start();
  pass(10);
  expect(clock.read().spent_ms).toBe(10);
});
