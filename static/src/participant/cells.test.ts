import { html, render } from "lit";
import { beforeEach, expect, it, vi } from "vitest";
import type { CellParts } from "../trials/kind";
import { cellPlaces, cells } from "./cells";

/** Cells of 100 × 200, side by side; the one at `shorter` is lower, as one with a longer caption below it is. */
const SHORTER = 2;
let taps: (() => void)[];
let place: HTMLElement;

function draw(count: number, seen: (place: number) => boolean = () => true, says = true): void {
  const parts = taps.slice(0, count).map((tap, index): CellParts => ({ head: String(index + 1), tap }));
  const viewer = html`<motion-viewer></motion-viewer>`;
  render(cells({ parts, viewer, seen, says }), place);
  [...document.querySelectorAll(".cell-stage")].forEach((stage, index) => {
    const height = index === SHORTER ? 180 : 200;
    stage.getBoundingClientRect = () => new DOMRect(10 + 100 * index, 20, 100, height);
  });
  grid().getBoundingClientRect = () => new DOMRect(10, 20, 100 * count, 200);
}

const grid = () => document.querySelector(".cells")!;
const viewer = () => document.querySelector("motion-viewer")!;
const point = (type: string, clientX: number, clientY: number) => new MouseEvent(type, { bubbles: true, clientX, clientY });

beforeEach(() => {
  place = document.createElement("div");
  document.body.replaceChildren(place);
  taps = Array.from({ length: 10 }, () => vi.fn());
});

it("a tap on a figure means its cell", () => {
  draw(3);
  viewer().dispatchEvent(point("pointerdown", 150, 60));
  viewer().dispatchEvent(point("click", 151, 61));
  expect(taps.map((tap) => vi.mocked(tap).mock.calls.length)).toEqual([0, 1, 0, 0, 0, 0, 0, 0, 0, 0]);
});

it("a drag that turns the figures chooses none", () => {
  draw(3);
  viewer().dispatchEvent(point("pointerdown", 120, 60));
  viewer().dispatchEvent(point("click", 180, 60));
  for (const tap of taps) expect(tap).not.toHaveBeenCalled();
});

it("the digits 1 … 9 and 0 mean the first ten, but not while the figures are played with", () => {
  draw(10);
  const press = (from: Element, key: string) => from.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
  press(document.querySelector(".cell")!, "3");
  press(document.querySelector(".cell")!, "0");
  press(viewer(), "5");
  expect(taps.map((tap) => vi.mocked(tap).mock.calls.length)).toEqual([0, 0, 1, 0, 0, 0, 0, 0, 0, 1]);
});

it("a digit without a figure means nothing", () => {
  draw(2);
  document.querySelector(".cell")!.dispatchEvent(new KeyboardEvent("keydown", { key: "3", bubbles: true }));
  for (const tap of taps) expect(tap).not.toHaveBeenCalled();
});

it("all figures are drawn in one size, each at the bottom of its cell", () => {
  draw(3);
  expect(cellPlaces(grid())).toEqual([
    { x: 0, y: 20, width: 100, height: 180 },
    { x: 100, y: 20, width: 100, height: 180 },
    { x: 200, y: 0, width: 100, height: 180 },
  ]);
});

it("says of a figure that it is not yet seen until it is, and on pages to read nothing", () => {
  draw(2, (index) => index === 0);
  expect([...document.querySelectorAll(".cell")].map((cell) => cell.textContent!.includes("not yet seen"))).toEqual([false, true]);
  draw(2, () => false, false);
  expect(place.textContent).not.toContain("not yet seen");
});
