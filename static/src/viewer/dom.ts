/** Small helpers to build elements without markup from strings. */

type Attributes = Record<string, string | boolean | EventListener>;

export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false) element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

/** An attribute's number; null where there is none. */
export function numberOf(element: Element, attribute: string): number | null {
  const text = element.getAttribute(attribute);
  const value = Number(text);
  return text !== null && text.trim() !== "" && Number.isFinite(value) ? value : null;
}

/** Strokes on a 20 × 20 field. */
const ICONS = {
  play: ["M6 3.8v12.4L16 10z"],
  pause: ["M7 4v12", "M13 4v12"],
  replay: ["M4.5 7.2A6.4 6.4 0 1 1 3.6 10.6", "M4.2 3.4v4h4"],
  start: ["M5 4v12", "M15.5 4.5v11L8 10z"],
  loop: ["M4 9V8a3 3 0 0 1 3-3h8", "M12.5 2.5 15 5l-2.5 2.5", "M16 11v1a3 3 0 0 1-3 3H5", "M7.5 17.5 5 15l2.5-2.5"],
  orbit: ["M10 13.5c-4.4 0-7.5-1.6-7.5-3.6S5.6 6.3 10 6.3s7.5 1.6 7.5 3.6c0 1.2-1 2.2-2.7 2.9", "M12.3 15.8 10 13.5l2.3-2.3"],
} as const;

export type IconName = keyof typeof ICONS;

const SVG = "http://www.w3.org/2000/svg";

export function icon(name: IconName): SVGSVGElement {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("aria-hidden", "true");
  for (const stroke of ICONS[name]) {
    const path = document.createElementNS(SVG, "path");
    path.setAttribute("d", stroke);
    svg.append(path);
  }
  return svg;
}
