import { afterEach, expect, it, vi } from "vitest";
import { api } from "../api";
import { editOf, factsOf, isMade, named } from "./stimulus";

const authored = { made: { space: "Walks", values: { quickness: 0.8, large_size: 0.125 } }, name: "Target 1" };

afterEach(() => vi.restoreAllMocks());

it("tells what is made from what is a clip; a published version has both and is a clip", () => {
  expect([isMade("walk"), isMade({ clip: "walk" }), isMade(authored), isMade({ ...authored, clip: "ab12" })]).toEqual([false, false, true, false]);
});

it("says of a motion of a space which, and where on its sliders", () => {
  expect(factsOf(authored, undefined)).toEqual([["Made in", "Walks"], ["By", "adjectives"], ["Quickness", "0.80"], ["Large size", "0.13"]]);
  expect(factsOf(authored, undefined, "Walks, version 2")).toContainEqual(["Made in", "Walks, version 2"]);
  const weights = { made: { space: "Walks", interface: "weights", values: { ab: 0.5, cd: 0.5 } } };
  expect(factsOf(weights, undefined)).toContainEqual(["Examples", "2"]);
});

it("says of an edited clip from what, and by what", () => {
  expect(factsOf({ made: { source: "ab12", preset: "very_tired" } }, "walk")).toEqual([["Made from", "walk"], ["By", "Very tired"]]);
  expect(factsOf({ made: { source: "walk", operations: [{ operation: "path_length@1" }] } }, undefined)).toContainEqual(["By", "Path length"]);
});

it("makes a motion of a space by its recipe", async () => {
  const post = vi.spyOn(api, "post").mockResolvedValue({ source: "ab", operations: [{ operation: "blend@1" }] });
  const edit = await editOf(authored, undefined, async (name) => `${name}-3`);
  expect(edit).toEqual({ source: "ab", operations: [{ operation: "blend@1" }] });
  expect(post).toHaveBeenCalledWith("/api/v1/spaces/Walks-3/recipe", { interface: "adjectives", values: authored.made.values });
});

it("gives a name without losing the clip, and takes it back", () => {
  expect(named("walk", "Slow")).toEqual({ clip: "walk", name: "Slow" });
  expect(named({ clip: "walk", name: "Slow" }, "")).toEqual({ clip: "walk" });
});
