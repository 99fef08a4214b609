import { expect, test } from "vitest";
import {
  added, carried, clustersOf, interfacesOf, lost, middle, mixed, moved, nameOf, placeOfExample, pointOf, removed, slidersOf, start, swapped, switched, weighed,
} from "./model";
import type { Space } from "./server";
import { languagesOf } from "./words";

const pair = (id: string, left: string, right: string, values: number[]) => ({ id, left: { en: left, fi: `${left} fi` }, right, values });
const adjectives = {
  primary: [
    { id: "quickness", title: "quickness", members: ["slow_fast", "dull_quick"], values: [0, 0.5, 1] },
    { id: "mood", title: "mood", members: ["sad_happy"], values: [0.2, 0.4, 0.9] },
  ],
  parameters: [pair("sad_happy", "sad", "happy", [0.2, 0.4, 0.9]), pair("slow_fast", "slow", "fast", [0, 0.4, 1]), pair("dull_quick", "dull", "quick", [0, 0.6, 1])],
};
const features = {
  primary: [],
  parameters: [{ id: "step", title: "Step length", about: "How far.", left: "less", right: "more", unit: "m", lowest: 0.2, highest: 0.8, values: [0, 1, 0.5] }],
};
const space = {
  name: "Walks",
  definition: { adjectives, features, examples: ["a", "b", "c"].map((clip) => ({ clip, name: `walk ${clip}`, keytimes: {} })) },
} as unknown as Space;
const bare = { ...space, definition: { ...space.definition, adjectives: null } } as unknown as Space;

test("a space begins in the middle of its primary sliders", () => {
  expect(pointOf(start(space))).toEqual({ interface: "adjectives", values: { quickness: 0.5, mood: 0.5 } });
  expect(pointOf(start(bare))).toEqual({ interface: "features", values: { step: 0.5 } });
  expect(interfacesOf(bare)).toEqual(["features", "weights"]);
});

test("pairs are added at the end, swapped in their place, and taken away", () => {
  const place = added(start(space), "sad_happy", 0.43);
  expect(Object.keys(place.adjectives)).toEqual(["quickness", "mood", "sad_happy"]);
  const other = swapped(added(place, "dull_quick", 0.5), "sad_happy", "slow_fast", 0.12345);
  expect(Object.entries(other.adjectives).slice(2)).toEqual([["slow_fast", 0.12], ["dull_quick", 0.5]]);
  expect(Object.keys(removed(other, "slow_fast").adjectives)).toEqual(["quickness", "mood", "dull_quick"]);
});

test("in another version lost sliders are gone, new primary ones stand in the middle, newcomers weigh nothing", () => {
  const place = added(moved(start(space), { quickness: 0.8, mood: 0.1 }), "sad_happy", 0.43);
  const { primary, parameters } = adjectives;
  const next = {
    ...space,
    definition: {
      ...space.definition,
      adjectives: { primary: [primary[0]!, { ...primary[1]!, id: "size" }], parameters: parameters.slice(1) },
      examples: [...space.definition.examples, { clip: "d", name: "walk d", keytimes: {} }],
    },
  } as unknown as Space;
  const there = carried(place, next);
  expect(there.adjectives).toEqual({ quickness: 0.8, size: 0.5 });
  expect(there.weights).toEqual({ ...place.weights, d: 0 });
  expect(carried(place, bare).by).toBe("features");
  expect(lost(space, next, "en")).toBe(`${slidersOf(space, "adjectives", "en")[1]!.title}, 1 pair`);
  expect(lost(space, space, "en")).toBe("");
});

test("a weight that is moved leaves the others their proportions, and their sum stays 1", () => {
  const begun = { ...start(space), weights: { a: 0.5, b: 0.3, c: 0.2 } };
  expect(weighed(begun, "a", 0.75).weights).toEqual({ a: 0.75, b: expect.closeTo(0.15), c: expect.closeTo(0.1) });
  expect(weighed(begun, "a", 1).weights).toEqual({ a: 1, b: 0, c: 0 });
});

test("weight that is taken from the only one goes to all others alike", () => {
  const only = { ...start(space), weights: { a: 1, b: 0, c: 0 } };
  expect(weighed(only, "a", 0.4).weights).toEqual({ a: 0.4, b: 0.3, c: 0.3 });
});

test("an example without weight is not asked for", () => {
  const place = { ...start(space), by: "weights" as const, weights: { a: 1, b: 0, c: 0 } };
  expect(pointOf(place)).toEqual({ interface: "weights", values: { a: 1 } });
});

test("another interface stands where the mix lies, and back where nothing was moved", () => {
  const begun = start(space);
  const byFeatures = switched(begun, "features", space, [0, 0.5, 0.5]);
  expect(byFeatures.features).toEqual({ step: 0.75 });
  expect(switched(byFeatures, "adjectives", space, [1, 0, 0])).toBe(begun);
  const back = switched(moved(byFeatures, { step: 1 }), "adjectives", space, [1, 0, 0]);
  expect(back.adjectives).toEqual({ quickness: 0, mood: 0.2 });
  expect(switched(begun, "weights", space, [0.2, 0.3, 0.5]).weights).toEqual({ a: 0.2, b: 0.3, c: 0.5 });
});

test("an example is gone to by its own values, and the middle is the middle again", () => {
  const place = placeOfExample(start(space), space, 2);
  expect(place.adjectives).toEqual({ quickness: 1, mood: 0.9 });
  expect(middle(place).adjectives).toEqual({ quickness: 0.5, mood: 0.5 });
  const weights = placeOfExample({ ...start(space), by: "weights" }, space, 1);
  expect(weights.weights).toEqual({ a: 0, b: 1, c: 0 });
  expect(mixed([0, 1, 0.5], [0.5, 0.25, 0.25])).toBeCloseTo(0.375);
});

test("a primary slider's ends are its members' words, in the chosen language", () => {
  const [quickness] = slidersOf(space, "adjectives", "fi");
  expect(quickness).toMatchObject({ title: "quickness", left: "slow fi, dull fi", right: "fast, quick" });
  expect(languagesOf(adjectives, features)).toEqual(["en", "fi"]);
});

test("pairs are listed by cluster", () => {
  const clusters = clustersOf(adjectives, slidersOf(space, "adjectives", "en"), "en");
  expect(clusters.map(({ title, pairs }) => [title, pairs.map(({ id }) => id)])).toEqual([["quickness", ["slow_fast", "dull_quick"]], ["mood", ["sad_happy"]]]);
});

test("a motion is called by what its sliders say", () => {
  expect(nameOf(moved(start(space), { quickness: 0, mood: 0.8 }), space)).toBe("slow, happy");
  expect(nameOf(start(space), space)).toBe("in the middle");
  expect(nameOf(moved(start(bare), { step: 1 }), bare)).toBe("more step length");
  expect(nameOf(weighed(start(space), "b", 0.9), space)).toBe("mix of walk b");
});
