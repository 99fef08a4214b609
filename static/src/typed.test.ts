import { html, render } from "lit";
import { expect, test } from "vitest";
import { typed } from "./typed";

function page(): { box: HTMLInputElement; draw(value: string): void } {
  const place = document.body.appendChild(document.createElement("div"));
  const draw = (value: string) => render(html`<input ${typed(value)}>`, place);
  draw("0");
  return { box: place.querySelector("input")!, draw };
}

function type(box: HTMLInputElement, value: string): void {
  box.value = value;
  box.dispatchEvent(new Event("input"));
}

test("what is being typed outlives a page that is drawn anew", () => {
  const { box, draw } = page();
  type(box, "5");
  draw("0");
  draw("1");
  expect(box.value).toBe("5");
});

test("once it counts, the field shows what the page made of it", () => {
  const { box, draw } = page();
  type(box, "5");
  box.dispatchEvent(new Event("change"));
  draw("2"); // the most there is
  expect(box.value).toBe("2");
  type(box, "5");
  box.dispatchEvent(new Event("change"));
  draw("2"); // the same once more
  expect(box.value).toBe("2");
});

test("who leaves without a change leaves the field to the page", () => {
  const { box, draw } = page();
  type(box, "5");
  type(box, "0");
  box.dispatchEvent(new Event("blur"));
  draw("3");
  expect(box.value).toBe("3");
});
