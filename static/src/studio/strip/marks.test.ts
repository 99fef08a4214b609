import { expect, test } from "vitest";
import type { Finding } from "../checks";
import { marks } from "./marks";

const fault = (start: number, more: Partial<Finding> = {}): Finding => ({
  kind: "foot slip", part: "left foot", start, end: start + 0.1, size: 0.007, unit: "m", limit: 0.005, ...more,
});

test("a mark names the fault and its size", () => {
  expect(marks([fault(4)], 8, 640)[0]).toMatchObject({ words: "left foot slides 7 mm", labelled: true, before: false });
});

test("faults near each other share a mark, which names the worst", () => {
  const [mark, ...others] = marks([fault(4.1, { size: 0.02 }), fault(4), fault(4.2)], 8, 640);
  expect(others).toEqual([]);
  expect(mark!.findings).toHaveLength(3);
  expect(mark!.words).toBe("left foot slides 20 mm, and 2 more");
});

test("marks come in order of time, and every fault is in one of them", () => {
  const times = [7, 1, 3, 5, 0, 6.9];
  const found = marks(times.map((time) => fault(time)), 8, 640);
  expect(found.flatMap(({ findings }) => findings.map(({ start }) => start))).toEqual([...times].sort());
});

test("a label that has no room after its mark stands before it if there is room, or is left out", () => {
  const alone = marks([fault(7.8)], 8, 640);
  expect(alone[0]).toMatchObject({ labelled: true, before: true });
  const crowd = marks([fault(6.4), fault(7), fault(7.8)], 8, 640);
  expect(crowd.map(({ labelled }) => labelled)).toEqual([true, false, false]);
});

test("labels never lie over each other or the next mark", () => {
  for (let seed = 1; seed <= 40; seed += 1) {
    const times = Array.from({ length: 6 }, (_, k) => ((seed * 7919 * (k + 1)) % 800) / 100);
    const found = marks(times.map((time) => fault(time)), 8, 640);
    let free = -Infinity;
    for (const { findings, labelled, before, words } of found) {
      const at = findings[0]!.start * 80;
      const length = labelled ? 6.6 * words.length : 0;
      expect(before ? at - length : at - 11).toBeGreaterThanOrEqual(free - 1e-9);
      free = before ? at + 11 : at + 11 + length;
    }
  }
});
