import { expect, test } from "vitest";
import { contactsOf, mixedKeytimes, rowsOf, steppedTime } from "./keytimes";

const walk = { left_strike: 0.9, left_off: 0.5, right_strike: 0.4, right_off: 0.1 };

test("a foot stands from its strike to its leaving, over the end of the cycle where need be", () => {
  expect(contactsOf(walk, 1)).toEqual({ left: [[0, 0.5], [0.9, 1]], right: [[0, 0.1], [0.4, 1]] });
  expect(contactsOf({}, 1)).toEqual({ left: [], right: [] });
});

test("a mix begins with the left strike; its events are weighted means", () => {
  const other = { left_strike: 0, left_off: 1.2, right_strike: 1, right_off: 0.2 };
  const mixed = mixedKeytimes([
    { keytimes: walk, duration: 1, weight: 0.25 }, { keytimes: other, duration: 2, weight: 0.75 }, { keytimes: {}, duration: 3, weight: 0 },
  ]);
  expect(mixed).toEqual({
    left_strike: 0, left_off: expect.closeTo(0.25 * 0.6 + 0.75 * 1.2), right_strike: expect.closeTo(0.25 * 0.5 + 0.75), right_off: expect.closeTo(0.25 * 0.2 + 0.75 * 0.2),
  });
});

test("without events of every example in it a mix has none", () => {
  expect(mixedKeytimes([{ keytimes: walk, duration: 1, weight: 0.5 }, { keytimes: {}, duration: 1, weight: 0.5 }])).toEqual({});
});

test("events stand in a row for each foot", () => {
  expect(rowsOf({ ...walk, jump: 0.3 }).map(({ title, events }) => [title, events.map(({ word }) => word)])).toEqual([
    ["Events", ["jump"]], ["Left events", ["off", "strike"]], ["Right events", ["off", "strike"]],
  ]);
});

test("keys move an event by hundredths of a second", () => {
  expect(steppedTime(0.5, "ArrowRight", false)).toBeCloseTo(0.51);
  expect(steppedTime(0.5, "ArrowLeft", true)).toBeCloseTo(0.45);
  expect(steppedTime(0.5, "Enter", false)).toBeNull();
});
