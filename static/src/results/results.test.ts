import { expect, test } from "vitest";
import { withFont } from "./chart";
import { choose, italics } from "./pole_table";
import { interval, number, percent } from "./words";

test("numbers have a true minus sign, and minus zero is zero", () => {
  expect([-1.364, -0.001, 0.5].map((value) => number(value))).toEqual(["−1.36", "0.00", "0.50"]);
  expect(number(0.5, 1, true)).toBe("+0.5");
});

test("what is not known is a dash, never zero", () => {
  expect([number(null), interval(null, 1), interval(-1, null)]).toEqual(["–", "–", "–"]);
  expect([interval(-1.5, 0.25), percent(0.456)]).toEqual(["−1.50 to 0.25", "46 %"]);
});

test("the symbols of tests stand in italics and the sentence keeps every character", () => {
  const text = "The clip “sad” was seen as sadder, Welch's t(42.7) = 8.13, p < .001, d = 1.16.";
  const parts = italics(text);
  const place = document.createElement("p");
  place.append(...parts);
  expect(place.textContent?.replaceAll("\u00a0", " ")).toBe(text);
  expect(place.textContent).toContain("p\u00a0<\u00a0.001"); // a line never breaks before the number
  expect([...place.querySelectorAll("em")].map((em) => em.textContent)).toEqual(["t", "p", "d"]);
});

test("choosing a row says its sentence and marks that row alone", () => {
  document.body.innerHTML = `<table><tbody>
    <tr class="chosen" data-sentence="one"><td><button aria-pressed="true">a</button></td></tr>
    <tr data-sentence="two"><td><button aria-pressed="false">b</button></td></tr></tbody></table><p></p>`;
  const table = document.querySelector("table")!;
  const rows = table.querySelectorAll("tr");
  choose(table, rows[1]!, document.querySelector("p")!);
  expect(document.querySelector("p")?.textContent).toBe("two");
  expect([...rows].map((row) => row.className)).toEqual(["", "chosen"]);
  expect([...table.querySelectorAll("button")].map((b) => b.getAttribute("aria-pressed"))).toEqual(["false", "true"]);
});

test("a chart takes the page's typeface and keeps the rest of its look", () => {
  const spec = { config: { font: "print", text: { font: "print", fontSize: 12 } } } as never;
  expect(withFont(spec, "page").config).toEqual({ font: "page", text: { font: "page", fontSize: 12 } });
});
