// <matching-task>: the sliders of a match with its clock and its distance. The blue figure follows the sliders, one
// request at a time. Light DOM, for the page's own styles.

import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { ApiError } from "../../api";
import { icon } from "../../icons";
import { Latest } from "../../studio/latest";
import { t } from "../../words";
import type { Form, View } from "../kind";
import { closeness, countdown, lasted } from "./face";
import "./examples";
import { ended, moved, positions, rests, slidersOf, type Parameters, type Positions } from "./model";
import { matchSliders } from "./sliders";
import { Stopwatch } from "./stopwatch";

const TICK_MS = 250;
const RETRY_MS = 1_500;
/** From one motion asked for to the next, so that many can take part at once. The server's brake lies above it. */
const APART_MS = 50;
/** The answer before this step is still on its way. */
const EARLY_MS = 300;
/** Seconds left at which those who do not see the clock are told. */
const TOLD = [60, 10];

const passed = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));

@customElement("matching-task")
export class MatchingTask extends LitElement {
  @property({ attribute: false }) view!: View<Parameters>;
  /** Metres; null while no motion is there. */
  @state() private distance: number | null = null;
  /** The line is down: the clock stands still. */
  @state() private away = false;
  @state() private refused: ApiError | null = null;
  @state() private said = "";
  /** The first picture is there; from here on the clock runs. */
  @state() private begun = false;
  @state() private beside = false;
  /** The time is up, and the last motion is being measured. */
  #closing = false;
  #opened = false;
  /** The newest form, also between two drawings of the page. */
  #form!: Form;
  #timer: ReturnType<typeof setInterval> | undefined;
  readonly #clock = new Stopwatch();
  readonly #moving = new Latest<null>(async () => void (await Promise.all([this.#make(), passed(APART_MS)])));

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearInterval(this.#timer);
  }

  protected override willUpdate(): void {
    this.#form = this.view.form;
  }

  protected override updated(): void {
    if (!this.view.workshop || this.#opened) return;
    this.#opened = true;
    this.view.workshop.arrange("ghost");
    if (this.view.step.seen) this.#moving.ask(null);
    else if (!this.#rests) this.#begin();
  }

  get #rests(): boolean {
    return rests(this.view, this.#form);
  }

  get #limit(): number {
    return 1000 * this.view.task.seconds;
  }

  #change(act: (form: Form) => Form): void {
    this.view.change((form) => (this.#form = act(form)));
  }

  /** The clock goes on from where it was when the page was last left. */
  #begin(): void {
    this.begun = true;
    this.#clock.start(this.#form.trace?.ms ?? 0);
    this.#timer = setInterval(() => this.#tick(), TICK_MS);
  }

  #tick(): void {
    const { ms } = this.#clock;
    const before = this.#form.trace?.ms ?? 0;
    if (this.#closing || !this.#clock.running) return;
    if (this.view.step.seen && ms >= this.#limit) return this.#close();
    if (Math.floor(ms / 1000) === Math.floor(before / 1000)) return;
    this.#change((form) => ({ ...form, trace: { path: form.trace?.path ?? [], ms } }));
    if (this.view.step.seen) this.#tell(before, ms);
  }

  #tell(before: number, now: number): void {
    const crossed = TOLD.find((left) => this.#limit - before > 1000 * left && this.#limit - now <= 1000 * left);
    if (crossed) this.said = crossed === 60 ? t("One minute left.") : t("Ten seconds left.");
  }

  /** The time is up. What the sliders show then is measured once more. */
  #close(): void {
    this.#closing = true;
    this.#clock.rest();
    this.requestUpdate();
    this.#moving.ask(null);
  }

  #set(id: string, position: number): void {
    if (this.#rests || this.#closing || !this.begun) return;
    const { ms } = this.#clock;
    this.#change((form) => moved(this.view, form, id, position, ms));
    if (this.view.step.seen) this.#moving.ask(null);
  }

  /** Asks for the motion of where the sliders stand now, and shows it. */
  async #make(): Promise<void> {
    const stood = positions(this.view, this.#form);
    const isLast = this.#closing;
    try {
      const { workshop, step } = this.view;
      const { glb, distance, solved } = await workshop!.make(step.index, stood);
      if (!this.isConnected) return;
      const shown = workshop!.show(glb);
      this.distance = distance;
      this.away = false;
      this.refused = null;
      await this.#go(shown);
      if (!this.#rests && this.isConnected && (solved || isLast)) this.#end(stood);
    } catch (error) {
      if (this.isConnected) this.#failed(error);
    }
  }

  /** The clock starts with the first picture, and goes on once the line is back. */
  async #go(shown: Promise<void>): Promise<void> {
    if (!this.begun) await shown;
    if (this.#rests || !this.isConnected) return;
    if (!this.begun) this.#begin();
    else if (!this.#clock.running && !this.#closing) this.#clock.start();
  }

  #end(stood: Positions): void {
    clearInterval(this.#timer);
    this.#clock.rest();
    const { ms } = this.#clock;
    this.#change((form) => ended(this.view, form, stood, ms));
    this.said = this.#verdict(ms);
  }

  #failed(error: unknown): void {
    if (!(error instanceof ApiError)) throw error;
    if (this.#closing) return this.#end(positions(this.view, this.#form));
    this.#clock.rest();
    if (error.code === "too_early") return this.#again(EARLY_MS);
    if (!error.transient) return void (this.refused = error);
    this.away = true;
    this.#again(RETRY_MS);
  }

  #again(ms: number): void {
    setTimeout(() => this.isConnected && this.#moving.ask(null), ms);
  }

  protected override render(): TemplateResult {
    const { view } = this;
    const seen = view.step.seen === true;
    const open = this.begun && !this.#closing && !this.#rests;
    return html`${seen ? this.#head() : html`<p class="match-note">${this.#rests
        ? t("Your guess is kept.") : t("Set the sliders as you think; the motion is not shown.")}</p>`}
      ${this.#trouble()}
      <fieldset class="match-sliders" ?disabled=${!open}><legend class="visually-hidden">${t("Sliders")}</legend>
        ${matchSliders(view.step.interface ?? "", slidersOf(view), positions(view, view.form), (id, value) => this.#set(id, value))}</fieldset>
      ${this.#tools(seen)}
      <p class="visually-hidden" role="status">${this.said}</p>`;
  }

  #head(): TemplateResult {
    const { task, form } = this.view;
    const ms = this.#rests || this.#closing ? Number(form.answers["seconds"] ?? task.seconds) * 1000 : (form.trace?.ms ?? 0);
    return html`<div class="match-head">
      ${this.#rests ? this.#outcome(ms) : countdown(this.#limit - ms)}
      ${closeness(this.distance, task.threshold)}</div>`;
  }

  #outcome(ms: number): TemplateResult {
    return html`<p class="match-outcome">${icon(ms < this.#limit ? "check" : "info")}<span>${this.#verdict(ms)}</span></p>`;
  }

  #verdict(ms: number): string {
    return ms < this.#limit ? lasted(ms) : t("Time is up. Go on with the next.");
  }

  #trouble(): TemplateResult | typeof nothing {
    const { refused, away } = this;
    if (refused) {
      const again = () => this.#moving.ask(null);
      return html`<p class="note" role="alert">${icon("warning")}<span>${refused.message} ${refused.mend}
        <button class="link-button" type="button" @click=${again}>${t("Try again")}</button></span></p>`;
    }
    if (!away) return nothing;
    return html`<p class="note" role="status">${icon("cloud")}<span><strong>${t("No connection.")}</strong>
      ${t("The clock stands still until the blue figure can follow again.")}</span></p>`;
  }

  #tools(seen: boolean): TemplateResult {
    const { example_figures: figures } = this.view.task;
    const turn = () => {
      this.beside = !this.beside;
      this.view.workshop?.arrange(this.beside ? "beside" : "ghost");
    };
    return html`<div class="match-tools">
      ${figures.length ? html`<matching-examples .figures=${figures}></matching-examples>` : nothing}
      ${seen ? html`<button class="button" type="button" aria-pressed=${this.beside} @click=${turn}>${t("Side by side")}</button>` : nothing}</div>`;
  }
}
