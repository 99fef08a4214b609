// <solution-stability>: what becomes of pairs and clusters when participants are drawn anew.
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api, type ApiError } from "../api";
import { problemNote } from "../graph/problem";
import { darkMode, draw } from "../results/chart";
import { percent } from "../results/words";
import { JobWatch } from "../sets/job_watch";
import { isOpen, timeLeft } from "../sets/model";
import { groupOf, limitsOf, pairWords, sameLimits, share, together, type Impressions, type Job, type Limits, type Stability } from "./model";
import { paint } from "./paint";
import { attempt } from "./problem";
import { curve, paletteOf } from "./stability_chart";

const SAMPLES = [1000, 10_000];

@customElement("solution-stability")
export class SolutionStability extends LitElement {
  @property({ attribute: false }) data!: Impressions;
  @state() private found: Stability | null = null;
  @state() private problem: ApiError | null = null;
  @state() private asking: AbortController | null = null;
  @state() private samples = SAMPLES[0]!;
  /** What the answer is about: it says so once the thresholds or the cut are others. */
  private about: Limits | null = null;
  /** What the answer under way will be about. */
  private asked: Limits | null = null;
  /** A large bootstrap is a job of the server. */
  private readonly watch = new JobWatch(this, (job) => void this.fetch(job));
  private readonly dark = darkMode();
  private readonly redraw = () => void this.drawCurve();

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.dark.addEventListener("change", this.redraw);
    addEventListener("pagehide", this.leave);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.dark.removeEventListener("change", this.redraw);
    removeEventListener("pagehide", this.leave);
    this.leave();
    this.asking?.abort();
  }

  protected override updated(changed: PropertyValues): void {
    if ((changed as Map<string, unknown>).has("found")) this.redraw();
  }

  private async drawCurve(): Promise<void> {
    const place = this.querySelector<HTMLElement>(".curve");
    if (place && this.found) await draw(place, curve(this.found, paletteOf(this)));
  }

  private get address(): string {
    return `/api/v1/studies/${this.data.slug}/impressions/${this.data.part.id}/stability`;
  }

  private attempt(act: () => Promise<void>): Promise<void> {
    return attempt(act, (problem) => (this.problem = problem));
  }

  private async ask(): Promise<void> {
    const { kind, choices } = this.data;
    const asking = (this.asking = new AbortController());
    this.asked = limitsOf(choices);
    const query = { ...this.asked, kind, samples: this.samples, seed: 1 };
    this.watch.forget();
    await this.attempt(async () => {
      const answer = await api.post<Stability | Job>(this.address, undefined, { query, signal: asking.signal });
      if ("state" in answer) this.watch.follow(answer);
      else this.show(answer);
    });
    if (this.asking === asking) this.asking = null;
  }

  private async fetch(job: Job): Promise<void> {
    if (job.state !== "done") return;
    await this.attempt(async () => {
      this.show(await api.get<Stability>(`${this.address}/${job.id}`));
      this.watch.forget();
    });
  }

  /** An earlier result stays until then: whoever cancels still has it. */
  private show(found: Stability): void {
    this.found = found;
    this.about = this.asked;
  }

  private cancel(): void {
    this.asking?.abort();
    this.asking = null;
    if (this.watch.job) void this.watch.stop();
  }

  /** Nobody would see what is still being computed. */
  private readonly leave = (): void => {
    const { job } = this.watch;
    if (job && isOpen(job)) void api.delete(`/api/v1/jobs/${job.id}`, { keepalive: true }).catch(() => {});
  };

  protected override render(): TemplateResult {
    const { job, problem } = this.watch;
    const computing = this.asking || (job && isOpen(job));
    return html`<header><h2 class="figure-title" id="stable">Would others see the same</h2>
        <p>Participants are drawn anew, with replacement, and each time the pairs are chosen and grouped again, by the same thresholds and cut. The ${this.data.participants} people here stand for all others.</p></header>
      ${computing ? this.progress(job) : this.form()}
      ${job?.state === "cancelled" ? html`<p class="quiet" role="status">Cancelled.${this.found ? " The numbers below are those of before." : ""}</p>` : nothing}
      ${job?.state === "failed" ? html`<p class="note note-bad" role="alert">The computation broke off. Draw participants anew.</p>` : nothing}
      ${problem ? problemNote(problem) : this.problem ? problemNote(this.problem) : nothing}
      ${this.found ? this.result(this.found) : nothing}`;
  }

  private form(): TemplateResult {
    const choose = (event: Event) => (this.samples = Number((event.target as HTMLSelectElement).value));
    return html`<div class="draw-form"><label class="field"><span>Draws</span><select class="input" @change=${choose}>
        ${SAMPLES.map((count) => html`<option value=${count} ?selected=${count === this.samples}>${count.toLocaleString("en")}</option>`)}</select></label>
      <button class="button" type="button" @click=${() => void this.ask()}>Draw participants anew</button></div>`;
  }

  private progress(job: Job | undefined): TemplateResult {
    const waiting = job?.state === "waiting";
    const left = job ? timeLeft(this.watch.marks, job.total) : "";
    return html`<div class="drawing"><p role="status">${waiting ? "Waiting for its turn: the server is at other work." : "Participants are being drawn anew."}</p>
      <progress aria-label="Drawing participants anew" max=${job?.total ?? 1} value=${job && !waiting ? job.done : nothing}></progress>
      <p class="small quiet">${!job ? "This takes a few seconds." : waiting ? nothing : `${percent(job.done / job.total)}${left && `, ${left}`}`}</p>
      <button class="button" type="button" @click=${() => this.cancel()}>Cancel</button></div>`;
  }

  private result(found: Stability): TemplateResult {
    const older = this.about && !sameLimits(this.about, limitsOf(this.data.choices));
    const { enough, samples } = found;
    return html`${older ? html`<p class="note">These numbers are about the thresholds and the cut of before. Draw anew to renew them.</p>` : nothing}
      <p class="sentence" role="status">${together(found.sentence)}</p>
      <div class="stable-columns">
        <figure><figcaption><h3 class="figure-title">How many participants would do</h3>
          <p class="enough"><b>${enough.whole === null ? `More than ${enough.most}` : `About ${enough.whole}`}</b> for the whole solution${enough.shared === null ? nothing : html`, <b>about ${enough.shared}</b> for the groups alone`}.</p>
          <p class="small quiet">${together(enough.sentence)}</p></figcaption>
          <div class="curve" role="img" aria-label="Agreement over the number of participants; the numbers are in the table below"></div>
          <p class="tiny curve-key"><span class="key-whole">whole solution, with 95 % of its draws</span> <span class="key-groups">groups of the pairs that both keep</span></p>
          <details><summary>Numbers</summary>${byParticipants(found)}</details></figure>
        <figure><figcaption><h3 class="figure-title">Is each cluster found again</h3>
          <p class="small quiet">Mean overlap with the most similar cluster of each draw (Jaccard), from 0 to 1. Above .75 it is a stable one, below .5 it dissolves.</p></figcaption>
          ${this.overlaps(found)}</figure>
      </div>
      <figure class="stays"><figcaption><h3 class="figure-title">How often each pair stays</h3>
        <p class="small quiet">Share of ${samples.toLocaleString("en")} draws in which it passes both thresholds. Grey: left out now.</p></figcaption>${this.stays(found)}</figure>`;
  }

  private overlaps({ clusters }: Stability): TemplateResult {
    return html`<table class="bars"><thead class="visually-hidden"><tr><th scope="col">Cluster</th><th scope="col">Overlap</th><th scope="col">Number</th></tr></thead>
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

type Agreement = Stability["whole"];
const spoken = (one: Agreement | null): TemplateResult | string => (one ? html`${share(one.mean)} <span class="quiet">(${share(one.low)} to ${share(one.high)})</span>` : "–");

const byParticipants = ({ by_participants }: Stability): TemplateResult => html`<div class="table-scroll" tabindex="0" role="region" aria-label="Agreement by number of participants"><table class="by-participants">
  <caption class="tiny">Adjusted Rand index with the solution of all participants: mean of the draws (the middle 95 %).</caption>
  <thead><tr><th scope="col" class="number">People</th><th scope="col" class="number">Whole solution</th><th scope="col" class="number">Groups</th><th scope="col" class="number">Pairs kept alike</th></tr></thead>
  <tbody>${by_participants.map(({ participants, whole, shared, kept_alike }) => html`<tr><td class="number">${participants}</td><td class="number">${spoken(whole)}</td>
    <td class="number">${spoken(shared)}</td><td class="number">${percent(kept_alike)}</td></tr>`)}</tbody></table></div>`;
