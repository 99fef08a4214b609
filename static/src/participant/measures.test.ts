import { expect, it } from "vitest";
import { measures, sum, UNWATCHED, watched, type Viewer, type Watched } from "./measures";

const viewer = {
  statistics: { plays: 2, viewingMs: 1234, cameraMoves: 1, droppedFrames: 5, tier: "full" },
  paused: true, play: () => {}, pause: () => {},
} satisfies Viewer;
const attention = { spent_ms: 2000.04, hidden_ms: 100, blur_count: 1 };
const record = (changes: Partial<Watched>) =>
  measures({ attention, elapsed: 5000, viewer, viewing: watched(viewer), figures: [], start: {}, ...changes }).record;

it("a trial says how its figure was watched, in the server's words", () => {
  expect(record({})).toMatchObject({
    plays: 2, viewing_ms: 1234, camera_moves: 1, dropped_frames: 5, tier: "full", hidden_ms: 100, blur_count: 1,
    viewport: { width: innerWidth, height: innerHeight, pixel_ratio: devicePixelRatio },
  });
});

it("a page without figures says nothing about watching", () => {
  const found = record({ viewer: null, viewing: UNWATCHED });
  for (const name of ["plays", "viewing_ms", "tier", "figure_ms"]) expect(found).not.toHaveProperty(name);
  expect(found.hidden_ms).toBe(100);
});

it("a device whose clock was years off at first hands in a time that the server takes", () => {
  const years = 56 * 365 * 86_400_000;
  const found = measures({ attention, elapsed: years, viewer: null, viewing: UNWATCHED, figures: [], start: {} });
  expect(found.time_elapsed_ms).toBe(1e10);
  expect(found.rt_ms).toBe(2000);
});

it("of several figures it says each one's time, of one alone it does not", () => {
  expect(record({ figures: [10.04, 20] }).figure_ms).toEqual([10, 20]);
  expect(record({ figures: [10] })).not.toHaveProperty("figure_ms");
});

it("where sliders showed a position before they were touched is kept, and nothing where they showed none", () => {
  expect(record({ start: { sad_happy: 63 } }).start).toEqual({ sad_happy: 63 });
  expect(record({})).not.toHaveProperty("start");
});

it("what was watched before a reload counts as well", () => {
  expect(sum({ plays: 1, viewing_ms: 100, camera_moves: 0, dropped_frames: 2 }, watched(viewer))).toEqual({
    plays: 3, viewing_ms: 1334, camera_moves: 1, dropped_frames: 7,
  });
});
