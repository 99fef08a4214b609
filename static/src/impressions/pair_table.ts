// <pair-table>: how far people saw each pair of adjectives and how much they agreed, with both thresholds.
// Roles are stated because narrow screens lay the rows out as grids, which takes the native ones away.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { live } from "lit/directives/live.js";
import { number } from "../results/words";
import { typed } from "../typed";
import { ask } from "./events";
import { groupOf, pairWords, reaches, reasons, type Impressions, type Limits, type Pair } from "./model";
import { paint } from "./paint";

type Order = "part" | "peak" | "spread";

interface Threshold {
  name: "least_peak" | "most_spread";
  label: string;
  sign: string;
  value: number;
  reach: number;
}

@customElement("pair-table")
export class PairTable extends LitElement {
  @property({ attribute: false }) data!: Impressions;
  @property({ attribute: false }) limits!: Limits;
  @state() private order: Order = "part";

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected override render(): TemplateResult {
    const { pairs } = this.data;
    const reach = reaches(this.data);
    const { least_peak, most_spread } = this.limits;
    const thresholds: [Threshold, Threshold] = [
      { name: "least_peak", label: "μ* at least", sign: "≥", value: least_peak, reach: reach.peak },
      { name: "most_spread", label: "σ̄ at most", sign: "≤", value: most_spread, reach: reach.spread },
    ];
    const at = (threshold: Threshold) => Math.min(threshold.value / threshold.reach, 1);
    return html`<table class="pairs" role="table" ${paint({ "--least": at(thresholds[0]), "--most": at(thresholds[1]) })}>
      <caption class="visually-hidden">Every pair of adjectives with its μ* and σ̄, and whether it is kept</caption>
      <thead role="rowgroup">
        <tr role="row">${this.head("part", "Pair")}${this.head("peak", html`μ<sup>*</sup> <span class="meaning">strongest mean of any clip</span>`, "μ*")}${this.head("spread", html`σ̄ <span class="meaning">how much people differ</span>`, "σ̄")}
          <th scope="col" role="columnheader" class="outcome">Cluster, or why it is left out</th></tr>
        <tr class="limits" role="row"><td role="cell"><output class="kept-count" aria-live="polite"><b>${pairs.filter(({ dropped }) => !dropped).length}</b> of ${pairs.length} kept</output></td>
          ${thresholds.map((threshold) => this.threshold(threshold))}<td class="outcome" role="cell"></td></tr>
      </thead>
      <tbody role="rowgroup">${this.sorted(pairs).map((pair) => this.row(pair, reach))}</tbody>
    </table>`;
  }

  private head(order: Order, words: string | TemplateResult, name = "pair"): TemplateResult {
    const chosen = this.order === order;
    const next = () => (this.order = chosen ? "part" : order);
    const sort = order === "part" || !chosen ? nothing : order === "peak" ? "descending" : "ascending";
    return html`<th role="columnheader" scope=${order === "part" ? "col" : "colgroup"} colspan=${order === "part" ? 1 : 2} aria-sort=${sort}>
      <button class="row-button" type="button" title=${order === "part" ? "As asked in the study" : `Sort by ${name}`} @click=${next}>${words}<span class="sorted" aria-hidden="true">${sort === nothing ? "" : sort === "descending" ? " ↓" : " ↑"}</span></button></th>`;
  }

  private threshold({ name, label, sign, value, reach }: Threshold): TemplateResult {
    const set = (event: Event) => {
      const given = (event.target as HTMLInputElement).valueAsNumber;
      if (Number.isFinite(given) && given >= 0 && given <= 10) ask(this, "limits", { [name]: given });
      else this.requestUpdate(); // the field shows the limit that holds
    };
    return html`<td class="number" role="cell"><label><span class="limit-name">${label}</span><span class="sign" aria-hidden="true">${sign}</span><input class="input limit-number" type="number" min="0" max="10" step="0.01"
        aria-label="${label}, as a number" ${typed(value.toFixed(2))} @change=${set}></label></td>
      <td class="track" role="cell"><input class="threshold" type="range" min="0" max=${reach} step="0.05" .value=${live(String(value))}
        aria-label=${label} aria-valuetext=${value.toFixed(2)} data-limit=${name} @input=${set}></td>`;
  }

  private sorted(pairs: readonly Pair[]): readonly Pair[] {
    if (this.order === "part") return pairs;
    const [key, sign] = this.order === "peak" ? (["peak", -1] as const) : (["spread", 1] as const);
    return [...pairs].sort((one, other) => sign * ((one[key] ?? 0) - (other[key] ?? 0)));
  }

  private row(pair: Pair, reach: { peak: number; spread: number }): TemplateResult {
    const { id, dropped, peak, spread } = pair;
    const why = reasons(pair, this.data.choices);
    return html`<tr role="row" data-pair=${id} class=${dropped ? "dropped" : ""} title=${dropped ?? nothing}>
      <th scope="row" role="rowheader"><span class="adjectives">${pairWords(pair)}</span>${why ? html`<span class="why-small">${why}</span>` : nothing}</th>
      <td class="number" role="cell">${number(peak)}</td>${this.track("least", peak, reach.peak)}
      <td class="number" role="cell">${number(spread)}</td>${this.track("most", spread, reach.spread)}
      <td class="outcome" role="cell">${why ?? this.cluster(pair)}</td></tr>`;
  }

  private track(limit: "least" | "most", value: number | null, reach: number): TemplateResult {
    return html`<td class="track ${limit}" role="cell">${value === null ? nothing : html`<span class="bar" ${paint({ "--to": Math.min(value / reach, 1) })}></span>`}</td>`;
  }

  private cluster({ cluster, moved }: Pair): TemplateResult | typeof nothing {
    const found = cluster === null ? undefined : this.data.clusters[cluster];
    if (!found) return nothing;
    return html`<span class="group group-${groupOf(cluster)}">${found.title}</span>${moved ? html` <span class="tiny">moved by hand</span>` : nothing}`;
  }
}
