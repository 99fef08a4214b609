// <band-equaliser>: the gain of each band of frequencies, 1 in the middle.
import { html, LitElement, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { clamped, rounded, type Band } from "./recipe";

/** Halves from 7.5 Hz down, as the picture of a motion at 30 frames a second parts them. */
export const USUAL_BANDS = [0.12, 0.23, 0.47, 0.94, 1.9, 3.8, 7.5];
const TOP = 8;
const HEIGHT = 84;
const HIGHEST = 2;

const down = (gain: number): number => TOP + (1 - gain / HIGHEST) * HEIGHT;

export interface BandChange {
  frequency: number;
  gain: number;
}

@customElement("band-equaliser")
export class BandEqualiser extends LitElement {
  @property({ attribute: false }) bands: readonly Band[] = [];
  private held: { pointer: number; frequency: number } | null = null;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected override render(): TemplateResult {
    return html`<div class="band-scale" aria-hidden="true"><span>2</span><span>1</span><span>0</span></div>
      ${this.bands.map((band) => this.band(band))}`;
  }

  private band({ frequency, gain }: Band): TemplateResult {
    const at = down(Math.min(gain, HIGHEST));
    const stem = `M17 ${down(1)}V${at}`;
    const words = `${gain.toFixed(2)}${gain === 1 ? ", as it is" : gain < 1 ? ", less" : ", more"}`;
    return html`<div class="band" role="slider" tabindex="0" aria-orientation="vertical" aria-label="${frequency} hertz"
      aria-valuemin="0" aria-valuemax=${HIGHEST} aria-valuenow=${gain} aria-valuetext=${words}
      @pointerdown=${(event: PointerEvent) => this.take(event, frequency)} @pointermove=${this.move}
      @pointerup=${this.leave} @pointercancel=${this.leave}
      @keydown=${(event: KeyboardEvent) => this.key(event, { frequency, gain })} @dblclick=${() => this.tell(frequency, 1)}>
      <svg viewBox="0 0 34 ${HEIGHT + 2 * TOP}" aria-hidden="true">
        <path class="lines" d="M17 ${down(2)}V${down(0)}M-6 ${down(0)}H40M-6 ${down(2)}H40"></path>
        <path class="unity" d="M-6 ${down(1)}H40"></path>
        <path class="stem" d=${stem}></path>
        <rect class="ring" x="2.5" y=${at - 9} width="29" height="18" rx="9"></rect>
        <rect class="handle" x="7" y=${at - 5} width="20" height="10" rx="5"></rect>
      </svg>
      <span aria-hidden="true">${frequency}</span></div>`;
  }

  private take(event: PointerEvent, frequency: number): void {
    if (!event.isPrimary || event.button !== 0) return;
    this.held = { pointer: event.pointerId, frequency };
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    this.move(event);
  }

  private move(event: PointerEvent): void {
    if (event.pointerId !== this.held?.pointer) return;
    const box = (event.currentTarget as Element).querySelector("svg")!.getBoundingClientRect();
    const scale = box.height / (HEIGHT + 2 * TOP);
    const share = (event.clientY - box.top - TOP * scale) / (HEIGHT * scale);
    this.tell(this.held.frequency, HIGHEST * (1 - share));
  }

  private leave(event: PointerEvent): void {
    if (event.pointerId === this.held?.pointer) this.held = null;
  }

  private key(event: KeyboardEvent, { frequency, gain }: Band): void {
    const size = event.shiftKey ? 0.25 : 0.05;
    const keys: Record<string, number> = {
      ArrowUp: gain + size, ArrowRight: gain + size, ArrowDown: gain - size, ArrowLeft: gain - size,
      Home: 0, End: HIGHEST,
    };
    const next = keys[event.key];
    if (next === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.tell(frequency, next);
  }

  private tell(frequency: number, gain: number): void {
    const detail: BandChange = { frequency, gain: rounded(clamped(gain, 0, HIGHEST)) };
    this.dispatchEvent(new CustomEvent<BandChange>("band", { detail }));
  }
}
