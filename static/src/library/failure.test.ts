import { expect, test } from "vitest";
import { problem } from "./failure";

const message = "Line 150, column 39: frame 16, Hips, Zrotation: “nan” is not a finite number.";

test("line and column are said once, and what the heading says is not said again", () => {
  const place = { line: 150, column: 39, frame: 16, joint: "Hips", channel: "Zrotation" };
  expect(problem(message, place)).toBe("Line 150, column 39: “nan” is not a finite number.");
});

test("a message without a place stays as it is", () => {
  expect(problem("The file is empty.", {})).toBe("The file is empty.");
});
