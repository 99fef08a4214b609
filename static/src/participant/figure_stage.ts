// The figures of the present step: shown by one viewer, alone on a stage or each in a cell, and watched.

import { html, nothing, type LitElement, type TemplateResult } from "lit";
import { cellPlaces, type Rectangle } from "./cells";
import { viewer, type Shown } from "./figures";
import { Glances } from "./glances";
import type { Viewer } from "./measures";

interface Drawing extends HTMLElement, Viewer {
  cells: readonly Rectangle[];
  arrange: "ghost" | "beside" | "cells";
  setMotion(index: number, glb: ArrayBuffer): void;
  setShown(index: number, shown: boolean): void;
}

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

  /** Gives the blue figure a motion, and brings it on with its first; resolves with the picture of it. */
  create(glb: ArrayBuffer): Promise<void> {
    const { viewer, creation } = this;
    if (!viewer) return Promise.resolve();
    viewer.setMotion(creation, glb);
    viewer.setShown(creation, true);
    return new Promise((resolve) => viewer.addEventListener("motion", () => resolve(), { once: true }));
  }

  arrange(way: "ghost" | "beside"): void {
    if (this.viewer) this.viewer.arrange = way;
  }

  /** The viewer, where what it shows belongs to such a layout. */
  draw(cells: boolean, hidden: boolean): TemplateResult | typeof nothing {
    if (this.#shown?.cells !== cells) return nothing;
    const on = { ready: () => this.#onReady(), unsupported: this.audience.unsupported, frame: () => this.#onFrame() };
    return html`${viewer(this.#shown.figures, cells, hidden, on)}`;
  }

  /** The place of the blue figure; −1 where there is none. */
  private get creation(): number {
    return this.#shown?.figures.findIndex(({ as }) => as === "creation") ?? -1;
  }

  /** The blue figure waits in the wings until it has a motion of its own. */
  #onReady(): void {
    if (this.creation >= 0) this.viewer?.setShown(this.creation, false);
    this.audience.begin();
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
