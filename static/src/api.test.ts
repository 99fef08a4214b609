import { afterEach, expect, test, vi } from "vitest";
import { api, ApiError, errorFrom } from "./api";

const answer = (status: number, body: unknown) =>
  vi.fn(async () => new Response(body === undefined ? "" : JSON.stringify(body), { status }));

afterEach(() => {
  vi.unstubAllGlobals();
  document.head.innerHTML = "";
});

test("a refusal keeps the server's code, place, mend and offer", async () => {
  const error = {
    code: "bvh_syntax",
    message: "A rotation is not a number.",
    where: { line: 217, column: 45 },
    mend: "Correct the number.",
    offer: "fill_gaps",
    stored: { revision: 1 },
  };
  vi.stubGlobal("fetch", answer(422, { error }));
  const caught = await api.post("/api/v1/imports", {}).catch((reason: unknown) => reason);
  expect(caught).toBeInstanceOf(ApiError);
  expect(caught).toMatchObject({
    code: "bvh_syntax",
    status: 422,
    where: { line: 217, column: 45 },
    mend: "Correct the number.",
    offer: "fill_gaps",
    detail: { stored: { revision: 1 } },
    transient: false,
  });
});

test("a lost connection is a transient error that says what to do", async () => {
  vi.stubGlobal("fetch", vi.fn(async () => Promise.reject(new TypeError("failed"))));
  const caught = (await api.get("/x").catch((reason: unknown) => reason)) as ApiError;
  expect(caught).toMatchObject({ code: "offline", status: 0, transient: true });
  expect(caught.message).toMatch(/connection/);
});

test("a page of a proxy instead of JSON still becomes an error with a message", () => {
  expect(errorFrom(502, "<html>Bad gateway</html>")).toMatchObject({ code: "unexplained", status: 502 });
});

test("writes carry the page's CSRF token and reads do not", async () => {
  document.head.innerHTML = '<meta name="csrf-token" content="signed">';
  const fetch = answer(200, {});
  vi.stubGlobal("fetch", fetch);
  await api.get("/a", { query: { tag: "sad", query: "", page: 2 } });
  await api.delete("/b");
  const [read, write] = fetch.mock.calls as unknown as [string, RequestInit][];
  expect(read?.[0]).toBe("/a?tag=sad&page=2");
  expect(read?.[1].headers).not.toHaveProperty("X-CSRF-Token");
  expect(write?.[1].headers).toHaveProperty("X-CSRF-Token", "signed");
});

test("an empty answer is undefined, not a parse error", async () => {
  vi.stubGlobal("fetch", answer(204, undefined).mockImplementation(async () => new Response(null, { status: 204 })));
  await expect(api.delete("/gone")).resolves.toBeUndefined();
});
