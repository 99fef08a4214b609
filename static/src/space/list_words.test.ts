import { expect, test } from "vitest";
import { byName, examplesWords, madeWords, originWords } from "./list_words";
import type { ListedSpace } from "./server";

const space = (more: Partial<ListedSpace> = {}): ListedSpace => ({
  id: "a", name: "Walks", number: 1, newest: true, examples: 27, interfaces: ["adjectives", "features", "weights"], simulated: false,
  study: null, study_title: null, may_delete: true, made_by: "Ada", created_at: "2026-11-22T12:00:00Z", ...more,
});

test("versions stand under their name, the newest first, and what was made last on top", () => {
  const listed = [space({ number: 2 }), space({ name: "Runs" }), space({ number: 1 }), space({ number: 3 })];
  const names = byName(listed).map((versions) => [versions[0]!.name, versions.map(({ number }) => number)]);
  expect(names).toEqual([["Walks", [3, 2, 1]], ["Runs", [1]]]);
});

test("a space says how many examples it has, where its sliders come from, and who made it when", () => {
  expect([examplesWords(space()), examplesWords(space({ examples: 1 }))]).toEqual(["27 examples", "1 example"]);
  expect(originWords(space({ study: "gaits" }))).toBe("from a study of others");
  expect(originWords(space({ simulated: true }))).toBe("from simulated raters");
  expect(originWords(space({ interfaces: ["features", "weights"] }))).toBe("from clips alone");
  expect(madeWords(space())).toBe("by Ada, 22 November 2026");
  expect(madeWords(space({ made_by: null }))).toBe("comes with the server");
});
