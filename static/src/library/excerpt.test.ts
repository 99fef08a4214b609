import { expect, test } from "vitest";
import { excerpt } from "./excerpt";

const numbers = (fault: string) =>
  [...Array.from({ length: 30 }, (_, i) => (i / 7).toFixed(4)), fault, "1.0 2.0 3.0", "4.0 ".repeat(20)].join(" ");
const long = numbers("nan");
const column = long.indexOf("nan") + 1;

test("the word at the column is the fault, and the three parts are the line again", () => {
  const [line] = excerpt([[7, "OFFSET 0 1x 2"]], 7, 11);
  expect(line).toEqual({ number: 7, before: "OFFSET 0 ", fault: "1x", after: " 2" });
});

test("a long line is cut so that the fault is in sight, with both cuts shown", () => {
  const [, line] = excerpt([[1, long], [2, long], [3, long]], 2, column);
  expect(line?.fault).toBe("nan");
  expect(line?.before.startsWith("… ")).toBe(true);
  expect(line?.after.endsWith(" …")).toBe(true);
});

test("neighbouring lines are cut at the same place", () => {
  const [above, at] = excerpt([[1, long], [2, long]], 2, column);
  expect(above?.before.slice(0, at?.before.length)).toBe(at?.before);
});

test("a line without a column is shown from its start and marks nothing", () => {
  const [line] = excerpt([[3, "MOTION"]], 3, null);
  expect(line).toEqual({ number: 3, before: "MOTION", fault: "", after: "" });
});

test("a column past the end of its line, as at a file that ends too early, marks nothing", () => {
  expect(excerpt([[9, "1 2"]], 9, 4)[0]).toMatchObject({ before: "1 2", fault: "" });
});

test("in a line that the server has cut, the quoted word nearest to its middle is the fault", () => {
  const text = "… 1.5 nan 2.25 nan 4.75 …";
  const [line] = excerpt([[150, text]], 150, 539, "nan", 60);
  expect(line).toMatchObject({ before: "… 1.5 nan 2.25 ", fault: "nan", after: " 4.75 …" });
});

test("a cut line without the quoted word marks nothing rather than something wrong", () => {
  expect(excerpt([[150, "… 1.5 2.25 …"]], 150, 539, "nan")[0]?.fault).toBe("");
});
