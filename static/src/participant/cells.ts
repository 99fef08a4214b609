// Several figures on one page: a cell for each, and over all of them one viewer that draws them in step.

import { html, nothing, type TemplateResult } from "lit";
import type { CellParts } from "../trials/kind";
import { t } from "../words";

export interface Rectangle {
  x: number;
  y: number;
  width: number;
  height: number;
}

export interface CellsView {
  parts: readonly CellParts[];
  viewer: TemplateResult | typeof nothing;
  /** Whether each figure has been seen; null where that is not said. */
  seen: (place: number) => boolean;
  says: boolean;
}

const DRAG_PIXELS = 6;
let pressed = { x: 0, y: 0 };

export function cells({ parts, viewer, seen, says }: CellsView): TemplateResult {
  const tap = (event: MouseEvent) => onTap(event, parts);
  const press = ({ clientX: x, clientY: y }: PointerEvent) => (pressed = { x, y });
  return html`<div class="cells cells-${columnsOf(parts.length)} count-${parts.length}" @pointerdown=${press} @click=${tap}
    @keydown=${(event: KeyboardEvent) => onDigit(event, parts)}>
    ${parts.map(({ head, corner, foot, chosen }, place) => html`<div class="cell ${chosen ? "chosen" : ""}">
      <div class="cell-stage"></div>
      ${head ? html`<div class="cell-head"><strong>${head}</strong>
        ${says && !seen(place) ? html`<span>${t("not yet seen")}</span>` : nothing}</div>` : nothing}
      ${corner ?? nothing}
      ${foot ? html`<div class="cell-foot">${foot}</div>` : nothing}
    </div>`)}
    ${viewer}
  </div>`;
}

/** Side by side on a wide page; a phone always has two. */
function columnsOf(count: number): number {
  return count <= 4 ? count : count === 6 ? 3 : count <= 8 && count !== 5 ? 4 : 5;
}

/**
 * Where the figures are drawn: CSS pixels from the upper left of the cells. All as large as the smallest stage, for one
 * camera sees them all; each in the middle of its stage, at the bottom.
 */
export function cellPlaces(grid: Element): Rectangle[] {
  const origin = grid.getBoundingClientRect();
  const stages = [...grid.querySelectorAll(".cell-stage")].map((stage) => stage.getBoundingClientRect());
  const width = Math.min(...stages.map((stage) => stage.width));
  const height = Math.min(...stages.map((stage) => stage.height));
  return stages.map((stage) => ({
    x: stage.x - origin.x + (stage.width - width) / 2,
    y: stage.bottom - origin.y - height,
    width,
    height,
  }));
}

/** A tap on a figure means its cell; a drag turned the figures and means nothing more. */
function onTap(event: MouseEvent, parts: readonly CellParts[]): void {
  const { clientX, clientY, target } = event;
  if (!(target instanceof Element) || target.localName !== "motion-viewer") return;
  if (Math.hypot(clientX - pressed.x, clientY - pressed.y) > DRAG_PIXELS) return;
  const stages = [...(event.currentTarget as Element).querySelectorAll(".cell-stage")];
  const place = stages.findIndex((stage) => {
    const { left, right, top, bottom } = stage.getBoundingClientRect();
    return left <= clientX && clientX <= right && top <= clientY && clientY <= bottom;
  });
  parts[place]?.tap?.();
}

/** 1 … 9 and 0 mean the first ten figures. */
function onDigit(event: KeyboardEvent, parts: readonly CellParts[]): void {
  const { key, target } = event;
  if (event.ctrlKey || event.metaKey || event.altKey || !/^\d$/.test(key)) return;
  const onStage = target instanceof Element && target.localName === "motion-viewer";
  const tap = parts[key === "0" ? 9 : Number(key) - 1]?.tap;
  if (!tap || onStage) return;
  event.preventDefault();
  tap();
}
