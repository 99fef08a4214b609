// <solution-comparison>: this study's clusters beside another's.
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api, type ApiError } from "../api";
import type { components } from "../api-types";
import { problemNote } from "../graph/problem";
import { number } from "../results/words";
import { groupOf, pairWords, together, type Cluster, type Comparison, type Impressions } from "./model";
import { attempt } from "./problem";

type StudyLine = components["schemas"]["StudyLine"];

@customElement("solution-comparison")
export class SolutionComparison extends LitElement {
  @property({ attribute: false }) data!: Impressions;
  /** Sends what is not saved yet: what is compared is what is saved. */
  @property({ attribute: false }) settle: () => Promise<void> = () => Promise.resolve();
  @state() private studies: StudyLine[] | null = null;
  @state() private other = "";
  @state() private found: Comparison | null = null;
  @state() private problem: ApiError | null = null;
  @state() private busy = false;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    void attempt(async () => {
      const { studies } = await api.get<{ studies: StudyLine[] }>("/api/v1/studies");
      this.studies = studies.filter(({ slug }) => slug !== this.data.slug);
    }, (problem) => (this.problem = problem));
  }

  /** Once other choices are saved, the comparison follows. */
  protected override updated(changed: PropertyValues): void {
    const before = (changed as Map<string, unknown>).get("data") as Impressions | undefined;
    if (this.found && before && before.saved_at !== this.data.saved_at) void this.compare(this.other);
  }

  private async compare(other: string): Promise<void> {
    if (other !== this.other) this.found = null;
    this.other = other;
    if (!other) return;
    this.busy = true;
    await attempt(async () => {
      await this.settle();
      const { slug, part, kind } = this.data;
      const found = await api.get<Comparison>(`/api/v1/studies/${slug}/impressions/${part.id}/comparison`, { query: { other, kind } });
      if (this.other === other) this.found = found;
    }, (problem) => (this.problem = problem));
    this.busy = false;
  }

  protected override render(): TemplateResult {
    const { studies } = this;
    return html`<header><h2 class="figure-title" id="compared">Beside another study</h2>
        <p>Do other people, or other motions, group the same pairs? The adjusted Rand index is 1 for the same clusters and about 0 for clusters that agree by chance only. Underlined: pairs that differ.</p></header>
      ${studies && !studies.length
        ? html`<p class="quiet">There is no other study to compare with yet.</p>`
        : html`<label class="field compare-field"><span>Compare with</span>
          <select class="input" .value=${this.other} @change=${(event: Event) => void this.compare((event.target as HTMLSelectElement).value)}>
            <option value="">Choose a study</option>${studies?.map(({ slug, title }) => html`<option value=${slug}>${title}</option>`)}</select></label>`}
      ${this.busy && !this.found ? html`<p class="quiet" role="status">The two are being compared.</p>` : nothing}
      ${this.problem ? problemNote(this.problem) : nothing}
      ${this.found ? this.result(this.found) : nothing}`;
  }

  private result(found: Comparison): TemplateResult {
    const moved = new Set(found.moved.map(({ id }) => id));
    const there = new Map(found.there_clusters.map(({ title }, index) => [title, index]));
    const like = (title: string) => there.get(found.together[title] ?? "");
    return html`<p class="sentence" role="status">${together(found.sentence)}</p>
      <dl class="facts compare-facts"><div><dt>Adjusted Rand index</dt><dd>${number(found.rand)}</dd></div>
        <div><dt>Pairs kept by both</dt><dd>${found.shared}</dd></div><div><dt>Pairs that differ</dt><dd>${found.moved.length}</dd></div></dl>
      <div class="beside">
        <section><h3>${found.here}</h3>${found.here_clusters.map((cluster) =>
          this.cluster(cluster, groupOf(like(cluster.title) ?? null), moved, found.together[cluster.title]))}</section>
        <section><h3>${found.there}</h3>${found.there_clusters.map((cluster, index) => this.cluster(cluster, groupOf(index), moved))}</section>
      </div>
      ${found.moved.length ? this.differing(found) : nothing}`;
  }

  private cluster({ title, members }: Cluster, group: number, moved: Set<string>, like?: string): TemplateResult {
    return html`<div class="compared group-${group}"><h4>${title}${like && like !== title ? html` <span class="tiny">most like “${like}”</span>` : nothing}</h4>
      <p>${members.map((id, index) => html`${index ? ", " : ""}<span class=${moved.has(id) ? "differs" : ""}>${this.words(id)}</span>`)}</p></div>`;
  }

  private differing({ moved, here, there }: Comparison): TemplateResult {
    return html`<details class="differing"><summary>Pairs that differ: ${moved.length}</summary>
      <div class="table-scroll" tabindex="0" role="region" aria-label="Pairs that differ"><table><thead><tr><th scope="col">Pair</th><th scope="col">${here}</th><th scope="col">${there}</th></tr></thead>
      <tbody>${moved.map((one) => html`<tr><th scope="row" class="adjectives">${pairWords(one)}</th><td>${one.here ?? html`<span class="hint">left out</span>`}</td><td>${one.there ?? html`<span class="hint">left out</span>`}</td></tr>`)}</tbody></table></div></details>`;
  }

  private words(id: string): string {
    const pair = this.data.pairs.find((one) => one.id === id);
    return pair ? pairWords(pair) : id.replace("_", " – ");
  }
}
