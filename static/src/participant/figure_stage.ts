// The figures of the present step: shown by one viewer, alone on a stage or each in a cell, and watched.

import { html, nothing, type LitElement, type TemplateResult } from "lit";
import { cellPlaces, type Rectangle } from "./cells";
import { viewer, type Shown } from "./figures";
import { Glances } from "./glances";
import type { Viewer } from "./measures";

type Drawing = HTMLElement & Viewer & { cells: readonly Rectangle[] };

type OnView = { cells: boolean; figures: readonly Shown[] } | null;

export interface Audience {
  /** The figures' first picture is there, or there are none to wait for. */
  begin: () => void;
  unsupported: () => void;
}

export class FigureStage {
  paused = false;
  #shown: OnView = null;
  #glances: Glances | null = null;
  readonly #resized = new ResizeObserver(() => this.#placeCells());

  constructor(
    private readonly host: LitElement,
    private readonly audience: Audience,
  ) {}

  get viewer(): Drawing | null {
    return this.host.querySelector<Drawing>("motion-viewer");
  }

  /** Of several figures, how long each has been in view and moving, ms. */
  get watched(): readonly number[] {
    return this.#glances?.ms ?? [];
  }

  get unseen(): number {
    return this.#glances?.unseen ?? 0;
  }

  isSeen(place: number): boolean {
    return this.#glances?.isSeen(place) ?? true;
  }

  togglePause(): void {
    if (this.paused) this.viewer?.play();
    else this.viewer?.pause();
  }

  /** Puts figures on, or none. `before`: how long each was watched before a reload. */
  async show(figures: readonly Shown[], cells: boolean, before: readonly number[]): Promise<void> {
    // The same figures again: a fresh viewer counts from nothing, as for any others.
    if (JSON.stringify({ cells, figures }) === JSON.stringify(this.#shown)) await this.#put(null);
    await this.#put(figures.length ? { cells, figures } : null);
    this.#watch(before);
    if (!this.#shown) this.audience.begin();
  }

  /** The viewer, where what it shows belongs to such a layout. */
  draw(cells: boolean, hidden: boolean): TemplateResult | typeof nothing {
    if (this.#shown?.cells !== cells) return nothing;
    const on = { ready: this.audience.begin, unsupported: this.audience.unsupported, frame: () => this.#onFrame() };
    return html`${viewer(this.#shown.figures, cells, hidden, on)}`;
  }

  async #put(shown: OnView): Promise<void> {
    this.#shown = shown;
    this.host.requestUpdate();
    await this.host.updateComplete;
  }

  #watch(before: readonly number[]): void {
    this.#glances?.stop();
    this.#resized.disconnect();
    const grid = this.host.querySelector(".cells");
    this.#glances = grid && new Glances([...grid.querySelectorAll(".cell")], before);
    if (grid) this.#resized.observe(grid);
    this.#placeCells();
  }

  #placeCells(): void {
    const grid = this.host.querySelector(".cells");
    if (grid && this.viewer) this.viewer.cells = cellPlaces(grid);
  }

  #onFrame(): void {
    const { viewer } = this;
    if (!viewer) return;
    const news = this.#glances?.watched(viewer.statistics.viewingMs);
    if (news || viewer.paused !== this.paused) this.host.requestUpdate();
    this.paused = viewer.paused;
  }
}
