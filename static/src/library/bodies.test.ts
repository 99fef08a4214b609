import { expect, test, vi } from "vitest";
import { api } from "../api";
import { lines, onItsOwn, others, preview, recipe, sharedBy, type Body } from "./bodies";
import type { Clip } from "./model";

const clip = (id: string, skeleton: string, more: Partial<Clip> = {}): Clip => ({
  id, name: id, tags: {}, source: "sample", state: "kept", frames: 31, frame_time: 1 / 30, duration: 1.5, cyclic: false,
  stature: 1.5, poster_time: 0, skeleton_hash: skeleton, glb_url: "", figure_url: "", page_url: "", recipe_source: null, variant_of: null, ...more,
});
const body = (id: string, clips: number): Body => ({ id, clips, example: clip(`${id}_walk`, id, { stature: 1.74 }) });
const all = [body("adult", 42), body("child", 1)];
const fit = { same: false, fits: true, sentence: "", mean_direction: 0.005, greatest_direction: Math.PI / 90, slip: 0.0042, sole_height: 0.012, unmapped: [], resting: ["a", "b", "c", "d", "e"] };

test("a cycle is cut before the motion gets its new body", () => {
  const onto = { operation: "retarget@1", parameters: { clip: "x" } };
  expect(recipe({ duration: 1.5 }, "x", "none")).toEqual([onto]);
  expect(recipe({ duration: 1.5 }, "x", "found")).toEqual([{ operation: "cycle@1", parameters: {} }, onto]);
  expect(recipe({ duration: 1.5 }, "x", "whole")).toEqual([{ operation: "cycle@1", parameters: { start: 0, end: 1.5 } }, onto]);
});

test("beside a cycle on its new body stands the same cycle on its own", async () => {
  const asked = vi.spyOn(api, "bytesFor").mockResolvedValue(new ArrayBuffer(1));
  const file = vi.spyOn(api, "bytes").mockResolvedValue(new ArrayBuffer(2));
  const mine = clip("mine", "child", { glb_url: "/media/mine" });
  for (const cut of ["found", "whole"] as const) {
    await Promise.all([preview(mine, "x", cut), onItsOwn(mine, cut)]);
    const [moved, own] = asked.mock.calls.splice(0).map(([, body]) => (body as { operations: unknown[] }).operations);
    expect(own).toEqual(moved!.slice(0, -1));
  }
  await onItsOwn(mine, "none");
  expect(file).toHaveBeenCalledWith("/media/mine");
});

test("who shares a skeleton is told, whether the clip is kept already or not", () => {
  expect(sharedBy(clip("mine", "child"), all)).toContain("a skeleton of its own");
  expect(sharedBy(clip("new", "child", { state: "to_confirm" }), all)).toContain("1 other clip moves");
  expect(sharedBy(clip("walk", "adult"), all)).toContain("41 other clips move");
  expect(sharedBy(clip("stray", "giant"), all)).toContain("a skeleton of its own");
});

test("a clip's own body is not offered, and the one asked for stands first and shows itself", () => {
  const three = [...all, body("giant", 2)];
  expect(others(clip("mine", "child"), three).map(({ id }) => id)).toEqual(["adult", "giant"]);
  const asked = others(clip("mine", "child"), three, clip("giant_run", "giant"));
  expect(asked.map(({ example }) => example.id)).toEqual(["giant_run", "adult_walk"]);
});

test("the error stands in units that people know", () => {
  expect(lines(clip("mine", "child"), all[0]!, fit)).toEqual([
    ["Limbs turn", "2.0° at most; mean 0.3°"],
    ["Feet slide", "4.2 mm while they stand"],
    ["Soles", "12 mm off the floor in the mean"],
    ["Stature", "1.50 m, then 1.74 m"],
    ["At rest", "a, b, c and 2 more"],
  ]);
  expect(lines(clip("mine", "child"), all[0]!, { ...fit, slip: 3e-6, resting: [] })[1]).toEqual(
    ["Feet slide", "less than 0.1 mm while they stand"],
  );
});
