// A 1.7 m rule beside the figure: a wrong unit shows at a glance.
import { svg, html, type TemplateResult } from "lit";

export const TALLEST = 1.7;

/**
 * @param height px of the whole picture.
 * @param floor px from the top to 0 m.
 * @param top px from the top to 1.7 m.
 */
export function ruler(height: number, floor: number, top: number): TemplateResult {
  const y = (metres: number) => floor + ((top - floor) * metres) / TALLEST;
  const ticks = Array.from({ length: 18 }, (_, tenth) => tenth / 10);
  const long = (metres: number) => Math.abs((metres * 2) % 1) < 1e-9 || metres === TALLEST;
  const words: [number, string][] = [[0, "0"], [0.5, "0.5"], [1, "1.0"], [1.5, "1.5"]];
  return html`<svg class="ruler" width="110" height=${height} viewBox="0 0 110 ${height}" aria-hidden="true">
    ${svg`<path d=${`M46 ${y(0)}V${y(TALLEST)}` + ticks.map((metres) => `M46 ${y(metres)}h${long(metres) ? -10 : -5}`).join("")}></path>`}
    ${words.map(([metres, word]) => svg`<text x="30" y=${y(metres) + 4} text-anchor="end">${word}</text>`)}
    ${svg`<text x="54" y=${y(TALLEST) + 4}>1.7 m</text>`}
  </svg>`;
}
