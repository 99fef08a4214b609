// <keytime-rows>: an example's events as marks that are dragged along its time, a row for each foot.
// Event: `keytime` {name, time}.
import { html, LitElement, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { follow } from "../studio/strip/drag";
import { placeOf } from "../studio/strip/scale";
import { rowsOf, steppedTime } from "./keytimes";
import type { Keytimes } from "./server";

export interface Keytime {
  name: string;
  time: number;
}

@customElement("keytime-rows")
export class KeytimeRows extends LitElement {
  @property({ attribute: false }) keytimes: Keytimes = {};
  @property({ type: Number }) duration = 0;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected override render(): TemplateResult {
    return html`${rowsOf(this.keytimes).map(({ title, events }) => html`<span class="keytime-title">${title}</span>
      <div class="keytime-row">${events.map(({ name, word }) => this.mark(name, word))}</div>`)}`;
  }

  private mark(name: string, word: string): TemplateResult {
    const time = this.keytimes[name]!;
    return html`<button class="keytime ${placeOf(time, this.duration) > 85 ? "before" : ""}" type="button" role="slider" aria-label=${name.replaceAll("_", " ")} aria-valuemin="0"
      aria-valuemax=${this.duration.toFixed(2)} aria-valuenow=${time.toFixed(2)} aria-valuetext="${time.toFixed(2)} seconds"
      .style=${`left: ${placeOf(time, this.duration)}%`} @keydown=${(event: KeyboardEvent) => this.key(event, name)}
      @pointerdown=${(event: PointerEvent) => this.drag(event, name)}><i></i><span>${word}</span></button>`;
  }

  private drag(event: PointerEvent, name: string): void {
    const row = (event.currentTarget as HTMLElement).parentElement;
    if (!event.isPrimary || event.button !== 0 || !row) return;
    (event.currentTarget as HTMLElement).focus({ preventScroll: true });
    event.preventDefault();
    follow(event, row, { move: (share) => this.tell(name, share * this.duration), end: () => {} });
  }

  private key(event: KeyboardEvent, name: string): void {
    const time = steppedTime(this.keytimes[name]!, event.key, event.shiftKey);
    if (time === null || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.tell(name, time);
  }

  /** The end of a cycle is its beginning: a mark stays before it. */
  private tell(name: string, wanted: number): void {
    const last = Math.floor(this.duration * 1000 - 1) / 1000;
    const time = Math.min(Math.max(Math.round(wanted * 1000) / 1000, 0), Math.max(last, 0));
    this.dispatchEvent(new CustomEvent<Keytime>("keytime", { detail: { name, time } }));
  }
}
