import { describe, expect, it, vi } from "vitest";
import { Player, type Part } from "./player";

function playing(parts: Part[], loop = false): Player {
  const player = new Player();
  player.load(parts);
  player.loop = loop;
  player.play();
  return player;
}

const walk: Part = { duration: 1.1, cyclic: true };
const take: Part = { duration: 4, cyclic: false };

describe("the player's clock", () => {
  it("arrives at the same moment however many frames the display drew", () => {
    for (const rate of [30, 60, 144]) {
      const player = playing([take]);
      for (let frame = 0; frame < 2 * rate; frame += 1) player.advance(1 / rate);
      expect(player.currentTime).toBeCloseTo(2, 9);
    }
  });

  it("runs at the speed that was set", () => {
    const player = playing([take]);
    player.speed = 0.25;
    player.advance(0.8);
    expect(player.currentTime).toBeCloseTo(0.2, 9);
  });

  it("stands still while paused", () => {
    const player = playing([take]);
    player.advance(0.5);
    player.pause();
    player.advance(0.5);
    expect(player.currentTime).toBe(0.5);
  });

  it("stops on the last frame and says so once", () => {
    const player = playing([take]);
    const ended = vi.fn();
    player.onEnd = ended;
    for (let step = 0; step < 10; step += 1) player.advance(0.9);
    expect([player.currentTime, player.paused, ended.mock.calls.length]).toEqual([4, true, 1]);
  });

  it("begins anew when played at the end", () => {
    const player = playing([take]);
    for (let step = 0; step < 5; step += 1) player.advance(1);
    player.play();
    expect([player.currentTime, player.paused]).toEqual([0, false]);
  });

  it("counts on through the cycles of a cyclic clip, so that its way goes on", () => {
    const player = playing([walk], true);
    for (let step = 0; step < 50; step += 1) player.advance(0.1);
    expect(player.elapsed).toBeCloseTo(5, 9);
    expect(player.currentTime).toBeCloseTo(5 - 4 * 1.1, 9);
  });

  it("cuts back to the start where a looped clip is no cycle", () => {
    const player = playing([take], true);
    for (let step = 0; step < 45; step += 1) player.advance(0.1);
    expect(player.elapsed).toBeCloseTo(0.5, 9);
  });

  it("lasts as long as the longest of several clips, and is endless only if all are", () => {
    const player = playing([walk, take]);
    expect([player.duration, player.endless]).toEqual([4, false]);
  });

  it("counts every start from the first frame, loops included", () => {
    const starts = vi.fn();
    const player = new Player();
    player.load([walk]);
    player.loop = true;
    player.onStart = starts;
    player.play();
    for (let step = 0; step < 24; step += 1) player.advance(0.1);
    player.replay();
    expect(starts).toHaveBeenCalledTimes(4); // play, two loops, replay
  });

  it("does not skip ahead after the computer slept", () => {
    const player = playing([take]);
    player.advance(3600);
    expect(player.currentTime).toBe(1);
  });

  it("keeps a wanted moment within the clip, whatever is asked", () => {
    const player = playing([take]);
    const arrivals = [-1, 2.5, 99, NaN].map((wanted) => {
      player.seek(wanted);
      return player.currentTime;
    });
    expect(arrivals).toEqual([0, 2.5, 4, 0]);
  });
});

describe("another clip in the place of the one that plays", () => {
  it("goes on from the same moment, or from its end where it is shorter", () => {
    const player = playing([take]);
    player.advance(0.9);
    player.swap([{ duration: 3, cyclic: false }]);
    expect([player.currentTime, player.paused]).toEqual([0.9, false]);
    player.swap([{ duration: 0.5, cyclic: false }]);
    expect([player.currentTime, player.paused]).toEqual([0.5, false]);
  });

  it("keeps the count of cycles where they are as long as before", () => {
    const player = playing([walk], true);
    for (let k = 0; k < 10; k += 1) player.advance(0.5);
    player.swap([{ ...walk }]);
    expect(player.elapsed).toBeCloseTo(5, 9);
    player.swap([{ duration: 2, cyclic: true }]);
    expect(player.elapsed).toBeCloseTo(5 % 1.1, 9);
  });
});
