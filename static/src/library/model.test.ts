import { expect, test } from "vitest";
import { caption, counted, filtersOf, find, framesPerSecond, type Clip } from "./model";

const clip = (name: string, tags: Record<string, string>, more: Partial<Clip> = {}): Clip => ({
  id: name, name, tags, source: "sample", state: "kept", frames: 31, frame_time: 1 / 30, duration: 1,
  cyclic: true, stature: 1.6, poster_time: 0, skeleton_hash: "", glb_url: "", figure_url: "", page_url: "",
  recipe_source: null,
  variant_of: null,
  ...more,
});
const clips = [
  clip("walk_a", { set: "A", style: "proud", body: "adult" }),
  clip("walk_b", { set: "B", emotion: "sad", speed: "slow" }),
  clip("acted_c", { set: "acted", emotion: "sad", body: "female" }),
  clip("bow", { set: "gesture", body: "adult" }),
  clip("mine", {}, { source: "imported", state: "to_confirm" }),
  clip("walk_b_softer", { emotion: "relaxed" }, { source: "edited", recipe_source: "walk_b" }),
];

test("filters count every clip once under All and leave empty families out", () => {
  expect(filtersOf(clips).map(({ label, count }) => [label, count])).toEqual([
    ["All", 6], ["Styles", 1], ["Emotions", 1], ["Acted", 1], ["Gestures", 1], ["Imported", 1],
    ["Edited", 1],
  ]);
  expect(filtersOf(clips.slice(0, 1)).map(({ label }) => label)).toEqual(["All", "Styles"]);
});

test("a clip that waits to be confirmed stands first", () => {
  expect(find(clips, "", "")[0]?.name).toBe("mine");
});

test("every word of a query must be in the name or a tag, whatever its case", () => {
  expect(find(clips, "", "SAD").map(({ name }) => name)).toEqual(["walk_b", "acted_c"]);
  expect(find(clips, "", "sad female").map(({ name }) => name)).toEqual(["acted_c"]);
  expect(find(clips, "emotions", "sad").map(({ name }) => name)).toEqual(["walk_b"]);
  expect(find(clips, "", "nothing like it")).toEqual([]);
});

test("a caption says what is shown, and leaves the ordinary speed out", () => {
  expect(caption(clips[1]!)).toBe("sad · slow · 1.0 s");
  expect(caption(clip("x", { set: "B", emotion: "angry", speed: "normal" }))).toBe("angry · 1.0 s");
  expect(caption(clips[2]!)).toBe("sad · female · 1.0 s");
  expect(caption(clips[4]!)).toBe("1.0 s");
  expect(caption(clips[5]!)).toBe("relaxed · edited · 1.0 s");
});

test("frame rates that are nearly whole are said whole", () => {
  expect(framesPerSecond(0.0333333)).toBe("30 fps");
  expect(framesPerSecond(1 / 119.88)).toBe("119.9 fps");
});

test("one is singular, none and many are plural", () => {
  expect([0, 1, 3].map((count) => counted(count, "repair"))).toEqual(["0 repairs", "1 repair", "3 repairs"]);
});
