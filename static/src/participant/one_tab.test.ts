import { expect, it, vi } from "vitest";
import { claimSession, type Channel } from "./one_tab";

/** Channels of one browser: a message reaches every other channel. */
function browser() {
  const open = new Set<Channel>();
  return (): Channel => {
    const channel: Channel = {
      onmessage: null,
      postMessage: (data) => {
        for (const other of open) if (other !== channel) other.onmessage?.({ data } as MessageEvent);
      },
      close: () => open.delete(channel),
    };
    open.add(channel);
    return channel;
  };
}

it("the newest tab counts, and each older one is told once", () => {
  vi.useFakeTimers();
  const open = browser();
  const lost = [vi.fn(), vi.fn(), vi.fn()];
  for (const tell of lost) {
    vi.advanceTimersByTime(10);
    claimSession("a", tell, open);
  }
  expect(lost.map((tell) => tell.mock.calls.length)).toEqual([1, 1, 0]);
  vi.useRealTimers();
});

it("a tab that was closed takes nothing away any more", () => {
  const open = browser();
  const lost = vi.fn();
  claimSession("a", lost, open)();
  claimSession("a", vi.fn(), open);
  expect(lost).not.toHaveBeenCalled();
});
