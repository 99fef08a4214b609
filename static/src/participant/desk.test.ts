import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { desk, previewDesk } from "./desk";
import type { GivenAnswer } from "./course";

const fetched = vi.fn<(path: string, init: RequestInit) => Promise<Response>>();

beforeEach(() => {
  localStorage.clear();
  fetched.mockReset();
  vi.stubGlobal("fetch", fetched);
});
afterEach(() => vi.unstubAllGlobals());

const answered = (moves: number): GivenAnswer => ({
  trial_index: 0, revision: 1, answers: {}, touched: [], comment: "", rt_ms: 1, time_elapsed_ms: 1, client_time: "2026-11-22T12:00:00Z",
  record: { path: Array.from({ length: moves }, (_, ms): [number, string, number] => [ms, "quickness", 0.5]) },
}) as GivenAnswer;

it.each([[10, true], [5_000, undefined]])("an answer outlives its page only as far as a browser allows: %d moves", async (moves, keepalive) => {
  fetched.mockImplementation(() => Promise.resolve(new Response("{}")));
  const { outbox } = desk("token", () => {});
  outbox.put(answered(moves));
  await outbox.flush();
  expect(fetched).toHaveBeenCalledTimes(1);
  expect(fetched.mock.calls[0]![1].keepalive).toBe(keepalive);
  expect(outbox.waiting).toBe(0);
});

it.each([
  ["a session", () => desk("a token", () => {}), "/api/v1/sessions/a%20token/steps/2/motion"],
  ["a preview", () => previewDesk("/api/v1/studies/s/preview?part=p"), "/api/v1/studies/s/preview/steps/2/motion?part=p"],
])("%s asks for a motion, and hears how near it came", async (_, open, path) => {
  const headers = { "Manner-Distance": "0.0421", "Manner-Solved": "1" };
  fetched.mockResolvedValue(new Response(new Uint8Array([1, 2]), { headers }));
  const { glb, distance, solved } = await open().motion(2, { e0: 0.25 });
  expect([new Uint8Array(glb).length, distance, solved]).toEqual([2, 0.0421, true]);
  const [asked, init] = fetched.mock.calls[0]!;
  expect(asked).toBe(path);
  expect(JSON.parse(String(init.body))).toEqual({ values: { e0: 0.25 } });
});
