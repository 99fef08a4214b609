// <path-pad>: one point between nine motions. Across: path length; upwards: pauses and bursts.
import { html, LitElement, svg, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { inReach, nineMotions, pointWords, stepped } from "./pad_model";
import { NEUTRAL_POINT, type GridPoint } from "./recipe";

const WIDTH = 264;
const HEIGHT = 178;
const MARGIN = 17;

const across = (path: number): number => MARGIN + (path / 2) * (WIDTH - 2 * MARGIN);
const down = (timing: number): number => HEIGHT - MARGIN - (timing / 2) * (HEIGHT - 2 * MARGIN);

@customElement("path-pad")
export class PathPad extends LitElement {
  @property({ attribute: false }) point: GridPoint = NEUTRAL_POINT;
  private pointer: number | null = null;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected override render(): TemplateResult {
    const { point } = this;
    const motions = nineMotions(point);
    const place = { x: across(point.path), y: down(point.timing) };
    return html`<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="slider" tabindex="0" aria-label="Path length and timing"
      aria-valuemin="0" aria-valuemax="2" aria-valuenow=${point.path} aria-valuetext=${pointWords(point)}
      @pointerdown=${this.take} @pointermove=${this.move} @pointerup=${this.leave} @pointercancel=${this.leave}
      @keydown=${this.key} @dblclick=${() => this.tell(NEUTRAL_POINT)}>
      <path class="lines" d=${LINES}></path>
      ${motions.map(({ path, timing, weight }) =>
        weight ? svg`<path class="thread" d="M${place.x} ${place.y}L${across(path)} ${down(timing)}"></path>` : "",
      )}
      ${motions.map(
        ({ path, timing, weight }) => svg`<circle class=${weight ? "motion used" : "motion"} cx=${across(path)} cy=${down(timing)}
          r=${weight ? 4 + 5 * Math.sqrt(weight) : 4.5}></circle>`,
      )}
      <circle class="ring" cx=${place.x} cy=${place.y} r="16"></circle>
      <circle class="handle" cx=${place.x} cy=${place.y} r="11"></circle>
      <circle class="dot" cx=${place.x} cy=${place.y} r="2.5"></circle>
    </svg>`;
  }

  private take(event: PointerEvent): void {
    if (!event.isPrimary || event.button !== 0) return;
    this.pointer = event.pointerId;
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    this.move(event);
  }

  private move(event: PointerEvent): void {
    if (event.pointerId !== this.pointer) return;
    const box = (event.currentTarget as Element).getBoundingClientRect();
    const margin = (MARGIN * box.width) / WIDTH;
    const share = (at: number, start: number, length: number) => (2 * (at - start - margin)) / (length - 2 * margin);
    this.tell({
      path: share(event.clientX, box.left, box.width),
      timing: 2 - share(event.clientY, box.top, box.height),
    });
  }

  private leave(event: PointerEvent): void {
    if (event.pointerId === this.pointer) this.pointer = null;
  }

  private key(event: KeyboardEvent): void {
    const point = stepped(this.point, event.key, event.shiftKey);
    if (!point || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.tell(point);
  }

  private tell(point: GridPoint): void {
    this.dispatchEvent(new CustomEvent<GridPoint>("point", { detail: inReach(point) }));
  }
}

const LINES = [0, 1, 2]
  .map((line) => `M${across(line)} ${down(0)}V${down(2)}M${across(0)} ${down(line)}H${across(2)}`)
  .join("");
