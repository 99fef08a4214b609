// <cluster-list>: the clusters in columns, to be named, and their pairs to be moved by hand.
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { icon } from "../icons";
import { typed } from "../typed";
import { ask } from "./events";
import { counted, groupOf, pairWords, share, type Cluster, type Impressions, type Pair } from "./model";
import { paint } from "./paint";

const CARRIED = "application/x-manner-pair";

@customElement("cluster-list")
export class ClusterList extends LitElement {
  @property({ attribute: false }) data!: Impressions;
  @state() private showNumbers = false;
  /** The cluster above which a pair is being carried. */
  @state() private over: string | null = null;
  /** Where a pair that was moved has come to, said aloud. */
  @state() private said = "";
  /** The pair that is being moved, with the cluster that it was in: the focus goes along. */
  private followed: { id: string; from: number | null } | null = null;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected override willUpdate(changed: PropertyValues): void {
    const pair = this.pair(this.followed?.id);
    if ((changed as Map<string, unknown>).has("data") && pair && pair.cluster !== this.followed?.from) {
      this.said = `${pairWords(pair)} is now in ${this.data.clusters[pair.cluster ?? 0]?.title ?? "another cluster"}.`;
    }
  }

  protected override updated(changed: PropertyValues): void {
    const pair = this.pair(this.followed?.id);
    if (!(changed as Map<string, unknown>).has("data") || !pair || pair.cluster === this.followed?.from) return;
    this.followed = null;
    this.querySelector<HTMLElement>(`li[data-pair="${pair.id}"] :is(select, button)`)?.focus();
  }

  private pair(id: string | undefined): Pair | undefined {
    return this.data.pairs.find((one) => one.id === id);
  }

  private move(id: string, to: string | null): void {
    this.followed = { id, from: this.pair(id)?.cluster ?? null };
    ask(this, "move", { pair: id, to });
  }

  protected override render(): TemplateResult {
    const { clusters, may_edit } = this.data;
    return html`<header class="with-button"><div>
        <h2 class="figure-title" id="clusters">${title(clusters.length)}</h2>
        <p>${may_edit ? "Give each a name that says what its pairs have in common. A pair that belongs elsewhere can be moved; that is logged. " : ""}Below the pairs: each clip’s mean over them, from the left adjectives (0) to the right ones (1).</p></div>
        <button class="button" type="button" aria-pressed=${this.showNumbers} @click=${() => (this.showNumbers = !this.showNumbers)}>${icon("table")}Show numbers</button>
      </header>
      <p class="visually-hidden" role="status">${this.said}</p>
      <div class="clusters">${repeat(clusters, ({ key }) => key, (cluster, index) => this.column(cluster, index))}</div>`;
  }

  private column(cluster: Cluster, index: number): TemplateResult {
    const { key, members } = cluster;
    const enter = (event: DragEvent) => {
      if (!event.dataTransfer?.types.includes(CARRIED)) return;
      event.preventDefault();
      this.over = key;
    };
    const drop = (event: DragEvent) => {
      const pair = event.dataTransfer?.getData(CARRIED);
      this.over = null;
      if (pair && !members.includes(pair)) this.move(pair, key);
    };
    return html`<section class="cluster group-${groupOf(index)} ${this.over === key ? "over" : ""}" aria-label=${cluster.title}
        @dragover=${enter} @dragleave=${() => (this.over = null)} @drop=${drop}>
      ${this.name(cluster)}
      <p class="tiny">${counted(members.length, "pair")}</p>
      <ul>${repeat(members, (id) => id, (id) => this.member(id, cluster))}</ul>
      ${this.values(cluster)}
    </section>`;
  }

  private name({ key, title, named }: Cluster): TemplateResult {
    if (!this.data.may_edit) return html`<h3 class="cluster-name">${title}</h3>`;
    const rename = (event: Event) => ask(this, "rename", { key, title: (event.target as HTMLInputElement).value.trim() });
    return html`<h3 class="visually-hidden">${title}</h3>
      <input class="input cluster-name" aria-label="Name of the cluster ${title}" maxlength="200" placeholder=${title} ${typed(named ? title : "")} @change=${rename}>`;
  }

  private member(id: string, cluster: Cluster): TemplateResult | typeof nothing {
    const pair = this.pair(id);
    if (!pair) return nothing;
    const carry = (event: DragEvent) => {
      event.dataTransfer?.setData(CARRIED, id);
      if (event.dataTransfer) event.dataTransfer.effectAllowed = "move";
    };
    const { may_edit } = this.data;
    return html`<li data-pair=${id} draggable=${may_edit ? "true" : "false"} @dragstart=${carry}>
      <span class="adjectives">${pairWords(pair)}</span>
      ${may_edit && !pair.moved ? this.mover(id, pairWords(pair), cluster) : nothing}
      ${pair.moved ? html`<span class="tiny moved">moved by hand${may_edit ? html` <button class="link-button" type="button" aria-label="Undo moving ${pairWords(pair)}" @click=${() => this.move(id, null)}>Undo</button>` : nothing}</span>` : nothing}</li>`;
  }

  private mover(id: string, words: string, cluster: Cluster): TemplateResult | typeof nothing {
    const others = this.data.clusters.filter(({ key }) => key !== cluster.key);
    if (!others.length) return nothing;
    const choose = (event: Event) => {
      const select = event.target as HTMLSelectElement;
      if (select.value) this.move(id, select.value);
      select.value = "";
    };
    return html`<select class="mover" aria-label="Move ${words} to" @change=${choose}><option value="">Move to…</option>
      ${others.map(({ key, title }) => html`<option value=${key}>${title}</option>`)}</select>`;
  }

  private values({ title, values }: Cluster): TemplateResult {
    return html`<table class="dots ${this.showNumbers ? "numbers" : ""}"><caption class="visually-hidden">${title}: mean of its pairs for each clip</caption>
      <thead class="visually-hidden"><tr><th scope="col">Clip</th><th scope="col">Mean</th></tr></thead>
      <tbody>${this.data.clips.map(({ label }, clip) => html`<tr><th scope="row">${label}</th>
        <td>${values[clip] == null ? nothing : html`<span class="dot" ${paint({ "--to": values[clip] })}></span>`}<span class="value">${share(values[clip])}</span></td></tr>`)}</tbody></table>`;
  }
}

function title(count: number): string {
  const words = counted(count, "cluster");
  return words.charAt(0).toUpperCase() + words.slice(1);
}
