import { beforeEach, expect, test } from "vitest";
import { dropDraft, findDraft, keepDraft } from "./draft";

const DRAFT = { steps: [{ operation: "tempo@1", parameters: { factor: 2 } }], name: "quick", preset: null };

beforeEach(() => localStorage.clear());

test("a draft comes back for its own clip alone, until it is dropped", () => {
  keepDraft("one", DRAFT);
  expect(findDraft("one")).toEqual(DRAFT);
  expect(findDraft("two")).toBeNull();
  dropDraft("one");
  expect(findDraft("one")).toBeNull();
});

test("what is no draft is left alone", () => {
  localStorage.setItem("manner-studio-draft:one", "{broken");
  localStorage.setItem("manner-studio-draft:two", '{"steps": 3}');
  expect([findDraft("one"), findDraft("two")]).toEqual([null, null]);
});
