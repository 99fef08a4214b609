import { describe, expect, test } from "vitest";
import { choiceOf, endWords, keyOf, marked, matching, NOTHING, progressWords, requested, timeLeft, toggled, type Clip, type Planned } from "./model";

const planned = (source: string, preset: string): Planned => ({
  source, preset, source_name: source, preset_title: preset, name: `${source} · ${preset}`,
  tags: { set: "foerger-modified", emotion: preset }, clip: null,
});
const clip = (name: string, tags: Record<string, string> = {}, state = "kept"): Clip =>
  ({ id: name, name, tags, state }) as unknown as Clip;

describe("a choice", () => {
  test("takes a clip in and out again", () => {
    const once = toggled(NOTHING, "sources", "a");
    expect([...once.sources]).toEqual(["a"]);
    expect(toggled(once, "sources", "a")).toEqual(NOTHING);
    expect(NOTHING.sources.size).toBe(0);
  });

  test("made from a plan leaves out what the plan does not hold", () => {
    const choice = choiceOf([planned("f", "sad"), planned("f", "masculine"), planned("m", "sad")]);
    expect([...choice.sources]).toEqual(["f", "m"]);
    expect([...choice.leftOut]).toEqual([keyOf({ source: "m", preset: "masculine" })]);
    expect(choice.set).toBe("foerger-modified");
  });

  test("asks for every clip under its edited name and the set's tag", () => {
    const plan = [planned("f", "sad"), planned("f", "angry")];
    const names = new Map([[keyOf(plan[0]!), " Mourning "], [keyOf(plan[1]!), "  "]]);
    const items = requested({ ...choiceOf(plan), names, set: " pilot " }, plan);
    expect(items.map(({ name }) => name)).toEqual(["Mourning", "f · angry"]);
    expect(items[0]!.tags).toEqual({ set: "pilot", emotion: "sad" });
  });
});

test("clips are found by words of name and tags; those still to be confirmed are none", () => {
  const clips = [clip("acted_female_sad", { body: "female" }), clip("walk", { emotion: "sad" }), clip("new sad", {}, "to_confirm")];
  expect(matching(clips, "SAD").map(({ name }) => name)).toEqual(["acted_female_sad", "walk"]);
  expect(matching(clips, "sad female").map(({ name }) => name)).toEqual(["acted_female_sad"]);
  expect(matching(clips, "")).toHaveLength(2);
});

describe("progress", () => {
  test("is told in numbers", () => {
    expect(progressWords({ done: 7, failed: 0, total: 20 })).toBe("7 of 20 made");
    expect(progressWords({ done: 1999, failed: 1, total: 2000 })).toBe("1\u202f999 of 2\u202f000 made, 1 could not be made");
  });

  test("says how it ended", () => {
    const end = (state: "done" | "failed" | "cancelled", done: number, failed: number, total: number) =>
      endWords({ state, done, failed, total });
    expect(end("done", 20, 0, 20)).toBe("All 20 clips are made.");
    expect(end("done", 1, 0, 1)).toBe("The clip is made.");
    expect(end("done", 19, 1, 20)).toBe("19 clips made, 1 could not be made.");
    expect(end("failed", 0, 3, 3)).toBe("None of them could be made.");
    expect(end("cancelled", 4, 0, 20)).toBe("Stopped. 4 clips of 20 had been made and stay.");
    expect(end("cancelled", 0, 0, 20)).toBe("Stopped before anything was made.");
  });

  test("tells the time left by the pace of late", () => {
    expect(timeLeft([], 20)).toBe("");
    expect(timeLeft([{ time: 0, settled: 0 }], 20)).toBe("");
    let marks = marked([], { time: 0, settled: 0 });
    marks = marked(marks, { time: 10, settled: 10 });
    expect(timeLeft(marks, 60)).toBe("about 50 seconds left");
    expect(timeLeft(marks, 610)).toBe("about 10 minutes left");
    marks = marked(marks, { time: 20, settled: 110 }); // ten times faster
    expect(timeLeft(marks, 610)).toBe("about 50 seconds left");
    expect(timeLeft(marks, 130)).toBe("a few seconds left");
  });
});
