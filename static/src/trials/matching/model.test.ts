import { describe, expect, it } from "vitest";
import { empty, type Asked, type Step } from "../kind";
import { lasted, minutes, nearness } from "./face";
import { ended, moved, positions, rests, type Parameters } from "./model";
import { Stopwatch } from "./stopwatch";

const task: Parameters = {
  seconds: 300, threshold: 0.06, start: 0.5, example_figures: [],
  sliders: { weights: ["e0", "e1"].map((id) => ({ id, title: id, left: "", right: "" })), features: [{ id: "f", title: "f", left: "less", right: "more" }] },
};
const asked = (seen: boolean): Asked<Parameters> => {
  const step: Step = { index: 0, part: "p", kind: "match", figures: [], interface: "weights", seen };
  return { task, step };
};

it("every slider of the step's own interface begins at the start", () => {
  expect(positions(asked(true), empty())).toEqual({ e0: 0.5, e1: 0.5 });
});

it("a move answers with all sliders, and touches its own alone", () => {
  const form = moved(asked(true), empty(), "e1", 0.8, 1234.5);
  expect(form.answers).toEqual({ e0: 0.5, e1: 0.8 });
  expect(form.touched).toEqual(["e1"]);
  expect(form.trace).toEqual({ ms: 1234.5, path: [[1235, "e1", 0.8]] });
  expect(rests(asked(true), form)).toBe(false);
});

it("a guess is timed by its last move, and can be changed until it is handed in", () => {
  const form = moved(asked(false), moved(asked(false), empty(), "e1", 0.8, 1000), "e0", 0.1, 4000);
  expect(form.answers["seconds"]).toBe(4);
  expect(rests(asked(false), form)).toBe(false);
  const { answers, touched, comment } = form;
  expect(rests(asked(false), { answers, touched, comment })).toBe(true);
});

describe("the end", () => {
  it("has the sliders where the matching motion was made, though they have moved on", () => {
    const form = moved(asked(true), moved(asked(true), empty(), "e1", 0.8, 1000), "e1", 0.9, 1500);
    const done = ended(asked(true), form, { e0: 0.5, e1: 0.8 }, 1600);
    expect(done.answers).toEqual({ e0: 0.5, e1: 0.8, seconds: 1.6 });
    expect(done.trace!.path.at(-1)!.slice(1)).toEqual(["e1", 0.8]);
    expect(rests(asked(true), done)).toBe(true);
  });

  it("lasts no longer than the limit, however late the page noticed", () => {
    expect(ended(asked(true), empty(), { e0: 0.5, e1: 0.5 }, 999_999).answers["seconds"]).toBe(300);
  });
});

it("the clock goes on from before, and a rest does not count", () => {
  let now = 1000;
  const clock = new Stopwatch(() => now);
  clock.start(5000);
  now += 2000;
  expect(clock.ms).toBe(7000);
  clock.rest();
  now += 60_000;
  expect([clock.ms, clock.running]).toEqual([7000, false]);
  clock.start();
  now += 500;
  expect(clock.ms).toBe(7500);
});

it("the clock counts a second that has begun, and never below nothing", () => {
  expect([300_000, 299_999, 71_200, 1, 0, -500].map(minutes)).toEqual(["5:00", "5:00", "1:12", "0:01", "0:00", "0:00"]);
});

it("the time that a match took is said in minutes and seconds", () => {
  expect(lasted(72_000)).toBe("It matches. It took 1 min 12 s.");
  expect(lasted(4_400)).toBe("It matches. It took 4 s.");
});

it("nearer is fuller, the threshold is at the mark, and no distance empties the bar", () => {
  const shares = [0, 0.03, 0.06, 0.2, 2].map((metres) => nearness(metres, 0.06));
  expect(shares[0]).toBe(1);
  expect(shares[2]).toBeCloseTo(0.75, 12);
  expect([...shares].sort((one, other) => other - one)).toEqual(shares);
  expect(shares.at(-1)).toBeGreaterThan(0);
});
