import { expect, test } from "vitest";
import { History } from "./history";

test("a drag is one entry, however many changes it made", () => {
  const history = new History(0);
  history.hold();
  for (let value = 1; value <= 30; value++) history.set(value, "pad", value * 5000);
  history.release();
  expect(history.present).toBe(30);
  history.undo();
  expect([history.present, history.canUndo]).toEqual([0, false]);
  history.redo();
  expect([history.present, history.canRedo]).toEqual([30, false]);
});

test("keys on one control join while they follow fast, and part after a rest or by another control", () => {
  const history = new History("a");
  history.set("b", "path", 0);
  history.set("c", "path", 500);
  history.set("d", "path", 5000);
  history.set("e", "timing", 5100);
  const seen = [];
  while (history.canUndo) {
    history.undo();
    seen.push(history.present);
  }
  expect(seen).toEqual(["d", "c", "a"]);
});

test("two drags of one control are two entries, and a change after an undo ends what could be redone", () => {
  const history = new History(0);
  for (const value of [1, 2]) {
    history.hold();
    history.set(value, "pad", value);
    history.release();
  }
  history.undo();
  expect(history.present).toBe(1);
  history.set(7, "pad", 3);
  expect(history.canRedo).toBe(false);
  history.undo();
  expect(history.present).toBe(1);
});

test("undo and redo at the ends change nothing", () => {
  const history = new History("only");
  history.undo();
  history.redo();
  expect([history.present, history.canUndo, history.canRedo]).toEqual(["only", false, false]);
});
