import { describe, expect, it } from "vitest";
import { Statistics } from "./statistics";
import { TIER_KEY, TierChooser } from "./tier";

function store(value?: string) {
  const values = new Map(value === undefined ? [] : [[TIER_KEY, value]]);
  return {
    getItem: (key: string) => values.get(key) ?? null,
    setItem: (key: string, text: string) => void values.set(key, text),
  };
}

describe("what is counted", () => {
  it("adds up seen time and the frames of sixty a second that were missed", () => {
    const counts = new Statistics();
    for (const interval of [16.7, 16.7, 50, 33.3]) counts.countInterval(interval);
    const report = counts.report("full");
    expect([report.viewingMs, report.droppedFrames]).toEqual([117, 3]);
  });

  it("calls no frame dropped on a display of 120 a second", () => {
    const counts = new Statistics();
    for (let k = 0; k < 120; k += 1) counts.countInterval(8.33);
    expect(counts.report("full").droppedFrames).toBe(0);
  });

  it("averages the work of frames, and knows none before the first", () => {
    const counts = new Statistics();
    expect(counts.report("plain").mainThreadMs).toBe(0);
    counts.countWork(1);
    counts.countWork(2);
    expect(counts.report("plain").mainThreadMs).toBe(1.5);
  });

  it("keeps how the view went, and nothing of a view that stays", () => {
    const counts = new Statistics();
    counts.reset(1000);
    for (const now of [1000, 1016, 1500]) counts.countSight(32, 7, 1, now);
    expect(counts.report("full").camera).toEqual([]);
    counts.countSight(40.04, 7, 1, 3000);
    expect(counts.report("full").camera).toEqual([[0, 32, 7, 1], [1950, 32, 7, 1], [2000, 40, 7, 1]]);
  });

  it("keeps beginning and end of any view within two hundred points", () => {
    const counts = new Statistics();
    counts.reset(0);
    for (let frame = 0; frame <= 6000; frame += 1) counts.countSight(frame / 20 - 150, 7, 1, frame * 16);
    const { camera } = counts.report("full");
    expect(camera.length).toBeLessThanOrEqual(200);
    expect(camera.length).toBeGreaterThan(50);
    expect([camera[0]![1], camera.at(-1)![1]]).toEqual([-150, 150]);
    const times = camera.map(([at]) => at);
    expect([...times].sort((a, b) => a - b)).toEqual(times);
  });

  it("starts from nothing for each clip", () => {
    const counts = new Statistics();
    counts.countPlay();
    counts.countCameraMove();
    counts.countFrame();
    counts.reset();
    const { plays, cameraMoves, frames } = counts.report("full");
    expect([plays, cameraMoves, frames]).toEqual([0, 0, 0]);
  });
});

describe("the choice of shading", () => {
  const feed = (chooser: TierChooser, interval: number, frames: number) =>
    Array.from({ length: frames }, () => chooser.note(interval)).filter(Boolean).length;

  it("stays rich on a device that keeps up", () => {
    const chooser = new TierChooser(store());
    expect([feed(chooser, 17, 200), chooser.tier]).toEqual([0, "full"]);
  });

  it("turns plain once on a device that does not, within thirty frames, and remembers it", () => {
    const kept = store();
    const chooser = new TierChooser(kept);
    expect([feed(chooser, 40, 34), chooser.tier]).toEqual([1, "plain"]);
    expect(new TierChooser(kept).tier).toBe("plain");
  });

  it("does not wait for thirty frames of a slide show", () => {
    const chooser = new TierChooser(store());
    feed(chooser, 900, 5);
    expect(chooser.tier).toBe("plain");
  });

  it("forgives the first frames, which compile the shaders", () => {
    const chooser = new TierChooser(store());
    feed(chooser, 900, 4);
    feed(chooser, 17, 60);
    expect(chooser.tier).toBe("full");
  });

  it("begins plain where the processor draws, unless told otherwise", () => {
    expect(new TierChooser(store(), true).tier).toBe("plain");
    expect(new TierChooser(store("full"), true).tier).toBe("full");
  });
});
