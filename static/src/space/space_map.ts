// <space-map>: where the mix lies among the examples on two sliders. The mix is dragged, an example is gone to.
// Events: `place` {x, y}, `example` index.
import { html, LitElement, nothing, svg, type SVGTemplateResult, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { hull, inside, nearest, neighbour, stepped, type Example, type Spot } from "./map_model";

const WIDTH = 272;
const HEIGHT = 170;
const MARGIN = 16;
const REACH = 11;
/** From this weight on an example is drawn as used. */
const USED = 0.05;

const across = (x: number): number => MARGIN + x * (WIDTH - 2 * MARGIN);
const down = (y: number): number => HEIGHT - MARGIN - y * (HEIGHT - 2 * MARGIN);
const drawn = ({ x, y }: Spot): Spot => ({ x: across(x), y: down(y) });

@customElement("space-map")
export class SpaceMap extends LitElement {
  @property({ attribute: false }) examples: readonly Example[] = [];
  @property({ attribute: false }) spot: Spot = { x: 0.5, y: 0.5 };
  /** What lies across and up, in words. */
  @property({ attribute: false }) axes: readonly [string, string] = ["", ""];
  @state() private named: number | null = null;
  @state() private current = 0;
  private pointer: number | null = null;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected override render(): TemplateResult {
    const { examples, spot } = this;
    const at = drawn(spot);
    // Above those that are not in use: examples often lie on each other.
    const used = examples.filter(({ weight }) => weight >= USED);
    const corners = hull(examples).map(drawn).map(({ x, y }) => `${x} ${y}`);
    const [first, second] = this.axes;
    return html`<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="group" aria-label="Map of the examples" @pointerdown=${this.take} @pointermove=${this.move}
      @pointerup=${this.leave} @pointercancel=${this.leave} @pointerleave=${() => (this.named = null)}>
      ${corners.length > 2 ? svg`<path class="hull" d="M${corners.join("L")}Z"></path>` : nothing}
      ${used.map((example) => {
        const end = drawn(example);
        return svg`<path class="thread" d="M${at.x} ${at.y}L${end.x} ${end.y}"></path>`;
      })}
      ${examples.map((example, index) => this.example(example, index))}
      ${used.map((example) => {
        const { x, y } = drawn(example);
        return svg`<circle class="used" cx=${x} cy=${y} r=${3 + 6 * Math.sqrt(example.weight)}></circle>`;
      })}
      <g class="mix" role="slider" tabindex="0" aria-label="The mix" aria-valuemin="0" aria-valuemax="1" aria-valuenow=${spot.x}
        aria-valuetext="${first} ${spot.x.toFixed(2)}, ${second} ${spot.y.toFixed(2)}" @keydown=${this.key}>
        <circle class="ring" cx=${at.x} cy=${at.y} r="15"></circle>
        <circle class="handle" cx=${at.x} cy=${at.y} r="10"></circle><circle class="dot" cx=${at.x} cy=${at.y} r="2.5"></circle></g>
      ${this.label()}
    </svg>`;
  }

  private example(example: Example, index: number): SVGTemplateResult {
    const { x, y } = drawn(example);
    return svg`<g class="example" role="button" tabindex=${index === this.current ? 0 : -1} aria-label="Go to ${example.name}"
      @focus=${() => (this.named = index)} @blur=${() => (this.named = null)} @keydown=${(event: KeyboardEvent) => this.walk(event, index)}>
      <circle class="ring" cx=${x} cy=${y} r="11"></circle>
      <circle class="motion" cx=${x} cy=${y} r="4"></circle></g>`;
  }

  /** The name of the example that is pointed at or focused; it stays within the picture. */
  private label(): SVGTemplateResult | typeof nothing {
    const example = this.named === null ? undefined : this.examples[this.named];
    if (!example) return nothing;
    const { x, y } = drawn(example);
    const anchor = x < WIDTH / 3 ? "start" : x > (2 * WIDTH) / 3 ? "end" : "middle";
    return svg`<text class="name" aria-hidden="true" x=${x} y=${y < 34 ? y + 22 : y - 13} text-anchor=${anchor}>${example.name}</text>`;
  }

  private take(event: PointerEvent): void {
    if (!event.isPrimary || event.button !== 0) return;
    const at = this.where(event);
    const index = this.under(at);
    if (index !== null && nearest([drawn(this.spot)], at, REACH) === null) {
      this.current = index;
      this.dispatchEvent(new CustomEvent("example", { detail: index }));
      return;
    }
    this.pointer = event.pointerId;
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    this.querySelector<SVGElement>(".mix")?.focus({ preventScroll: true });
    event.preventDefault();
    this.move(event);
  }

  private move(event: PointerEvent): void {
    const at = this.where(event);
    if (event.pointerId !== this.pointer) {
      this.named = this.under(at);
      return;
    }
    const share = (length: number, place: number) => inside((place - MARGIN) / (length - 2 * MARGIN));
    this.tell({ x: share(WIDTH, at.x), y: inside(1 - (at.y - MARGIN) / (HEIGHT - 2 * MARGIN)) });
  }

  private leave(event: PointerEvent): void {
    if (event.pointerId === this.pointer) this.pointer = null;
  }

  private under(at: Spot): number | null {
    return nearest(this.examples.map(drawn), at, REACH);
  }

  /** In the picture's own units. */
  private where(event: PointerEvent): Spot {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    return { x: ((event.clientX - box.left) * WIDTH) / box.width, y: ((event.clientY - box.top) * HEIGHT) / box.height };
  }

  private key(event: KeyboardEvent): void {
    const spot = stepped(this.spot, event.key, event.shiftKey);
    if (!spot || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.tell(spot);
  }

  private walk(event: KeyboardEvent, index: number): void {
    if (event.key === "Enter" || event.key === " ") this.dispatchEvent(new CustomEvent("example", { detail: index }));
    const next = neighbour(this.examples, index, event.key);
    if (next !== null) {
      this.current = next;
      void this.updateComplete.then(() => this.querySelectorAll<SVGElement>(".example")[next]?.focus());
    }
    if (next !== null || event.key === " ") event.preventDefault();
  }

  private tell(spot: Spot): void {
    this.dispatchEvent(new CustomEvent<Spot>("place", { detail: spot }));
  }
}
