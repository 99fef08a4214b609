// Draws a Vega-Lite specification. Vega is loaded only when a chart is on the page.
//
// The content policy forbids eval and style attributes: expressions run through Vega's interpreter,
// the picture is a canvas (the SVG renderer writes style attributes), and no stylesheet is injected.
import type { Result, VisualizationSpec } from "vega-embed";

export type Spec = VisualizationSpec & { description?: string; config?: Record<string, unknown> };

const drawn = new WeakMap<HTMLElement, Result>();

export async function draw(place: HTMLElement, spec: Spec): Promise<void> {
  const [{ default: embed }, { expressionInterpreter }] = await Promise.all([
    import("vega-embed"),
    import("vega-interpreter"),
  ]);
  await document.fonts.ready; // or labels would be measured in another typeface
  drawn.get(place)?.finalize();
  const font = getComputedStyle(document.documentElement).getPropertyValue("--font-sans");
  const result = await embed(place, withFont(spec, font), {
    actions: false,
    ast: true,
    defaultStyle: false,
    expr: expressionInterpreter,
    renderer: "canvas",
    tooltip: false,
  });
  drawn.set(place, result);
}

/** The page's own font family in the place of the printed one. */
export function withFont(spec: Spec, font: string): Spec {
  const config = (spec.config ?? {}) as Record<string, Record<string, unknown>>;
  return { ...spec, config: { ...config, font, text: { ...config.text, font } } } as Spec;
}

/** Whether the system asks for dark pages; fires `change` when it asks for the other. */
export const darkMode = (): MediaQueryList => matchMedia("(prefers-color-scheme: dark)");

/** What the page keeps as JSON in the element of this id. */
export function dataOf<T>(id: string): T {
  return JSON.parse(document.getElementById(id)?.textContent ?? "null") as T;
}
