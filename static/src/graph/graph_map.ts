// The graph drawn: clips as nodes on a ring, transitions as arrows between them.
import { html, nothing, svg, type SVGTemplateResult, type TemplateResult } from "lit";
import { clipWords, type Arrow, type Key } from "./model";

const WIDTH = 340;
const HEIGHT = 268;
const NODE = { halfWidth: 47, halfHeight: 20 };

interface Point {
  x: number;
  y: number;
}

export interface MapState {
  names: readonly string[];
  arrows: readonly Arrow[];
  current: string | null;
  /** The transition that is being taken or comes next. */
  next: Key | null;
  taking: boolean;
}

export function graphMap(state: MapState, goTo: (name: string) => void): TemplateResult {
  const places = new Map(state.names.map((name, k) => [name, placeOf(k, state.names.length)]));
  const isNext = ({ source, target }: Arrow) => state.next?.source === source && state.next.target === target;
  const ordered = [...state.arrows].sort((one, other) => Number(isNext(one)) - Number(isNext(other)));
  return html`<svg class="graph-map" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="group" aria-label="Clips and the ways between them">
    <defs>${head("head", "")}${head("head-next", "next")}</defs>
    ${ordered.map((arrow) => arrowOf(arrow, places, isNext(arrow), state.taking))}
    ${state.names.map((name) => nodeOf(name, places.get(name)!, state, goTo))}
  </svg>`;
}

/** Clockwise from the left, so that four clips stand at the sides and above each other. */
function placeOf(index: number, count: number): Point {
  const angle = count === 1 ? 0 : Math.PI + (2 * Math.PI * index) / count;
  const reach = count === 1 ? 0 : 1;
  return {
    x: WIDTH / 2 + reach * (WIDTH / 2 - NODE.halfWidth - 6) * Math.cos(angle),
    y: HEIGHT / 2 + reach * (HEIGHT / 2 - NODE.halfHeight - 34) * Math.sin(angle),
  };
}

const head = (id: string, kind: string): SVGTemplateResult => svg`<marker id=${id} class=${kind} viewBox="0 0 8 8"
  refX="7" refY="4" markerWidth="8" markerHeight="8" markerUnits="userSpaceOnUse" orient="auto"><path d="M0 0 8 4 0 8z"/></marker>`;

function arrowOf(arrow: Arrow, places: Map<string, Point>, isNext: boolean, taking: boolean): SVGTemplateResult {
  const from = places.get(arrow.source);
  const to = places.get(arrow.target);
  if (!from || !to) return svg``;
  const { path, middle } = from === to ? loop(from) : bow(from, to);
  const width = Math.min(3, 0.8 + 0.45 * Math.log2(arrow.count));
  return svg`<g class="arrow ${isNext ? "next" : ""} ${isNext && taking ? "taking" : ""}">
    <path d=${path} stroke-width=${isNext ? width + 1 : width} marker-end="url(#${isNext ? "head-next" : "head"})"/>
    <text x=${middle.x} y=${middle.y} aria-hidden="true">${arrow.count}</text></g>`;
}

function nodeOf(name: string, { x, y }: Point, state: MapState, goTo: (name: string) => void): SVGTemplateResult {
  const leaving = state.arrows.some(({ target }) => target === name);
  const act = (event: Event) => {
    if (event instanceof KeyboardEvent && event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    goTo(name);
  };
  const current = state.current === name;
  const word = clipWords(name);
  const shown = word.length > 13 ? `${word.slice(0, 12)}…` : word;
  return svg`<g class="node ${current ? "current" : ""}" transform="translate(${x} ${y})" role="button"
    tabindex=${leaving ? 0 : nothing} aria-disabled=${leaving ? nothing : "true"} aria-label="Go to ${word}"
    aria-current=${current ? "true" : nothing} @click=${leaving ? act : nothing} @keydown=${leaving ? act : nothing}>
    <rect class="target" x=${-NODE.halfWidth} y="-24" width=${2 * NODE.halfWidth} height="48"/>
    <rect x=${-NODE.halfWidth} y=${-NODE.halfHeight} width=${2 * NODE.halfWidth} height=${2 * NODE.halfHeight} rx="8"/>
    <text y="5">${shown}</text></g>`;
}

/** A curve beside the straight line, so that there and back part; its ends keep off the nodes. */
function bow(from: Point, to: Point): { path: string; middle: Point } {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const aside = { x: -(to.y - from.y) / length, y: (to.x - from.x) / length };
  const bend = Math.min(26, length / 6);
  const middle = { x: (from.x + to.x) / 2 + bend * aside.x, y: (from.y + to.y) / 2 + bend * aside.y };
  const [start, end] = [edge(from, middle), edge(to, middle)];
  const label = { x: (start.x + end.x) / 4 + middle.x / 2 + 6 * aside.x, y: (start.y + end.y) / 4 + middle.y / 2 + 6 * aside.y + 4 };
  return { path: `M${text(start)}Q${text(middle)} ${text(end)}`, middle: label };
}

/** A loop at the outer side of a node. */
function loop({ x, y }: Point): { path: string; middle: Point } {
  const side = y <= HEIGHT / 2 + 1 ? -1 : 1;
  const top = y + side * (NODE.halfHeight + 2);
  const far = y + side * (NODE.halfHeight + 34);
  return {
    path: `M${x - 11} ${top}C${x - 30} ${far} ${x + 30} ${far} ${x + 11} ${top}`,
    middle: { x, y: y + side * (NODE.halfHeight + 15) + 4 },
  };
}

/** Where the line from a node's middle towards a point leaves the node. */
function edge(node: Point, towards: Point): Point {
  const way = { x: towards.x - node.x, y: towards.y - node.y };
  const share = Math.min(
    (NODE.halfWidth + 3) / Math.max(Math.abs(way.x), 1e-9),
    (NODE.halfHeight + 3) / Math.max(Math.abs(way.y), 1e-9),
  );
  return { x: node.x + share * way.x, y: node.y + share * way.y };
}

const text = ({ x, y }: Point): string => `${x.toFixed(1)} ${y.toFixed(1)}`;
