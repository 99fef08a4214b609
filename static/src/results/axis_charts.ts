// <axis-charts>: every clip on one axis at a time, as charts, as a sentence and as numbers.
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { components } from "../api-types";
import { icon } from "../icons";
import { darkMode, dataOf, draw, type Spec } from "./chart";
import { italics } from "./pole_table";
import { interval, number, percent } from "./words";

type StudyResults = components["schemas"]["StudyResults"];
type Axis = components["schemas"]["Axis"];

const KINDS = ["shares", "means"] as const;
export type Charts = Record<string, { light: Spec; dark: Spec }>;

@customElement("axis-charts")
export class AxisCharts extends LitElement {
  /** Ids of the elements in which the page keeps its numbers and its charts as JSON. */
  @property({ attribute: "results-in" }) resultsIn = "results";
  @property({ attribute: "charts-in" }) chartsIn = "charts";
  @state() private chosen = 0;
  @state() private showNumbers = false;
  private results!: StudyResults;
  private charts!: Charts;
  private readonly dark = darkMode();
  private readonly redraw = () => void this.drawCharts();

  protected override createRenderRoot(): HTMLElement {
    this.results = dataOf<StudyResults>(this.resultsIn);
    this.charts = dataOf<Charts>(this.chartsIn);
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.dark.addEventListener("change", this.redraw);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.dark.removeEventListener("change", this.redraw);
  }

  private get axis(): Axis {
    const axis = this.results.axes[this.chosen];
    if (!axis) throw new RangeError(`the study has no axis ${this.chosen}`);
    return axis;
  }

  protected override updated(changed: PropertyValues): void {
    if ((changed as Map<string, unknown>).has("chosen")) this.redraw(); // also true the first time
  }

  private async drawCharts(): Promise<void> {
    const mode = this.dark.matches ? "dark" : "light";
    for (const kind of KINDS) {
      const place = this.querySelector<HTMLElement>(`[data-chart=${kind}]`);
      const chart = this.charts[`${kind}-${this.axis.id}`];
      if (place && chart) await draw(place, chart[mode]);
    }
  }

  protected override render(): TemplateResult {
    const { left, right, title, sentence, steps, bipolar, lowest, highest } = this.axis;
    const range = `${number(lowest, 0)} to ${number(highest, 0)}`;
    return html`${this.axisSwitch()}
      <div class="columns charts">
        ${steps.length
          ? html`<figure><figcaption><h3 class="figure-title">${bipolar ? `How ${left} or ${right} each clip looked` : title}</h3>
          <p class="small quiet">Share of ${this.results.participants} participants at each step${bipolar ? ", centred on the middle" : ""}. Number: mean, ${range}.</p></figcaption>
          <div class="chart" data-chart="shares" role="img" aria-label="Shares of the answers, ${left} to ${right}; the numbers are in the table below"></div></figure>`
          : nothing}
        <figure><figcaption><h3 class="figure-title">${steps.length ? "Mean and 95 % interval" : `${title}: mean and 95 % interval`}</h3>
          <p class="small quiet">${bipolar ? "Coloured where the interval lies on one side of the middle." : `From ${range}, ${this.results.participants} participants.`}</p></figcaption>
          <div class="chart" data-chart="means" role="img" aria-label="Means with 95 % intervals, ${left} to ${right}; the numbers are in the table below"></div></figure>
      </div>
      <p class="sentence">${italics(sentence)}</p>
      <button class="button" aria-expanded=${this.showNumbers} @click=${() => (this.showNumbers = !this.showNumbers)}>${icon("table")}${this.showNumbers ? "Hide the numbers" : "Numbers"}</button>
      ${this.showNumbers ? this.numbers() : nothing}`;
  }

  private axisSwitch(): TemplateResult | typeof nothing {
    if (this.results.axes.length < 2) return nothing;
    return html`<div class="chips axis-switch" role="group" aria-label="Axis">
      ${this.results.axes.map(
        ({ title }, index) => html`<button class="chip" aria-pressed=${index === this.chosen}
          @click=${() => (this.chosen = index)}>${title}</button>`,
      )}
    </div>`;
  }

  private numbers(): TemplateResult {
    const { clips } = this.results;
    const { left, right, steps, bipolar, cells } = this.axis;
    const half = steps.length >> 1;
    const heads = steps.map((step, index) => (bipolar ? `${step} ${index < half ? left : index > half ? right : ""}` : step));
    return html`<div class="table-scroll" tabindex="0" role="region" aria-label="Numbers, ${left} to ${right}">
      <table><thead><tr><th scope="col">Clip</th><th class="number" scope="col"><em>n</em></th>
        <th class="number" scope="col"><em>M</em></th><th class="number" scope="col"><em>SD</em></th>
        <th class="number" scope="col">95 % interval</th>
        ${heads.map((head) => html`<th class="number" scope="col">${head}</th>`)}</tr></thead>
      <tbody>${cells.map(
        (cell) => html`<tr><th scope="row">${clips.find(({ id }) => id === cell.clip)?.label}</th>
          <td class="number">${cell.n}</td><td class="number">${number(cell.mean)}</td>
          <td class="number">${number(cell.sd)}</td><td class="number">${interval(cell.low, cell.high)}</td>
          ${steps.map((_, step) => html`<td class="number">${cell.shares ? percent(cell.shares[step] ?? 0) : "–"}</td>`)}</tr>`,
      )}</tbody></table></div>`;
  }
}
