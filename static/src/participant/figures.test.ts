import { expect, it } from "vitest";
import type { Step } from "../trials/kind";
import { filesOf, shownOf } from "./figures";

const figure = (name: string) => ({ glb_url: `/${name}`, figure_url: "/body", cyclic: true });
const step = (changes: Partial<Step>): Step => ({ index: 0, part: "p", kind: "choose", figures: [], ...changes });

it("every figure is shown from where its files lie on this device", () => {
  const several = step({ figures: [figure("a"), { ...figure("b"), figure_url: null }] });
  const kept = filesOf(several).map((url) => `blob:${url}`);
  expect(shownOf(several, kept)).toEqual([{ src: "blob:/a", figure: "blob:/body" }, { src: "blob:/b", figure: null }]);
});

it("the red figure to compare with stands on the left of the green one, both with their word", () => {
  const pair = step({ kind: "semantic_differential", figures: [figure("walk")], reference: figure("everyday") });
  const shown = shownOf(pair, filesOf(pair));
  expect(shown.map(({ src, as }) => [src, as])).toEqual([["/everyday", "reference"], ["/walk", "judged"]]);
  expect(shown.every(({ label }) => label)).toBe(true);
});

it("a lone figure has neither a colour nor a word", () => {
  const lone = step({ kind: "unipolar", figures: [figure("walk")] });
  expect(shownOf(lone, filesOf(lone))).toEqual([{ src: "/walk", figure: "/body" }]);
});

it("a page without figures needs no files", () => {
  expect(filesOf(step({ kind: "break" }))).toEqual([]);
});
