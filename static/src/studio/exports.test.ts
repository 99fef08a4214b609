import { execFileSync } from "node:child_process";
import { expect, test } from "vitest";
import { asCurl, asPython, asRecipe } from "./exports";

const VARIANT = {
  source: "a".repeat(64),
  operations: [{ operation: "vary@1", parameters: { path: 0.3, seed: 7, limbs: null, loud: true, gains: [] } }],
  name: `It's "sad" \\ $HOME 悲しい`,
};

test("the recipe reads back as it was", () => {
  expect(JSON.parse(asRecipe(VARIANT))).toEqual(VARIANT.operations);
});

test("a shell hands curl exactly the variant, whatever its name is made of", () => {
  const script = `curl() { for last; do :; done; printf '%s' "$last"; }\n${asCurl(VARIANT, "http://manner.test")}`;
  expect(JSON.parse(execFileSync("sh", ["-c", script], { encoding: "utf8" }))).toEqual(VARIANT);
});

test("Python reads exactly the variant", () => {
  const code = asPython(VARIANT, "http://manner.test");
  const literal = code.slice(code.indexOf("variant = "), code.indexOf("request = "));
  const told = execFileSync("python3", ["-c", `${literal}\nimport json\nprint(json.dumps(variant))`], {
    encoding: "utf8",
  });
  expect(JSON.parse(told)).toEqual(VARIANT);
});
