// <solution-stability>: what becomes of pairs and clusters when participants are drawn anew.
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api, type ApiError } from "../api";
import { problemNote } from "../graph/problem";
import { darkMode, draw } from "../results/chart";
import { percent } from "../results/words";
import { groupOf, limitsOf, pairWords, sameLimits, share, together, type Impressions, type Limits, type Stability } from "./model";
import { paint } from "./paint";
import { attempt } from "./problem";
import { curve, paletteOf } from "./stability_chart";

const SAMPLES = 1000;

@customElement("solution-stability")
export class SolutionStability extends LitElement {
  @property({ attribute: false }) data!: Impressions;
  @state() private found: Stability | null = null;
  @state() private problem: ApiError | null = null;
  @state() private asking: AbortController | null = null;
  /** What the answer is about: it says so once the thresholds or the cut are others. */
  private about: Limits | null = null;
  private readonly dark = darkMode();
  private readonly redraw = () => void this.drawCurve();

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.dark.addEventListener("change", this.redraw);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.dark.removeEventListener("change", this.redraw);
    this.asking?.abort();
  }

  protected override updated(changed: PropertyValues): void {
    if ((changed as Map<string, unknown>).has("found")) this.redraw();
  }

  private async drawCurve(): Promise<void> {
    const place = this.querySelector<HTMLElement>(".curve");
    if (place && this.found) await draw(place, curve(this.found.by_participants, paletteOf(this)));
  }

  private async ask(): Promise<void> {
    const { slug, part, kind, choices } = this.data;
    const asking = (this.asking = new AbortController());
    await attempt(async () => {
      this.found = await api.get<Stability>(`/api/v1/studies/${slug}/impressions/${part.id}/stability`, {
        query: { ...limitsOf(choices), kind, samples: SAMPLES, seed: 1 }, signal: asking.signal,
      });
      this.about = limitsOf(choices);
    }, (problem) => (this.problem = problem));
    if (this.asking === asking) this.asking = null;
  }

  private cancel(): void {
    this.asking?.abort();
    this.asking = null;
  }

  protected override render(): TemplateResult {
    return html`<header><h2 class="figure-title" id="stable">Would others see the same</h2>
        <p>Participants are drawn anew, with replacement, and each time the pairs are chosen and grouped again, by the same thresholds and cut.</p></header>
      ${this.asking
        ? html`<div class="drawing" role="status"><p>Participants are being drawn anew. This takes a few seconds.</p><progress aria-label="Drawing participants anew"></progress>
          <button class="button" type="button" @click=${() => this.cancel()}>Cancel</button></div>`
        : html`<button class="button" type="button" @click=${() => void this.ask()}>Draw participants anew 1,000 times</button>`}
      ${this.problem ? problemNote(this.problem) : nothing}
      ${this.found ? this.result(this.found) : nothing}`;
  }

  private result(found: Stability): TemplateResult {
    const older = this.about && !sameLimits(this.about, limitsOf(this.data.choices));
    return html`${older ? html`<p class="note">These numbers are about the thresholds and the cut of before. Draw anew to renew them.</p>` : nothing}
      <p class="sentence" role="status">${together(found.sentence)}</p>
      <div class="stable-columns">
        <figure><figcaption><h3 class="figure-title">How many participants would do</h3>
          <p class="small quiet">Likeness to the whole solution (adjusted Rand index) from so many participants: mean, and where 95 % of the draws lie.</p></figcaption>
          <div class="curve" role="img" aria-label="Likeness over the number of participants; the numbers are in the table below"></div>
          <details><summary>Numbers</summary>${byParticipants(found)}</details></figure>
        <figure><figcaption><h3 class="figure-title">Is each cluster found again</h3>
          <p class="small quiet">Mean overlap with the most similar cluster of each draw (Jaccard). Above .75 it is a stable one, below .5 it dissolves.</p></figcaption>
          ${this.overlaps(found)}</figure>
      </div>
      <figure class="stays"><figcaption><h3 class="figure-title">How often each pair stays</h3>
        <p class="small quiet">Share of ${found.samples.toLocaleString("en")} draws in which it passes both thresholds. Grey: left out now.</p></figcaption>${this.stays(found)}</figure>`;
  }

  private overlaps({ clusters }: Stability): TemplateResult {
    return html`<table class="bars"><thead class="visually-hidden"><tr><th scope="col">Cluster</th><th scope="col">Overlap</th></tr></thead>
      <tbody>${clusters.map(({ title, overlap }, index) => html`<tr class="group-${groupOf(index)}"><th scope="row">${title}</th>
        <td><span class="bar" ${paint({ "--to": overlap })}></span></td><td class="number">${share(overlap)}</td></tr>`)}</tbody></table>`;
  }

  private stays({ pairs }: Stability): TemplateResult {
    const known = new Map(this.data.pairs.map((pair) => [pair.id, pair]));
    const sorted = [...pairs].sort((one, other) => other.kept - one.kept);
    return html`<ul class="stay-bars">${sorted.map(({ id, kept }) => {
      const pair = known.get(id);
      return html`<li class=${pair?.dropped ? "dropped" : ""}><span class="adjectives">${pair ? pairWords(pair) : id}</span>
        <span class="bar-track"><span class="bar" ${paint({ "--to": kept })}></span></span><span class="number">${percent(kept)}</span></li>`;
    })}</ul>`;
  }
}

const byParticipants = ({ by_participants }: Stability): TemplateResult => html`<table><thead><tr><th scope="col" class="number">Participants</th>
    <th scope="col" class="number">Mean</th><th scope="col" class="number">95 % of draws</th></tr></thead>
  <tbody>${by_participants.map(({ participants, mean, low, high }) => html`<tr><td class="number">${participants}</td><td class="number">${share(mean)}</td>
    <td class="number">${share(low)} to ${share(high)}</td></tr>`)}</tbody></table>`;
