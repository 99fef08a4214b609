import { expect, test, vi } from "vitest";
import { debounced, Latest } from "./latest";

test("one runs at a time, and of what is asked for meanwhile only the newest runs", async () => {
  const ends: (() => void)[] = [];
  const ran: number[] = [];
  const latest = new Latest<number>((value) => {
    ran.push(value);
    return new Promise((resolve) => ends.push(resolve));
  });
  for (const value of [1, 2, 3, 4]) latest.ask(value);
  expect(ran).toEqual([1]);
  ends[0]!();
  await vi.waitFor(() => expect(ran).toEqual([1, 4]));
  ends[1]!();
  await vi.waitFor(() => expect(latest.busy).toBe(false));
  latest.ask(5);
  expect(ran).toEqual([1, 4, 5]);
});

test("a debounced act comes once, with the newest, after it has been quiet", () => {
  vi.useFakeTimers();
  const act = vi.fn();
  const ask = debounced(act, 300);
  for (const value of [1, 2, 3]) {
    ask(value);
    vi.advanceTimersByTime(200);
  }
  expect(act).not.toHaveBeenCalled();
  vi.advanceTimersByTime(100);
  expect(act.mock.calls).toEqual([[3]]);
  vi.useRealTimers();
});
