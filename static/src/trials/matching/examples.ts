// <matching-examples>: a button, and over the trial a panel in which all examples move, numbered as their sliders are.

import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { icon } from "../../icons";
import { cellPlaces, cells, type Rectangle } from "../../participant/cells";
import { viewer } from "../../participant/figures";
import { t } from "../../words";
import type { Figure } from "../kind";

@customElement("matching-examples")
export class MatchingExamples extends LitElement {
  @property({ attribute: false }) figures: readonly Figure[] = [];
  /** The figures are drawn only while they are looked at. */
  @state() private open = false;
  readonly #resized = new ResizeObserver(() => this.#place());

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#resized.disconnect();
  }

  async #show(): Promise<void> {
    this.open = true;
    await this.updateComplete;
    this.querySelector("dialog")?.showModal();
    this.#resized.observe(this.querySelector(".cells")!);
  }

  #place(): void {
    const grid = this.querySelector(".cells");
    const drawing = this.querySelector<HTMLElement & { cells: readonly Rectangle[] }>("motion-viewer");
    if (grid && drawing) drawing.cells = cellPlaces(grid);
  }

  #closed(): void {
    this.#resized.disconnect();
    this.open = false;
  }

  protected override render(): TemplateResult {
    return html`<button class="button" type="button" @click=${() => void this.#show()}>${t("Show all examples")}</button>
      <dialog class="examples-dialog" aria-labelledby="examples-title" @close=${() => this.#closed()}>${this.open ? this.#panel() : nothing}</dialog>`;
  }

  #panel(): TemplateResult {
    const close = () => this.querySelector("dialog")?.close();
    return html`<header><h2 id="examples-title">${t("All examples")}</h2>
        <button class="button quiet" type="button" @click=${close}>${icon("close")}${t("Close")}</button></header>
      <div class="examples-scroll" tabindex="0" role="group" aria-labelledby="examples-title">${this.#cells()}</div>`;
  }

  #cells(): TemplateResult {
    const shown = this.figures.map(({ glb_url: src, figure_url: figure }) => ({ src, figure }));
    const parts = this.figures.map(({ caption }) => ({ head: caption ?? "" }));
    const on = { ready: () => this.#place(), unsupported: () => {}, frame: () => {} };
    return cells({ parts, viewer: viewer(shown, true, false, on), seen: () => true, says: false });
  }
}
