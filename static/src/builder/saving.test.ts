import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { Json } from "./model";
import { Saving } from "./saving";

const answer = (body: unknown, status = 200) => Promise.resolve(new Response(JSON.stringify(body), { status }));
const stored = (at: string) => answer({ saved_at: at, problems: [] });
const refused = (status: number) => answer({ error: { code: "x", message: "No.", where: null, mend: null } }, status);

describe("keeping the draft", () => {
  const fetched = vi.fn<(path: string, init: RequestInit) => Promise<Response>>();
  const sent = () => fetched.mock.calls.map(([, { body }]) => JSON.parse(String(body)) as Json);

  beforeEach(() => {
    vi.useFakeTimers();
    vi.stubGlobal("fetch", fetched.mockReset().mockImplementation(() => stored("one")));
  });
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  it("sends the newest of quick changes, and says which draft it was made from", async () => {
    const saving = new Saving("gaits", {}, "before", () => {});
    saving.keep({ title: "G" });
    saving.keep({ title: "Gaits" });
    expect(saving.isStored).toBe(false);
    await vi.runAllTimersAsync();
    expect(sent()).toEqual([{ title: "Gaits" }]);
    expect(fetched.mock.calls[0]![0]).toContain("seen=before");
    expect([saving.state, saving.isStored]).toEqual(["saved", true]);
    saving.keep({ title: "Other" });
    await saving.now();
    expect(fetched.mock.calls[1]![0]).toContain("seen=one");
  });

  it("tries again by itself while the server does not answer", async () => {
    fetched.mockImplementationOnce(() => Promise.reject(new TypeError("offline")));
    const saving = new Saving("gaits", {}, null, () => {});
    saving.keep({ title: "Gaits" });
    await vi.advanceTimersByTimeAsync(1000);
    expect(saving.state).toBe("failed");
    await vi.runAllTimersAsync();
    expect([saving.state, saving.failure]).toEqual(["saved", null]);
    expect(sent()).toEqual([{ title: "Gaits" }, { title: "Gaits" }]);
  });

  it("never writes over what somebody else saved", async () => {
    fetched.mockImplementation(() => refused(409));
    const saving = new Saving("gaits", {}, "before", () => {});
    saving.keep({ title: "Mine" });
    await vi.runAllTimersAsync();
    saving.keep({ title: "Mine again" });
    await vi.runAllTimersAsync();
    expect(fetched).toHaveBeenCalledTimes(1);
    expect([saving.state, saving.isStored]).toEqual(["failed", false]);
  });

  it("goes on once a refused text is mended", async () => {
    fetched.mockImplementationOnce(() => refused(422));
    const saving = new Saving("gaits", {}, null, () => {});
    saving.keep({ title: "bad" });
    await vi.runAllTimersAsync();
    expect(saving.failure?.status).toBe(422);
    saving.keep({ title: "good" });
    await vi.runAllTimersAsync();
    expect([saving.state, saving.failure]).toEqual(["saved", null]);
  });
});
