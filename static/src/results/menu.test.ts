import { beforeEach, expect, it } from "vitest";
import { closingMenu } from "./menu";

let menu: HTMLDetailsElement;
const summary = (): HTMLElement => menu.querySelector("summary")!;

beforeEach(() => {
  document.body.innerHTML = `
    <details open><summary tabindex="0">Download</summary><a href="#one">One</a></details>
    <button>Elsewhere</button>`;
  menu = document.querySelector("details")!;
  closingMenu(menu);
});

it("closes on Escape and gives the focus back to its button", () => {
  const link = menu.querySelector("a")!;
  link.focus();
  link.dispatchEvent(new KeyboardEvent("keydown", { key: "Escape", bubbles: true }));
  expect(menu.open).toBe(false);
  expect(document.activeElement).toBe(summary());
});

it("stays open under other keys and while the focus moves within", () => {
  summary().focus();
  summary().dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowDown", bubbles: true }));
  menu.querySelector("a")!.focus();
  expect(menu.open).toBe(true);
});

it("closes when the focus or the pointer goes elsewhere, not when pressed inside", () => {
  const button = document.querySelector("button")!;
  menu.querySelector("a")!.dispatchEvent(new Event("pointerdown", { bubbles: true }));
  expect(menu.open).toBe(true);
  menu.querySelector("a")!.focus();
  button.focus();
  expect(menu.open).toBe(false);
  menu.open = true;
  button.dispatchEvent(new Event("pointerdown", { bubbles: true }));
  expect(menu.open).toBe(false);
});
