// The curve over the number of participants, in the words of Vega-Lite.
import type { Spec } from "../results/chart";
import type { Stability } from "./model";

export interface Palette {
  ink: string;
  quiet: string;
  line: string;
  data: string;
}

/** The page's colours, as they are in this mode. */
export function paletteOf(element: Element): Palette {
  const style = getComputedStyle(element);
  const [ink, quiet, line, data] = ["--ink", "--ink-2", "--line", "--bipolar-1"].map((name) => style.getPropertyValue(name).trim());
  return { ink, quiet, line, data } as Palette;
}

export function curve({ by_participants, enough, participants }: Stability, { ink, quiet, line, data }: Palette): Spec {
  const points = by_participants.map(({ participants: people, whole, shared }) => ({ people, ...whole, groups: shared?.mean ?? null }));
  const axis = { domain: false, ticks: false, labelColor: quiet, labelFontSize: 13, labelPadding: 8, titleColor: quiet, titleFontSize: 13, titleFontWeight: 400 };
  const x = { field: "people", type: "quantitative", title: "participants", axis: { ...axis, grid: false, values: points.map(({ people }) => people) }, scale: { zero: false, nice: false } };
  const scale = { domain: [Math.min(0, ...points.map(({ low }) => low)), 1] };
  const y = { type: "quantitative", scale, axis: { ...axis, gridColor: line, tickCount: 5, title: null } };
  const at = (value: object, mark: object) => ({ data: { values: [value] }, mark });
  return {
    width: "container", height: 220, background: "transparent", padding: 2,
    config: { view: { stroke: null }, text: { color: ink } },
    data: { values: points },
    layer: [
      { mark: { type: "area", color: data, opacity: 0.18 }, encoding: { x, y: { ...y, field: "low" }, y2: { field: "high" } } },
      { ...at({ index: enough.index }, { type: "rule", color: quiet, strokeDash: [2, 4] }), encoding: { y: { ...y, field: "index" } } },
      { ...at({ people: participants }, { type: "rule", color: line }), encoding: { x } },
      { mark: { type: "line", color: quiet, strokeWidth: 1.5, strokeDash: [6, 4] }, encoding: { x, y: { ...y, field: "groups" } } },
      { mark: { type: "line", color: data, strokeWidth: 2, point: { color: data, size: 42 } }, encoding: { x, y: { ...y, field: "mean" } } },
    ],
  } as unknown as Spec;
}
