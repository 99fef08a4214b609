import { describe, expect, it } from "vitest";
import { FollowedPath } from "./path";

/** The last place of the path of a traveller, followed at a rate. */
function follow(way: (time: number) => [number, number], rate: number, until: number): Float32Array {
  const path = new FollowedPath();
  const out = new Float32Array(2);
  for (let step = 0; step <= until * rate; step += 1) path.follow(...way(step / rate), step / rate, out);
  return out;
}

describe("the path of a traveller whose way is not known beforehand", () => {
  it("begins under the traveller", () => {
    expect([...follow(() => [3, -2], 60, 0)]).toEqual([3, -2]);
  });

  it("does not lag behind an even pace, at any rate of poses", () => {
    for (const rate of [8, 30, 120]) {
      const [x, z] = follow((time) => [0.5 * time, 1.4 * time], rate, 8);
      expect(x).toBeCloseTo(4, 3);
      expect(z).toBeCloseTo(11.2, 3);
    }
  });

  it("leaves out a third of the steps' sway", () => {
    const places = Array.from({ length: 60 }, (_, k) =>
      follow((time) => [0.03 * Math.sin(2 * Math.PI * time), 1.4 * time], 60, 8 + k / 60),
    );
    expect(Math.max(...places.map(([x]) => Math.abs(x!)))).toBeLessThan(0.02);
  });

  it("stays near a traveller who stops, and comes to rest there", () => {
    const stopping = (time: number): [number, number] => [0, 1.4 * Math.min(time, 5)];
    for (let after = 0; after < 2; after += 0.1) {
      expect(Math.abs(follow(stopping, 60, 5 + after)[1]! - 7)).toBeLessThan(0.25);
    }
    expect(follow(stopping, 60, 15)[1]).toBeCloseTo(7, 3);
  });

  it("keeps a traveller who walks in a narrow circle over the disc", () => {
    const around = (time: number): [number, number] => [1.4 * Math.cos(time), 1.4 * Math.sin(time)];
    const [x, z] = follow(around, 60, 9);
    expect(Math.hypot(x! - 1.4 * Math.cos(9), z! - 1.4 * Math.sin(9))).toBeLessThan(0.3);
  });

  it("goes along at once with one who is put elsewhere or comes back after a while", () => {
    expect([...follow((time) => (time < 5 ? [0, time] : [40, 0]), 60, 5)]).toEqual([40, 0]);
    const path = new FollowedPath();
    const out = new Float32Array(2);
    for (const [z, time] of [[0, 0], [0.1, 0.1], [1, 9]]) path.follow(0, z!, time!, out);
    expect([...out]).toEqual([0, 1]);
  });
});
