import { expect, test } from "vitest";
import { easedWords, faultWords, fineLines, sizeWords, timeWords, type Finding } from "./checks";

const finding = (kind: string, more: Partial<Finding> = {}): Finding => ({
  kind, part: "left foot", start: 4.9, end: 5, size: 0.007, unit: "m", limit: 0.005, ...more,
});

test("a fault names the part, what it does, how much and when", () => {
  const slip = finding("foot slip");
  expect([faultWords(slip), sizeWords(slip.size, slip.unit), timeWords(slip)]).toEqual(["Left foot slides", "7 mm", "at 4.9 s"]);
  expect(timeWords(finding("floor", { end: 6.2 }))).toBe("from 4.9 to 6.2 s");
});

test("sizes are told in the unit that a person thinks in", () => {
  expect([sizeWords(0.25, "m"), sizeWords(0.0054, "m"), sizeWords(12.4, "°"), sizeWords(1234.5, "m/s³")]).toEqual(["0.25 m", "5.4 mm", "12°", "1235 m/s³"]);
  expect([easedWords(0.4), easedWords(0)]).toEqual(["Eased off to 40 % of what it was.", "Only without the edit is all well. Undo brings it back."]);
});

test("every kind without a finding is told as fine", () => {
  expect(fineLines([])).toHaveLength(6);
  expect(fineLines([finding("foot slip"), finding("balance")])).toHaveLength(4);
});

test("a kind that is new is told by its own name", () => {
  expect(faultWords(finding("wobble"))).toBe("Left foot shows wobble:");
});
