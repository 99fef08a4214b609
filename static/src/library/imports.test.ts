import { expect, test } from "vitest";
import { ApiError } from "../api";
import { ImportQueue, type ImportItem } from "./imports";

const host = { addController() {}, removeController() {}, requestUpdate() {}, updateComplete: Promise.resolve(true) };
const file = (name: string) => new File(["HIERARCHY"], name);
const refused = new ApiError("bvh_unreadable", "not a number", { line: 2 }, null, 422, "fill_gaps");

function queueWith(answer: (form: FormData) => Promise<unknown>) {
  const settled: ImportItem[] = [];
  const upload = (_: string, form: FormData) => answer(form) as Promise<never>;
  return { settled, queue: new ImportQueue(host, (item) => settled.push(item), upload) };
}

test("files go out one after the other, and a refused one does not stop the next", async () => {
  let under_way = 0;
  let most = 0;
  const { queue, settled } = queueWith(async (form) => {
    most = Math.max(most, ++under_way);
    await Promise.resolve();
    under_way--;
    if ((form.get("file") as File).name === "bad.bvh") throw refused;
    return { clip: {}, report: {} };
  });
  await queue.add([file("a.bvh"), file("bad.bvh"), file("c.bvh")]);
  expect(most).toBe(1);
  expect(settled.map(({ state }) => state)).toEqual(["imported", "failed", "imported"]);
  expect(queue.busy).toEqual([]);
});

test("a file is tried again with what was decided about it, and its error is gone", async () => {
  const options: unknown[] = [];
  const { queue, settled } = queueWith(async (form) => {
    options.push(form.get("options"));
    if (options.length === 1) throw refused;
    return { clip: {}, report: {} };
  });
  await queue.add([file("a.bvh")]);
  await queue.retry(settled[0]!, { fill_gaps: true });
  expect(options).toEqual([null, '{"fill_gaps":true}']);
  expect(queue.items[0]).toMatchObject({ state: "imported" });
  expect(queue.items[0]?.error).toBeUndefined();
});

test("files that are added while others go out wait for their turn", async () => {
  const names: string[] = [];
  const { queue } = queueWith(async (form) => {
    names.push((form.get("file") as File).name);
    if (names.length === 1) void queue.add([file("late.bvh")]);
    return { clip: {}, report: {} };
  });
  await queue.add([file("a.bvh"), file("b.bvh")]);
  expect(names).toEqual(["a.bvh", "b.bvh", "late.bvh"]);
});
