// <join-dialog>: what a clip that nobody rated would be said to be, before it joins the space.
// Event: `join` clip.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { ApiError } from "../api";
import { problemNote } from "../graph/problem";
import type { Clip } from "../studio/server";
import * as studio from "../studio/server";
import { asApiError } from "../studio/session";
import { fitted, fittingSteps, fittingWords } from "./fitting";
import * as server from "./server";
import { wordsIn } from "./words";

@customElement("join-dialog")
export class JoinDialog extends LitElement {
  @property() space = "";
  @property() language = "en";
  /** What the space becomes: “version 2”. */
  @property() next = "";
  @state() private clip: Clip | null = null;
  @state() private busy = false;
  private like: Clip | null = null;
  @state() private prediction: server.Prediction | null = null;
  @state() private problem: ApiError | null = null;
  @query("dialog") private dialog!: HTMLDialogElement | null;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  /** `like`: an example of the space. */
  async show(clip: Clip, like: Clip): Promise<void> {
    this.clip = clip;
    this.like = like;
    await this.updateComplete;
    this.dialog?.showModal();
    await this.predict(clip);
  }

  private async predict(clip: Clip): Promise<void> {
    this.prediction = this.problem = null;
    await this.attempt(async () => {
      const prediction = await server.prediction(this.space, clip.id);
      if (clip === this.clip) this.prediction = prediction;
    });
  }

  /** Go on with a copy that fits. */
  private async fit(clip: Clip, like: Clip): Promise<void> {
    await this.attempt(async () => {
      this.clip = await fitted(clip, like, (await studio.clips()).map(({ name }) => name));
    });
    if (this.clip !== clip) await this.predict(this.clip!);
  }

  private async attempt(act: () => Promise<void>): Promise<void> {
    this.busy = true;
    try {
      this.problem = null;
      await act();
    } catch (error) {
      this.problem = asApiError(error);
    } finally {
      this.busy = false;
    }
  }

  close(): void {
    this.dialog?.close();
  }

  /** The server would not take it. */
  refuse(problem: ApiError): void {
    this.problem = problem;
  }

  protected override render(): TemplateResult | typeof nothing {
    const { clip, prediction, problem } = this;
    if (!clip) return nothing;
    const join = () => this.dispatchEvent(new CustomEvent("join", { detail: clip.id }));
    return html`<dialog class="space-dialog join-dialog" aria-labelledby="join-heading" @close=${() => (this.clip = null)}>
      <header><h2 class="figure-title" id="join-heading">${clip.name}</h2>
        <button class="button quiet" type="button" @click=${() => this.close()}>Close</button></header>
      ${prediction?.can_join === false ? this.misfit(clip, prediction) : prediction ? this.table(prediction) : problem ? nothing : html`<p class="quiet" role="status">Its motion is being measured.</p>`}
      ${problem ? problemNote(problem) : nothing}
      <footer><p class="tiny">Nobody rated this clip: its place is predicted from its motion.</p>
        <button class="button primary" type="button" ?disabled=${!prediction?.can_join || this.busy} @click=${join}>Join as ${this.next}</button></footer></dialog>`;
  }

  private misfit(clip: Clip, { sentence }: server.Prediction): TemplateResult {
    const { like, busy } = this;
    const steps = like ? fittingSteps(clip, like) : [];
    return html`<p>${sentence}</p>${like && steps.length
      ? html`<p><button class="button" type="button" ?disabled=${busy} @click=${() => void this.fit(clip, like)}>${busy ? "Being made" : "Make a copy that fits"}</button>
          <span class="tiny">${fittingWords(steps)}, kept in the library</span></p>`
      : nothing}`;
  }

  private table({ sentence, parameters, level }: server.Prediction): TemplateResult {
    return html`<p>${sentence}</p>${parameters.length
      ? html`<div class="table-scroll predictions" tabindex="0" role="group" aria-label="Predictions"><table>
          <thead><tr><th scope="col">Pair</th><th scope="col">Predicted, from 0 (left word) to 1 (right word)${level === null ? nothing : `, with its ${Math.round(100 * level)}\u00a0% interval`}</th><th scope="col" class="number">Error</th></tr></thead>
          <tbody>${parameters.map((one) => this.row(one))}</tbody></table></div>`
      : nothing}`;
  }

  private row({ left, right, refused, value, low, high, error, sentence }: server.Predicted): TemplateResult {
    const pair = `${wordsIn(left, this.language)}–${wordsIn(right, this.language)}`;
    const said = value === null ? "" : `${value.toFixed(2)}, from ${(low ?? 0).toFixed(2)} to ${(high ?? 1).toFixed(2)}`;
    return html`<tr class=${refused ? "refused" : ""}><th scope="row" class="adjective">${pair}</th>
      <td>${refused || value === null ? html`<span class="tiny">${sentence}</span>` : html`<span class="interval" role="img" aria-label=${said} title=${sentence}>
        <i .style=${span(low ?? 0, high ?? 1)}></i><b .style=${`left: ${share(value)}`}></b></span>
        <span class="number" aria-hidden="true">${value.toFixed(2)}</span>`}</td>
      <td class="number">${error === null ? "–" : error.toFixed(2)}</td></tr>`;
  }
}

const share = (value: number): string => `${(100 * Math.min(Math.max(value, 0), 1)).toFixed(1)}%`;
const span = (low: number, high: number): string => `left: ${share(low)}; width: ${share(Math.min(high, 1) - Math.max(low, 0))}`;
