// A list whose entries change places: by dragging their handles, or by the arrow keys on them.
import { html, type TemplateResult } from "lit";
import { icon } from "../icons";
import { moved } from "./model";

export interface Sortable<T> {
  /** What an entry is called. */
  word: string;
  row(entry: T, index: number): TemplateResult;
  change(next: T[]): void;
}

export function sortable<T>(entries: readonly T[], { word, row, change }: Sortable<T>): TemplateResult {
  const move = (from: number, to: number) => change(moved(entries, from, to));
  return html`<ol class="sortable">${entries.map((entry, index) => html`<li>
    ${handle(`${word} ${index + 1}`, index, entries.length, move)}${row(entry, index)}
    <button class="button quiet icon-button" type="button" aria-label=${`Remove ${word} ${index + 1}`}
      @click=${() => change(entries.filter((_, one) => one !== index))}>${icon("close")}</button></li>`)}</ol>`;
}

/** The dots by which an entry is dragged. */
export function handle(word: string, index: number, count: number, move: (from: number, to: number) => void): TemplateResult {
  const keys = (event: KeyboardEvent) => {
    const to = index + (event.key === "ArrowUp" ? -1 : event.key === "ArrowDown" ? 1 : 0);
    if (to === index) return;
    event.preventDefault();
    if (to < 0 || to >= count) return;
    const list = listOf(event.currentTarget as Element);
    move(index, to);
    requestAnimationFrame(() => list.children[to]?.querySelector<HTMLElement>(".handle")?.focus());
  };
  const drag = (event: PointerEvent) => {
    if (event.button === 0 && count > 1) dragging(event.currentTarget as HTMLElement, event, index, move);
  };
  return html`<button class="handle" type="button" aria-label=${`Move ${word}`} title="Drag, or press the arrow keys" aria-keyshortcuts="ArrowUp ArrowDown"
    @keydown=${keys} @pointerdown=${drag}>${icon("grip")}</button>`;
}

/** Entries change places while the pointer goes over them; the page draws each step. */
function dragging(grip: HTMLElement, start: PointerEvent, from: number, move: (from: number, to: number) => void): void {
  const list = listOf(grip);
  const { height } = list.children[from]!.getBoundingClientRect();
  let now = from;
  grip.setPointerCapture(start.pointerId);
  const mark = () => [...list.children].forEach((entry, index) => entry.classList.toggle("dragged", index === now));
  const over = ({ clientY }: PointerEvent) => {
    const next = [...list.children].findIndex((entry) => {
      const { top, bottom } = entry.getBoundingClientRect();
      return clientY >= top && clientY < bottom;
    });
    if (next < 0 || next === now) return;
    // A tall neighbour would jump back at once if its edge counted and not its middle.
    const { top, height: other } = list.children[next]!.getBoundingClientRect();
    const beyond = next > now ? clientY > top + other - height : clientY < top + height;
    if (!beyond) return;
    move(from, next); // counted in the list as it was when the drag began
    now = next;
    requestAnimationFrame(mark);
  };
  const end = () => {
    grip.removeEventListener("pointermove", over);
    now = -1;
    mark();
  };
  mark();
  grip.addEventListener("pointermove", over);
  grip.addEventListener("pointerup", end, { once: true });
  grip.addEventListener("pointercancel", end, { once: true });
}

const listOf = (inside: Element): Element => inside.closest("ol")!;
