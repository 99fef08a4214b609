// <pair-chooser>: a dialog in which a pair of adjectives, or a feature, is found and chosen; ordered by cluster.
// Events: `choose` {id, instead}: `instead` is the slider that it takes the place of, or null.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { t } from "../words";

export interface Choosable {
  id: string;
  /** A feature's name; a pair is named by its ends. */
  title?: string | undefined;
  about?: string;
  left: string;
  right: string;
}

export interface Cluster {
  title: string;
  pairs: readonly Choosable[];
}

export interface Chosen {
  id: string;
  instead: string | null;
}

@customElement("pair-chooser")
export class PairChooser extends LitElement {
  @property({ attribute: false }) clusters: readonly Cluster[] = [];
  /** Those on show already. */
  @property({ attribute: false }) taken: readonly string[] = [];
  @property() heading = "";
  @state() private wanted = "";
  @state() private open = false;
  @query("dialog") private dialog!: HTMLDialogElement | null;
  private instead: string | null = null;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  show(instead: string | null = null): void {
    this.instead = instead;
    this.wanted = "";
    this.open = true;
    void this.updateComplete.then(() => {
      this.dialog?.showModal();
      this.querySelector<HTMLElement>("input")?.focus();
    });
  }

  private choose(id: string): void {
    this.dialog?.close();
    this.dispatchEvent(new CustomEvent<Chosen>("choose", { detail: { id, instead: this.instead } }));
  }

  protected override render(): TemplateResult | typeof nothing {
    if (!this.open) return nothing;
    const found = this.found;
    return html`<dialog class="space-dialog pair-dialog" aria-labelledby="pair-heading" @close=${() => (this.open = false)}>
      <header><h2 class="figure-title" id="pair-heading">${this.heading}</h2>
        <button class="button quiet" type="button" @click=${() => this.dialog?.close()}>${t("Close")}</button></header>
      <label class="field"><span class="label">${t("Search")}</span><input class="input" type="search" autocomplete="off" .value=${this.wanted}
        @input=${(event: Event) => (this.wanted = (event.target as HTMLInputElement).value)}></label>
      <div class="pair-list" role="group" aria-labelledby="pair-heading" tabindex="0">
        ${found.map(({ title, pairs }) => html`${title ? html`<h3 class="label">${title}</h3>` : nothing}
          <ul>${pairs.map((pair) => this.pair(pair))}</ul>`)}
        ${found.length ? nothing : html`<p class="quiet" role="status">${t("Nothing matches.")}</p>`}
      </div></dialog>`;
  }

  private pair({ id, title, about, left, right }: Choosable): TemplateResult {
    const words = title ? html`<span>${title}</span>` : html`<span>${left}</span><span aria-hidden="true">–</span><span>${right}</span>`;
    return html`<li><button type="button" class=${title ? "" : "adjective"} title=${about || nothing} @click=${() => this.choose(id)}>${words}</button></li>`;
  }

  private get found(): Cluster[] {
    const words = this.wanted.toLowerCase().split(/\s+/).filter(Boolean);
    const fits = ({ id, title = "", left, right }: Choosable, cluster: string) =>
      !this.taken.includes(id) && words.every((word) => `${title} ${left} ${right} ${cluster}`.toLowerCase().includes(word));
    return this.clusters
      .map(({ title, pairs }) => ({ title, pairs: pairs.filter((pair) => fits(pair, title)) }))
      .filter(({ pairs }) => pairs.length);
  }
}

declare global {
  interface HTMLElementTagNameMap {
    "pair-chooser": PairChooser;
  }
}
