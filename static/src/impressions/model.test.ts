import { expect, test } from "vitest";
import { comparableName, clustersOfLeaves, counted, groupOf, pairWords, reaches, reasons, remembered, shade, share, spans, textOf, type Pair } from "./model";

const pair = (id: string, more: Partial<Pair> = {}): Pair =>
  ({ id, left: { en: "slow", fi: "hidas" }, right: "fast", peak: 1.2, spread: 0.5, dropped: null, cluster: 0, moved: false, ...more }) as Pair;

test("a pair is read in English, or in the language that stands first", () => {
  expect(pairWords(pair("a"))).toBe("slow – fast");
  expect(textOf({ fi: "hidas", ja: "遅い" })).toBe("hidas");
});

test("what cannot pass 1 has no needless zero, and what is not known is a dash", () => {
  expect([0, 0.125, 0.5, 1, -0.25, null, undefined].map(share)).toEqual([".00", ".13", ".50", "1.00", "−.25", "–", "–"]);
});

test("a value lies between two neighbours of the ramp, the middle exactly on the grey", () => {
  expect(shade(0)).toEqual({ gap: 0, into: 0 });
  expect(shade(0.5)).toEqual({ gap: 2, into: 0 });
  expect(shade(1)).toEqual({ gap: 3, into: 1 });
  expect(shade(0.375)).toEqual({ gap: 1, into: 0.5 });
  expect(shade(2)).toEqual(shade(1));
});

test("four groups have colours of their own, more begin anew, and none is the rest's", () => {
  expect([0, 1, 2, 3, 4, null].map(groupOf)).toEqual([1, 2, 3, 4, 1, 5]);
});

test("neighbours of one cluster share a bracket; one moved by hand stands apart", () => {
  expect(spans([0, 0, 1, 0])).toEqual([{ cluster: 0, from: 0, length: 2 }, { cluster: 1, from: 2, length: 1 }, { cluster: 0, from: 3, length: 1 }]);
});

test("clusters follow the tree's order, not the questionnaire's", () => {
  const pairs = [pair("a", { cluster: 1 }), pair("b", { cluster: 0 }), pair("c", { cluster: null, dropped: "no" })];
  expect(clustersOfLeaves({ leaves: ["b", "a"], pairs })).toEqual([0, 1]);
});

test("every pair lies on its scale", () => {
  const pairs = [pair("a", { peak: 2.9, spread: 2.4 }), pair("b", { peak: null, spread: null })];
  expect(reaches({ pairs, reach: 3 })).toEqual({ peak: 3, spread: 2.5 });
  expect(reaches({ pairs: [pair("a")], reach: 2 })).toEqual({ peak: 2, spread: 1.5 });
});

test("a dropped pair says in few words which threshold it fails, else in the server's", () => {
  const choices = { least_peak: 1, most_spread: 0.85, clusters: 4, names: {}, moved: {} };
  const why = (more: Partial<Pair>) => reasons(pair("a", more), choices);
  expect(why({})).toBeNull();
  expect(why({ peak: 0.4, dropped: "…" })).toBe("no clip stands out");
  expect(why({ peak: 0.4, spread: 1, dropped: "…" })).toBe("no clip stands out, people disagree");
  expect(why({ peak: null, spread: null, dropped: "Nobody rated it." })).toBe("Nobody rated it.");
});

test("names and moves that the present cut has no place for are remembered", () => {
  const before = { names: { a: "speed", b: "size" }, moved: { c: "a" } };
  const now = remembered(before, { names: { d: "Speed" }, moved: { e: "b" } } as never);
  expect(now).toEqual({ names: { b: "size", d: "Speed" }, moved: { c: "a", e: "b" } });
});

test("small numbers are words", () => {
  expect([1, 4, 13].map((count) => counted(count, "cluster"))).toEqual(["one cluster", "four clusters", "13 clusters"]);
});

test("a study's part is named in the menu only where it has several", () => {
  const [a, b, c] = [["one", "walks"], ["one", "tall_runs"], ["two", "walks"]].map(([slug, part]) => ({ slug: slug!, title: slug!, part: part! }));
  expect([a!, b!, c!].map((one) => comparableName(one, [a!, b!, c!]))).toEqual(["one · walks", "one · tall runs", "two"]);
});
