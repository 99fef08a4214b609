// Choosing a row of "Is every quality seen?" puts its sentence beside the table, ready to copy.

import type { components } from "../api-types";
import { api } from "../api";

export function poleTable(table: HTMLTableElement, sentence: HTMLElement): void {
  table.addEventListener("click", (event) => {
    const row = (event.target as Element).closest<HTMLTableRowElement>("tr[data-sentence]");
    if (row) choose(table, row, sentence);
  });
}

export function choose(table: HTMLTableElement, row: HTMLTableRowElement, sentence: HTMLElement): void {
  for (const other of table.querySelectorAll("tr[data-sentence]")) {
    const chosen = other === row;
    other.classList.toggle("chosen", chosen);
    other.querySelector("button")?.setAttribute("aria-pressed", String(chosen));
  }
  sentence.replaceChildren(...italics(row.dataset.sentence ?? ""));
  if (row.dataset.clip) void showClip(row.dataset.clip);
}

/** The figure that the sentence is about, at its best frame beside it. */
async function showClip(id: string): Promise<void> {
  const place = document.querySelector("motion-thumbnail[data-best]");
  if (!place) return;
  const [clip] = await Promise.all([
    api.get<components["schemas"]["ClipDetail"]>(`/api/v1/clips/${id}?motion=false`),
    import("../viewer/thumbnails"),
  ]);
  place.setAttribute("poster-time", String(clip.poster_time));
  place.setAttribute("figure", clip.figure_url ?? "");
  place.setAttribute("src", clip.glb_url);
}

/** Statistical symbols stand in italics, as the style asks, and stay with their numbers: t(42.7), p < .001. */
export function italics(text: string): (string | HTMLElement)[] {
  return text.replace(/ ([=<]) /g, "\u00a0$1\u00a0").split(/\b([tpdM])(?=\(|\u00a0[=<])/).map((part, index) => {
    if (index % 2 === 0) return part;
    const symbol = document.createElement("em");
    symbol.textContent = part;
    return symbol;
  });
}
