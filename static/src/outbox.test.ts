import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { ApiError } from "./api";
import { Outbox, type Answer } from "./outbox";
import { Store } from "./participant/store";
import { DeviceStorage, seeded } from "./participant/testing";

const offline = () => new ApiError("offline", "no answer", null, null, 0);
const broken = () => new ApiError("internal", "broken", null, null, 500);
const answer = (trial_index: number, revision = 1, value = 0): Answer => ({ trial_index, revision, value });

/** Keeps what it was sent, as the real server does: once per trial and revision, the first counts. */
class Server {
  readonly rows = new Map<string, Answer>();
  requests = 0;

  take(sent: Answer): void {
    this.requests += 1;
    const key = `${sent.trial_index}.${sent.revision}`;
    const stored = this.rows.get(key);
    if (stored && JSON.stringify(stored) !== JSON.stringify(sent)) {
      throw new ApiError("already_answered", "another answer", null, null, 409, null, { stored });
    }
    this.rows.set(key, sent);
  }
}

function setUp(send: (answer: Answer) => Promise<unknown>, device = new DeviceStorage()) {
  const store = new Store("token", device);
  return { device, store, outbox: new Outbox({ store, send, random: () => 0.5 }) };
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

describe("an answer", () => {
  it("is on the device before put returns, even if the page dies at once", () => {
    const { outbox, device } = setUp(() => new Promise(() => {}));
    outbox.put(answer(3));
    expect(new Outbox({ store: new Store("token", device), send: async () => {} }).pending).toEqual([answer(3)]);
  });

  it("leaves the device only when the server has acknowledged it", async () => {
    let acknowledge = () => {};
    const { outbox } = setUp(() => new Promise<void>((resolve) => (acknowledge = resolve)));
    outbox.put(answer(0));
    await vi.advanceTimersByTimeAsync(1_000);
    expect(outbox.waiting).toBe(1);
    acknowledge();
    await outbox.flush();
    expect(outbox.waiting).toBe(0);
  });

  it("is sent again, ever more slowly, while the server cannot be reached", async () => {
    const times: number[] = [];
    const { outbox } = setUp(async () => {
      times.push(Date.now());
      throw offline();
    });
    outbox.put(answer(0));
    await vi.advanceTimersByTimeAsync(120_000);
    const gaps = times.slice(1).map((time, index) => time - (times[index] ?? 0));
    expect(outbox.failing).toBe(true);
    expect(gaps.slice(0, 4)).toEqual([375, 750, 1500, 3000]);
    expect(Math.max(...gaps)).toBe(15_000);
  });

  it("goes out at once when the connection is back, without waiting for its turn", async () => {
    let line = false;
    const { outbox } = setUp(async () => {
      if (!line) throw offline();
    });
    outbox.put(answer(0));
    await vi.advanceTimersByTimeAsync(60_000);
    line = true;
    const done = outbox.flush();
    await vi.advanceTimersByTimeAsync(0);
    await done;
    expect([outbox.waiting, outbox.failing]).toEqual([0, false]);
  });

  it("that the server refuses stays on the device and is named, and does not hold up the others", async () => {
    const server = new Server();
    const { outbox, store } = setUp(async (sent) => {
      if (sent.trial_index === 0) throw new ApiError("invalid", "No such step.", null, "Choose again.", 422);
      server.take(sent);
    });
    outbox.put(answer(0));
    outbox.put(answer(1));
    await outbox.flush();
    expect(outbox.refusal?.message).toBe("No such step.");
    expect([...server.rows.keys()]).toEqual(["1.1"]);
    expect(new Outbox({ store, send: async () => {} }).pending).toEqual([answer(0)]);
  });

  it("that was refused and then mended no longer waits, and another one still does", async () => {
    const { outbox } = setUp(async ({ trial_index, value }) => {
      if (value === 99) throw new ApiError("invalid", `Not 99 at ${trial_index}.`, null, null, 422);
    });
    outbox.put(answer(0, 1, 99));
    outbox.put(answer(1, 1, 99));
    await outbox.flush();
    outbox.put(answer(0, 2, 9));
    await outbox.flush();
    expect(outbox.pending).toEqual([answer(1, 1, 99)]);
    expect(outbox.refusal?.message).toBe("Not 99 at 1.");
    outbox.put(answer(1, 2, 9));
    await outbox.flush();
    expect([outbox.waiting, outbox.refusal]).toEqual([0, null]);
  });

  it("that another device gave first is taken from the server", async () => {
    const server = new Server();
    server.take(answer(0, 1, 2));
    const onConflict = vi.fn();
    const store = new Store("token", new DeviceStorage());
    const outbox = new Outbox({ store, send: async (sent) => server.take(sent), onConflict });
    outbox.put(answer(0, 1, -2));
    await outbox.flush();
    expect(onConflict).toHaveBeenCalledWith(answer(0, 1, -2), answer(0, 1, 2));
    expect(outbox.waiting).toBe(0);
    expect(server.rows.get("0.1")).toEqual(answer(0, 1, 2));
  });

  it("is kept in the page's memory where the device's storage is full", async () => {
    const device = new DeviceStorage();
    device.full = true;
    const server = new Server();
    const { outbox } = setUp(async (sent) => server.take(sent), device);
    outbox.put(answer(0));
    expect(outbox.waiting).toBe(1);
    await outbox.flush();
    expect(server.rows.size).toBe(1);
  });
});

it("a tab that has yielded sends nothing more", async () => {
  const server = new Server();
  const { outbox, device } = setUp(async (sent) => server.take(sent));
  outbox.stop();
  outbox.put(answer(0));
  await vi.advanceTimersByTimeAsync(60_000);
  expect(server.requests).toBe(0);
  expect(new Outbox({ store: new Store("token", device), send: async () => {} }).waiting).toBe(1);
});

it("keeps the answers of two sessions apart", () => {
  const device = new DeviceStorage();
  const [one, other] = ["one", "other"].map((token) => new Store(token, device));
  new Outbox({ store: one!, send: () => new Promise(() => {}) }).put(answer(0));
  expect(new Outbox({ store: other!, send: async () => {} }).waiting).toBe(0);
});

describe("whatever happens between the page and the server", () => {
  it.each(Array.from({ length: 60 }, (_, seed) => seed))("loses and doubles nothing (chance %i)", async (seed) => {
    const random = seeded(seed);
    const server = new Server();
    const device = new DeviceStorage();
    let trouble = true;
    /** Lost on the way there, lost on the way back, slow, broken, or fine. */
    const send = async (sent: Answer) => {
      const luck = trouble ? random() : 1;
      await new Promise((resolve) => setTimeout(resolve, luck * 3_000));
      if (luck < 0.2) throw offline();
      if (luck < 0.3) throw broken();
      server.take(sent);
      if (luck < 0.6) throw offline();
    };
    const open = () => new Outbox({ store: new Store("token", device), send, random });

    let page = open();
    const given: Answer[] = [];
    const revisions = new Map<number, number>();
    for (let step = 0; step < 60; step++) {
      if (random() < 0.6) {
        const trial = Math.floor(random() * 12);
        const revision = (revisions.get(trial) ?? 0) + 1;
        revisions.set(trial, revision);
        given.push(answer(trial, revision, random()));
        page.put(given.at(-1)!);
      } else if (random() < 0.5) {
        if (random() < 0.5) page.stop(); // a closed tab; otherwise the old page goes on beside the new one
        page = open();
        void page.flush();
      } else void page.flush();
      await vi.advanceTimersByTimeAsync(random() * 4_000);
      const safe = new Set([...server.rows.values(), ...page.pending].map((row) => JSON.stringify(row)));
      for (const row of given) expect(safe).toContain(JSON.stringify(row));
    }

    trouble = false;
    page = open();
    const done = page.flush();
    await vi.runAllTimersAsync();
    await done;
    expect(page.waiting).toBe(0);
    const byKey = (row: Answer) => row.trial_index * 1000 + row.revision;
    const stored = [...server.rows.values()].sort((one, other) => byKey(one) - byKey(other));
    expect(stored).toEqual([...given].sort((one, other) => byKey(one) - byKey(other)));
  });
});
