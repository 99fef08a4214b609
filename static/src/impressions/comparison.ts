// <solution-comparison>: this study's clusters beside another's.
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api, type ApiError } from "../api";
import type { components } from "../api-types";
import { problemNote } from "../graph/problem";
import { number } from "../results/words";
import { comparableName, groupOf, pairWords, together, type Comparable, type Comparison, type Impressions } from "./model";
import { attempt } from "./problem";

type Cluster = components["schemas"]["ComparedCluster"];
type Pair = components["schemas"]["ComparedPair"];

@customElement("solution-comparison")
export class SolutionComparison extends LitElement {
  @property({ attribute: false }) data!: Impressions;
  /** Sends what is not saved yet: what is compared is what is saved. */
  @property({ attribute: false }) settle: () => Promise<void> = () => Promise.resolve();
  @state() private others: Comparable[] | null = null;
  @state() private other: Comparable | null = null;
  @state() private found: Comparison | null = null;
  @state() private problem: ApiError | null = null;
  @state() private busy = false;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    void this.load();
  }

  private get address(): string {
    return `/api/v1/studies/${this.data.slug}/impressions/${this.data.part.id}`;
  }

  private load(): Promise<void> {
    return attempt(async () => {
      const { kind } = this.data;
      this.others = (await api.get<{ studies: Comparable[] }>(`${this.address}/comparable`, { query: { kind } })).studies;
    }, (problem) => (this.problem = problem));
  }

  /** Once other choices are saved, the comparison follows. */
  protected override updated(changed: PropertyValues): void {
    const before = (changed as Map<string, unknown>).get("data") as Impressions | undefined;
    if (this.found && before && before.saved_at !== this.data.saved_at) void this.compare(this.other);
  }

  private async compare(other: Comparable | null): Promise<void> {
    if (other !== this.other) this.found = null;
    this.other = other;
    if (!other) return;
    this.busy = true;
    await attempt(async () => {
      await this.settle();
      const query = { other: other.slug, other_part: other.part, kind: this.data.kind };
      const found = await api.get<Comparison>(`${this.address}/comparison`, { query });
      if (this.other === other) this.found = found;
    }, (problem) => (this.problem = problem));
    this.busy = false;
  }

  protected override render(): TemplateResult {
    const { problem } = this;
    return html`<header><h2 class="figure-title" id="compared">Beside another study</h2>
        <p>Do other people, or other motions, group the same pairs? The adjusted Rand index is 1 for the same clusters and about 0 for clusters that agree by chance only. Underlined: pairs that differ.</p></header>
      ${this.others ? this.menu(this.others) : problem ? nothing : html`<p class="quiet" role="status">Studies with the same pairs are being looked for.</p>`}
      ${this.busy && !this.found ? html`<p class="quiet" role="status">The two are being compared.</p>` : nothing}
      ${problem ? problemNote(problem, this.others ? undefined : () => void this.load()) : nothing}
      ${this.found ? this.result(this.found) : nothing}`;
  }

  private menu(others: Comparable[]): TemplateResult {
    if (!others.length) return html`<p class="quiet">No other study of yours asks for the same pairs and has answers yet.</p>`;
    const choose = (event: Event) => void this.compare(others[(event.target as HTMLSelectElement).selectedIndex - 1] ?? null);
    return html`<label class="field compare-field"><span>Compare with</span>
      <select class="input" @change=${choose}><option value="">Choose a study</option>
        ${others.map((one) => html`<option value=${`${one.slug}/${one.part}`} ?selected=${one === this.other}>${comparableName(one, others)}</option>`)}</select></label>`;
  }

  private result(found: Comparison): TemplateResult {
    const { here_clusters: ours, there_clusters: theirs } = found;
    return html`<p class="sentence" role="status">${together(found.sentence)}</p>
      <dl class="facts compare-facts"><div><dt>Adjusted Rand index</dt><dd>${number(found.rand)}</dd></div>
        <div><dt>Pairs kept by both</dt><dd>${found.shared}</dd></div><div><dt>Pairs that differ</dt><dd>${found.moved.length}</dd></div></dl>
      <div class="beside">
        <section><h3>${found.here}</h3>${ours.map((one) => this.cluster(one, groupOf(one.like), theirs))}</section>
        <section><h3>${found.there}</h3>${theirs.map((one, index) => this.cluster(one, groupOf(index), ours))}</section>
      </div>
      ${found.moved.length ? this.differing(found) : nothing}`;
  }

  private cluster({ title, like, members }: Cluster, group: number, others: readonly Cluster[]): TemplateResult {
    const other = like === null ? null : others[like]!.title;
    return html`<div class="compared group-${group}"><h4>${title}${other !== null && other !== title ? html` <span class="tiny">most like “${other}”</span>` : nothing}</h4>
      <p>${members.map((pair, index) => html`${index ? ", " : ""}${this.pair(pair)}`)}</p></div>`;
  }

  private pair({ differs, turned, ...pair }: Pair): TemplateResult {
    return html`<span class=${differs ? "differs" : ""}>${pairWords(pair)}${turned ? html` <span class="tiny">turned</span>` : nothing}</span>`;
  }

  private differing({ moved, here, there }: Comparison): TemplateResult {
    return html`<details class="differing"><summary>Pairs that differ: ${moved.length}</summary>
      <div class="table-scroll" tabindex="0" role="region" aria-label="Pairs that differ"><table><thead><tr><th scope="col">Pair</th><th scope="col">${here}</th><th scope="col">${there}</th></tr></thead>
      <tbody>${moved.map((one) => html`<tr><th scope="row" class="adjectives">${pairWords(one)}</th><td>${one.here ?? html`<span class="hint">left out</span>`}</td><td>${one.there ?? html`<span class="hint">left out</span>`}</td></tr>`)}</tbody></table></div></details>`;
  }
}
