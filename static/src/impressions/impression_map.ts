// <impression-map>: Ward's tree and the impression matrix A in its order, row by row.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { icon } from "../icons";
import { number } from "../results/words";
import { dendrogram, type Grip } from "./dendrogram";
import { ask } from "./events";
import { clustersOfLeaves, counted, groupOf, pairWords, shade, share, spans, textOf, type Impressions, type Limits, type Span } from "./model";
import { paint } from "./paint";

interface Cell {
  row: number;
  column: number;
}

const FEW = 16; // clips beside which the tree may be broad
const MOST_BESIDE = 28; // clips that fit beside the tree at 1280 px

/** Room for the longest label at 45 degrees. */
const headHeight = (clips: Impressions["clips"]): number =>
  Math.min(150, 28 + 4.6 * Math.max(...clips.map(({ label }) => label.length)));

@customElement("impression-map")
export class ImpressionMap extends LitElement {
  @property({ attribute: false }) data!: Impressions;
  @property({ attribute: false }) limits!: Limits;
  @state() private showNumbers = false;
  /** The cell that is pointed at, and the one that the tab key leads to. */
  @state() private read: Cell | null = null;
  @state() private entry: Cell = { row: 0, column: 0 };
  /** Height of the cut while it is dragged. */
  @state() private held: number | null = null;
  private readonly grip: Grip = { pointer: 0, cut: 0, moving: false };
  private readonly narrow = matchMedia("(max-width: 699px)");
  private readonly fit = () => this.requestUpdate();

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.narrow.addEventListener("change", this.fit);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.narrow.removeEventListener("change", this.fit);
  }

  protected override render(): TemplateResult {
    const { data } = this;
    const { clips, kept, pairs } = data;
    return html`<header>
        <h2 class="figure-title" id="together">Which adjective pairs go together</h2>
        <p>Ward’s method over ${clips.length} clips, ${kept.length} pairs kept of ${pairs.length}. Drag the cut, or step it.</p>
        <div class="cut-steps">${this.step(-1, "fewer", "−")}<span class="cluster-count">${counted(data.clusters.length, "cluster")}</span>${this.step(1, "more", "+")}</div>
      </header>
      <div class="map-scroll ${clips.length <= MOST_BESIDE ? "fits" : ""}"><div class="map">${this.tree()}${this.table()}</div></div>
      <div class="map-foot">${this.legend()}
        <p class="readout" aria-live="polite">${this.read ? this.words(this.read) : "Point at a cell or tap it, or go to it with the arrow keys, to read it."}</p>
        <button class="button" type="button" aria-pressed=${this.showNumbers} @click=${() => (this.showNumbers = !this.showNumbers)}>${icon("table")}Show numbers</button>
      </div>
      <p class="tiny prints">For print: <a href=${this.figure("heat-map")} download>the matrix</a>, <a href=${this.figure("dendrogram")} download>the tree</a> (SVG)</p>`;
  }

  private figure(name: string): string {
    const { slug, part, kind } = this.data;
    const query = new URLSearchParams({ part: part.id, kind, ...Object.fromEntries(Object.entries(this.limits).map(([limit, value]) => [limit, String(value)])) });
    return `/research/studies/${slug}/impressions/figures/${name}.svg?${query}`;
  }

  private tree(): TemplateResult {
    const { merges, kept, leaves, clusters, clips } = this.data;
    const row = new Map(leaves.map((id, place) => [id, place]));
    return dendrogram(
      {
        merges, held: this.held, grip: this.grip, cut: Math.max(1, clusters.length), wanted: this.limits.clusters, width: this.narrow.matches ? 104 : clips.length > FEW ? 180 : 268,
        order: kept.map((id) => row.get(id)!), clusters: clustersOfLeaves(this.data),
      },
      {
        drag: (height, wanted) => ((this.held = height), this.cutInto(wanted)),
        drop: () => (this.held = null),
        set: (wanted) => this.cutInto(wanted),
      },
    );
  }

  private step(by: number, words: string, sign: string): TemplateResult {
    const wanted = this.limits.clusters + by;
    const most = Math.min(this.data.kept.length, 50);
    return html`<button class="button" type="button" aria-label="One cluster ${words}" ?disabled=${wanted < 1 || wanted > most} @click=${() => this.cutInto(wanted)}>${sign}</button>`;
  }

  private cutInto(clusters: number): void {
    if (clusters !== this.limits.clusters) ask(this, "limits", { clusters });
  }

  private table(): TemplateResult {
    const { clips, leaves } = this.data;
    const places = new Map(spans(clustersOfLeaves(this.data)).map((span) => [span.from, span]));
    return html`<table class="heat ${this.showNumbers ? "numbers" : ""}" role="grid" aria-label="Impression matrix: how far each clip is from the left adjective (0) to the right one (1)"
        ${paint({ "--head": `${headHeight(clips)}px` })} @keydown=${this.press} @pointerleave=${() => (this.read = null)}>
      <thead><tr><th scope="col"><span class="visually-hidden">Pair</span></th>
        ${clips.map(({ label }) => html`<th scope="col" class="clip"><span>${label}</span></th>`)}
        <th scope="col"><span class="visually-hidden">Cluster</span></th></tr></thead>
      <tbody>${leaves.map((id, row) => html`<tr>
        <th scope="row">${this.pairOf(id)}</th>
        ${clips.map((_, column) => this.cell({ row, column }))}
        ${this.bracket(places.get(row))}</tr>`)}</tbody></table>`;
  }

  private pairOf(id: string): string {
    const pair = this.data.pairs.find((one) => one.id === id);
    return pair ? pairWords(pair) : id;
  }

  private cell(cell: Cell): TemplateResult {
    const value = this.data.matrix[cell.column]?.[cell.row] ?? null;
    const { gap, into } = shade(value ?? 0.5);
    const entry = this.entry.row === cell.row && this.entry.column === cell.column;
    const show = () => (this.read = cell);
    return html`<td class="cell ${value === null ? "unrated" : `gap-${gap}`}" tabindex=${entry ? 0 : -1} ${paint({ "--into": `${(into * 100).toFixed(0)}%` })}
      @pointerenter=${show} @focus=${() => ((this.entry = cell), show())}><span>${share(value)}</span></td>`;
  }

  private bracket(span: Span | undefined): TemplateResult | typeof nothing {
    if (!span) return nothing;
    return html`<td class="bracket group-${groupOf(span.cluster)}" rowspan=${span.length}><span>${this.data.clusters[span.cluster]?.title}</span></td>`;
  }

  private legend(): TemplateResult {
    return html`<p class="ramp"><span>left adjective</span>${[1, 2, 3, 4, 5].map((step) => html`<i class="step-${step}"></i>`)}<span>right adjective</span></p>`;
  }

  private words({ row, column }: Cell): TemplateResult | typeof nothing {
    const { clips, leaves, pairs, matrix, means, spreads } = this.data;
    const place = pairs.findIndex(({ id }) => id === leaves[row]);
    const [clip, pair, value] = [clips[column], pairs[place], matrix[column]?.[row]];
    if (!clip || !pair || value === undefined) return nothing;
    if (value === null) return html`<b>${clip.label}</b>, ${pairWords(pair)}: <span class="quiet">nobody rated it.</span>`;
    const toward = value < 0.475 ? textOf(pair.left) : value > 0.525 ? textOf(pair.right) : "neither";
    return html`<b>${clip.label}</b>, ${pairWords(pair)}: ${share(value)}, <span class="toward">${toward}</span>.
      <span class="quiet">Mean ${number(means[column]?.[place] ?? null, 2, true)}, spread ${number(spreads[column]?.[place] ?? null)}, ${counted(clip.raters, "rater")}.</span>`;
  }

  private readonly press = (event: KeyboardEvent): void => {
    const { row, column } = this.entry;
    const [rows, columns] = [this.data.leaves.length, this.data.clips.length];
    const to = ({
      ArrowLeft: [row, column - 1], ArrowRight: [row, column + 1], ArrowUp: [row - 1, column], ArrowDown: [row + 1, column],
      Home: [row, 0], End: [row, columns - 1],
    } as Record<string, [number, number]>)[event.key];
    if (!to || !(event.target as Element).matches(".cell")) return;
    event.preventDefault();
    const next = { row: Math.min(Math.max(to[0], 0), rows - 1), column: Math.min(Math.max(to[1], 0), columns - 1) };
    this.querySelectorAll<HTMLElement>(".heat tbody tr")[next.row]?.querySelectorAll<HTMLElement>(".cell")[next.column]?.focus();
  };

  /** The tree may have fewer rows than before: the tab key still leads into the table. */
  protected override willUpdate(): void {
    const { leaves, clips } = this.data;
    if (this.entry.row >= leaves.length || this.entry.column >= clips.length) this.entry = { row: 0, column: 0 };
  }
}
