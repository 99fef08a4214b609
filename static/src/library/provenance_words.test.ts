import { expect, test } from "vitest";
import { findingPlace, findingSize, rebuiltWords } from "./provenance_words";

const finding = { kind: "foot slip", part: "left foot", start: 0.4, end: 0.6, size: 0.0212, unit: "m", limit: 0.005 };

test("a finding says from when to when, and one moment once", () => {
  expect(findingPlace(finding)).toBe("0.40 to 0.60 s");
  expect(findingPlace({ ...finding, end: 0.4 })).toBe("0.40 s");
});

test("small lengths are told in millimetres, other units as they are", () => {
  expect(findingSize(finding)).toBe("21 mm; up to 5 mm would do");
  expect(findingSize({ ...finding, size: 749.98, limit: 600, unit: "m/s³" })).toBe("750 m/s³; up to 600 m/s³ would do");
  expect(findingSize({ ...finding, size: 12.04, limit: -3, unit: "°" })).toBe("12°; up to −3° would do");
});

test("the four ways in which a rebuild can end are told apart", () => {
  const words = [true, false].flatMap((same) => [true, false].map((other) => rebuiltWords(same, other)));
  expect(new Set(words).size).toBe(4);
});
