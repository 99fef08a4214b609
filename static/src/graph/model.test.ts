import { expect, test } from "vitest";
import { arrowsOf, centimetres, degrees, directionsOf, startOf, type GraphDetail } from "./model";

test("names tell which clip each direction means", () => {
  expect(directionsOf(["stand", "walk", "turn_left", "turn_right"])).toEqual({
    stop: "stand", ahead: "walk", left: "turn_left", right: "turn_right",
  });
  expect(directionsOf(["idle", "run"])).toEqual({ stop: "idle", ahead: "run" });
});

test("clips whose names say nothing can be walked to all the same", () => {
  expect(directionsOf(["a", "b", "c"])).toEqual({ ahead: "a", stop: "b" });
  expect(directionsOf(["dance"])).toEqual({ ahead: "dance" });
  expect(directionsOf([])).toEqual({});
});

test("transitions of one pair of clips make one arrow", () => {
  const way = (source: string, target: string, frame: number) => ({ source, target, source_frame: frame, target_frame: 0 });
  expect(arrowsOf([way("a", "b", 1), way("b", "a", 2), way("a", "b", 3)])).toEqual([
    { source: "a", target: "b", count: 2 },
    { source: "b", target: "a", count: 1 },
  ]);
});

test("a walk begins where something can follow, standing if it may", () => {
  const graph = (names: string[], sources: string[]) =>
    ({ members: names.map((name) => ({ name })), transitions: sources.map((source) => ({ source })) }) as GraphDetail;
  expect(startOf(graph(["walk", "stand"], ["walk", "stand"]))?.clip).toBe("stand");
  expect(startOf(graph(["walk", "stand"], ["walk"]))?.clip).toBe("walk");
  expect(startOf(graph(["walk"], []))).toBeNull();
});

test("distances are told in centimetres, turns with a true minus sign", () => {
  expect(centimetres(0.0213)).toBe("2.1 cm");
  expect(degrees(-Math.PI / 2)).toBe("−90°");
  expect(degrees(-0.001)).toBe("0°");
});
