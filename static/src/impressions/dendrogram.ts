// Ward's tree, drawn with its leaves in rows, and the cut through it.
import { nothing, svg, html, type SVGTemplateResult, type TemplateResult } from "lit";
import { groupOf, type Merge } from "./model";
import { branches, clustersAt, commonest, cutHeight, type Branch } from "./tree";

export const ROW = 26;
/** Above the first row: the knob of the cut. */
export const TOP = 36;
const PAD = 10;

export interface Drawing {
  merges: readonly Merge[];
  /** For each leaf, by its number in the merges, the row in which it stands. */
  order: readonly number[];
  /** The cluster of each row. */
  clusters: readonly number[];
  /** Into how many the tree is cut. */
  cut: number;
  /** Into how many it will be cut once the answer is there: what the next key goes on from. */
  wanted: number;
  width: number;
  /** Where the cut is while it is dragged; null where it rests. */
  held: number | null;
  grip: Grip;
}

/** Where the cut was taken hold of: the pointer's place and the cut's. It moves once the pointer has gone sideways. */
export interface Grip {
  pointer: number;
  cut: number;
  moving: boolean;
}

const SLACK = 4; // px that a finger may slip before it is a drag

export interface Cutting {
  /** The cut is at this height, and makes so many clusters. */
  drag: (height: number, clusters: number) => void;
  drop: () => void;
  set: (clusters: number) => void;
}

export function dendrogram(drawing: Drawing, act: Cutting): TemplateResult {
  const { merges, order, width, cut, held } = drawing;
  const scale = new Scale(merges.at(-1)?.height ?? 1, width);
  const height = held ?? cutHeight(merges, cut);
  const x = scale.x(height);
  const bottom = TOP + order.length * ROW;
  const all = branches(merges, order);
  const whole = all.length - cut + 1;
  return html`<svg class="dendrogram" width=${width} height=${bottom} viewBox="0 0 ${width} ${bottom}" role="group" aria-label="Tree of the pairs; the nearer the root, the less alike">
    ${all.map((branch, index) => (index < whole ? inOne(branch, drawing, scale) : across(branch, drawing, scale, x)))}
    ${merges.length ? knob(x, bottom, drawing, scale, act) : nothing}</svg>`;
}

class Scale {
  constructor(private readonly top: number, private readonly width: number) {}

  x(height: number): number {
    return this.width - (height / this.top) * (this.width - 2 * PAD - 8) - 2;
  }

  height(x: number): number {
    return Math.max(0, ((this.width - 2 - x) * this.top) / (this.width - 2 * PAD - 8));
  }
}

const y = (place: number): number => TOP + (place + 0.5) * ROW;
const group = (places: readonly number[], { clusters }: Drawing): number => groupOf(commonest(places.map((place) => clusters[place]!)));

/** A merge within one cluster: its own colour. */
function inOne({ height, ends, places }: Branch, drawing: Drawing, scale: Scale): SVGTemplateResult {
  const [upper, lower] = ends;
  const x = scale.x(height);
  return svg`<path class="stroke-${group(places, drawing)}" d="M${scale.x(upper.height)} ${y(upper.at)}H${x}V${y(lower.at)}H${scale.x(lower.height)}"/>`;
}

/** A merge beyond the cut: grey up to the cut, and from there on in the colour of what hangs on it. */
function across({ height, ends }: Branch, drawing: Drawing, scale: Scale, cut: number): SVGTemplateResult {
  const x = scale.x(height);
  const [upper, lower] = ends;
  const until = (end: Branch["ends"][0]) => Math.max(x, Math.min(scale.x(end.height), cut));
  return svg`<path class="stroke-5" d="M${until(upper)} ${y(upper.at)}H${x}V${y(lower.at)}H${until(lower)}"/>
    ${ends.map((end) => scale.x(end.height) > until(end)
      ? svg`<path class="stroke-${group(end.places, drawing)}" d="M${until(end)} ${y(end.at)}H${scale.x(end.height)}"/>`
      : nothing)}`;
}

function knob(x: number, bottom: number, { merges, cut, wanted: from, grip }: Drawing, scale: Scale, act: Cutting): SVGTemplateResult {
  const most = merges.length + 1;
  const move = (event: PointerEvent) => {
    if (!(event.currentTarget as Element).hasPointerCapture(event.pointerId)) return;
    const by = event.clientX - grip.pointer;
    grip.moving ||= Math.abs(by) > SLACK;
    const height = Math.min(scale.height(grip.cut + by), (merges.at(-1)?.height ?? 1) * 1.04);
    if (grip.moving) act.drag(height, Math.min(clustersAt(merges, height), 50));
  };
  const hold = (event: PointerEvent) => {
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    Object.assign(grip, { pointer: event.clientX, cut: x, moving: false });
  };
  const press = (event: KeyboardEvent) => {
    const wanted = stepped(event.key, Math.min(from, most), Math.min(most, 50));
    if (wanted === null) return;
    event.preventDefault();
    act.set(wanted);
  };
  return svg`<g class="cut" role="slider" tabindex="0" aria-label="Cut of the tree" aria-orientation="horizontal"
      aria-valuemin="1" aria-valuemax=${Math.min(most, 50)} aria-valuenow=${cut} aria-valuetext="${cut} ${cut === 1 ? "cluster" : "clusters"}"
      @keydown=${press} @pointerdown=${hold} @pointermove=${move} @pointerup=${act.drop} @pointercancel=${act.drop}>
    <rect class="reach" x=${x - 22} y="0" width="44" height=${bottom}/>
    <path d="M${x} ${TOP / 2 + 9}V${bottom}"/><circle class="ring" cx=${x} cy=${TOP / 2} r="13"/><circle class="knob" cx=${x} cy=${TOP / 2} r="8"/></g>`;
}

/** Right and up cut nearer to the leaves: one cluster more. */
export function stepped(key: string, cut: number, most: number): number | null {
  const wanted = ({ ArrowRight: cut + 1, ArrowUp: cut + 1, ArrowLeft: cut - 1, ArrowDown: cut - 1, Home: 1, End: most } as Record<string, number>)[key];
  return wanted === undefined ? null : Math.min(Math.max(wanted, 1), most);
}
