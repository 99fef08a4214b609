// <manner-trial token="…">: leads through the steps of a session, one after the other, and keeps every answer safe.
// <manner-trial preview="…">: the same with a draft from that address; nothing is kept. Light DOM, so that the page's
// own styles and its skip link reach inside.

import { html, LitElement, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { ApiError } from "../api";
import type { Outbox } from "../outbox";
import type { Form, Workshop } from "../trials/kind";
import { focusNextOpen } from "../trials/steps";
import { language, t } from "../words";
import { brand } from "./brand";
import { NOTHING_YET, TrialClock } from "./clock";
import { Course, type Draft, type GivenAnswer } from "./course";
import { FigureStage } from "./figure_stage";
import { filesOf, shownOf } from "./figures";
import { asked, kindOf, withFigures } from "./kinds";
import { face, type Scene } from "./layouts";
import { elapsedSince, measures, sum, UNWATCHED, watched } from "./measures";
import { clipOnItsWay, otherTab, previewOver, sending, stuck, type Line } from "./notices";
import { claimSession } from "./one_tab";
import { Preloader } from "./preload";
import { desk, previewDesk, type Desk } from "./desk";

/** Between two answers at least; a double click must not answer the next step. */
const ARM_MS = 350;
const SLOW_MS = 5_000;
const RETRY_MS = 2_000;

type Phase =
  | { name: "opening" | "step" | "sending" | "other tab" | "preview over" }
  | { name: "stuck"; title: string; text: string; help?: string };

@customElement("manner-trial")
export class TrialPage extends LitElement {
  @property() token = "";
  @property() preview = "";
  @state() private phase: Phase = { name: "opening" };
  @state() private form: Form = { answers: {}, touched: [], comment: "" };
  /** The current step's files are there; the viewer does the rest. */
  @state() private fetched = false;
  /** Answers are taken. */
  @state() private ready = false;
  @state() private slow = false;
  @state() private pressed = false;

  #desk!: Desk;
  #course!: Course;
  #preloader!: Preloader;
  #clock = new TrialClock();
  #draft: Draft = { form: this.form, attention: NOTHING_YET, viewing: UNWATCHED, figures: [], start: {} };
  #lastAnswer = -Infinity;
  readonly #workshop: Workshop = {
    make: (step, values) => this.#desk.motion(step, values),
    show: (glb) => this.#stage.create(glb),
    arrange: (way) => this.#stage.arrange(way),
  };
  #stage = new FigureStage(this, { begin: () => this.#begin(), unsupported: () => this.#cannotDraw() });

  protected override createRenderRoot(): HTMLElement {
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#desk = this.preview ? previewDesk(this.preview) : desk(this.token, (...given) => this.#course.accept(...given));
    this.#outbox.addEventListener("change", () => this.requestUpdate());
    if (!this.preview) claimSession(this.#desk.name, () => this.#yield());
    window.addEventListener("online", () => void this.#outbox.flush());
    window.addEventListener("offline", () => this.requestUpdate());
    window.addEventListener("pagehide", () => this.#keepDraft());
    window.addEventListener("pageshow", (event) => event.persisted && location.reload());
    document.addEventListener("visibilitychange", () => document.hidden && this.#keepDraft());
    window.addEventListener("keydown", (event) => this.#onKey(event));
    void this.#open();
  }

  get #outbox(): Outbox<GivenAnswer> {
    return this.#desk.outbox;
  }

  get #line(): Line {
    const { waiting, failing, refusal } = this.#outbox;
    return { waiting, refusal, offline: !navigator.onLine || failing };
  }

  async #open(): Promise<void> {
    try {
      elapsedSince(this.#desk.store);
      // The viewer is large: it comes beside the session and the first clips.
      const drawing = import("../viewer/motion_viewer").catch(incomplete);
      const session = await this.#desk.session();
      if (session.state === "withdrawn") throw new ApiError("withdrawn", t("Your answers are deleted."), null, null, 410);
      if (session.state !== "active") return this.#desk.leave();
      this.#course = new Course(withFigures(session), this.#desk.store, this.#outbox);
      this.#preloader = new Preloader(this.#course.session.steps.map(filesOf), { fetch: this.#desk.bytes });
      void this.#outbox.flush();
      void this.#preloader.want(this.#course.index);
      await drawing;
      await this.#show();
    } catch (error) {
      this.#stuck(error);
    }
  }

  #stuck(error: unknown): void {
    const { message, mend } = error instanceof ApiError ? error : { message: String(error), mend: null };
    this.phase = { name: "stuck", title: message, text: mend ?? t("What you have answered is kept.") };
  }

  /** Show the current step as soon as its figures are there, or the end. */
  async #show(): Promise<void> {
    const { index, step } = this.#course;
    if (!step) return this.#finish();
    this.#draft = this.#course.draft();
    this.phase = { name: "step" };
    this.form = this.#draft.form;
    this.ready = this.slow = this.fetched = this.pressed = false;
    const patience = setTimeout(() => (this.slow = true), SLOW_MS);
    const kept = await this.#preloader.want(index, () => this.requestUpdate());
    clearTimeout(patience);
    if (index !== this.#course.index || this.phase.name !== "step") return;
    this.fetched = true;
    await this.#stage.show(shownOf(step, kept), kindOf(step).layout !== "stage", this.#draft.figures);
  }

  /** The first picture is there: the time runs, and answers are taken. */
  #begin(): void {
    if (this.phase.name !== "step" || this.#clock.running) return;
    this.#clock.start(this.#draft.attention);
    const arm = () => {
      this.ready = true;
      if (this.#lastAnswer > 0) void this.updateComplete.then(() => this.#focusFirst());
    };
    const rest = ARM_MS - (performance.now() - this.#lastAnswer);
    if (rest > 0) setTimeout(arm, rest);
    else arm();
  }

  #focusFirst(): void {
    this.querySelector(".panel-scroll, .cells-scroll, .page-scroll")?.scrollTo(0, 0);
    if (this.form.touched.length && focusNextOpen(this, null)) return;
    const first = ".scale [tabindex='0'], .slider input, .match-sliders input, .pick input, .place-button, .own-words textarea";
    const target = this.querySelector<HTMLElement>(first) ?? this.querySelector<HTMLElement>("#content");
    target?.focus({ preventScroll: true });
  }

  #change(form: Form): void {
    this.form = form;
    this.#keepDraft();
  }

  #keepDraft(): void {
    if (this.phase.name !== "step" || !this.#clock.running) return;
    const attention = this.#clock.read();
    const { watched: figures } = this.#stage;
    this.#course.keepDraft({ ...this.#draft, form: this.form, attention, viewing: this.#viewing, figures });
  }

  get #viewing() {
    return sum(this.#draft.viewing, watched(this.#stage.viewer));
  }

  #next(): void {
    const { step } = this.#course;
    if (!this.ready || !step) return;
    if (!kindOf(step).isComplete(asked(this.#course.session, step), this.form)) return this.#complain();
    const elapsed = elapsedSince(this.#desk.store);
    const attention = this.#clock.read();
    const { viewer, watched: figures } = this.#stage;
    const { start } = this.#draft;
    const path = this.form.trace?.path ?? [];
    this.#course.answer(this.form, measures({ attention, elapsed, viewer, viewing: this.#viewing, figures, start, path }));
    this.#leave();
  }

  /** Something is missing: say what, where it is. */
  #complain(): void {
    this.pressed = true;
    void this.updateComplete.then(() => {
      const error = this.querySelector(".field-error")?.closest(".field");
      error?.querySelector<HTMLElement>("input, textarea, select")?.focus();
    });
  }

  #back(): void {
    const { before } = this.#course;
    if (!this.ready || before === null) return;
    this.#keepDraft();
    this.#course.goTo(before);
    this.#leave();
  }

  #leave(): void {
    this.#clock.stop();
    this.#lastAnswer = performance.now();
    void this.#show().catch((error: unknown) => this.#stuck(error));
  }

  /** Every answer first, then the end: no code before the server has acknowledged all. */
  async #finish(): Promise<void> {
    if (this.preview) return void (this.phase = { name: "preview over" });
    this.phase = { name: "sending" };
    await this.#outbox.flush();
    if (this.#outbox.waiting || this.phase.name !== "sending") return;
    try {
      await this.#desk.complete();
      this.#desk.leave();
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      const missing = error.where?.["missing"];
      if (error.code === "answers_missing" && Array.isArray(missing)) {
        this.#course.reopen(missing as number[]);
        void this.#show();
      } else if (error.transient) setTimeout(() => void this.#finish(), RETRY_MS);
      else this.#stuck(error);
    }
  }

  #yield(): void {
    this.#keepDraft();
    this.#outbox.stop();
    this.#clock.stop();
    this.#stage.viewer?.pause();
    this.phase = { name: "other tab" };
  }

  /** Enter goes on from whatever is answered with the keyboard: to what is still open, else to the next step. */
  #onKey(event: KeyboardEvent): void {
    if (event.key !== "Enter" || event.repeat || this.phase.name !== "step") return;
    const { target } = event;
    const onAnswer = target instanceof HTMLInputElement && ["radio", "range"].includes(target.type);
    const anywhere = event.ctrlKey || event.metaKey;
    if (!(anywhere || onAnswer || target === document.body)) return;
    event.preventDefault();
    if (!anywhere && focusNextOpen(this, target as Element)) return;
    this.#next();
  }

  protected override render(): TemplateResult {
    const { phase } = this;
    if (phase.name === "step") return face(this.#scene());
    const text = {
      opening: () => html`<p class="checking">${t("The first clip is on its way.")}</p>`,
      sending: () => sending(this.#line, () => location.reload()),
      "other tab": () => otherTab(),
      "preview over": () => previewOver(() => location.reload()),
      stuck: () => (phase.name === "stuck" ? stuck(phase.title, phase.text, phase.help) : html``),
    }[phase.name]();
    return html`<header class="topbar">${brand()}</header><main class="plain" id="content" tabindex="-1">${text}</main>`;
  }

  #scene(): Scene {
    const course = this.#course;
    const step = course.step!;
    const { form, pressed, ready, fetched } = this;
    const { paused, unseen } = this.#stage;
    return {
      course, ready, fetched, paused, unseen,
      kind: kindOf(step),
      view: { ...asked(course.session, step), form, pressed, workshop: ready ? this.#workshop : null, change: (act) => this.#change(act(this.form)) },
      viewer: this.#figuresShown(kindOf(step).layout !== "stage"),
      line: this.#line,
      isSeen: (place) => this.#stage.isSeen(place),
      back: () => this.#back(),
      next: () => this.#next(),
      togglePause: () => this.#stage.togglePause(),
    };
  }

  #figuresShown(cells: boolean): TemplateResult {
    const waiting = () => clipOnItsWay(this.#preloader.share(this.#course.index), this.slow, () => location.reload());
    return html`${this.#stage.draw(cells, !this.fetched)}${this.fetched ? "" : waiting()}`;
  }

  #cannotDraw(): void {
    this.phase = {
      name: "stuck",
      title: t("This browser cannot draw the clips"),
      text: t("What you have answered is kept. Open this page’s address in another browser or on another device, and go on there."),
      help: `/no-webgl?lang=${language()}`,
    };
  }
}

function incomplete(): never {
  throw new ApiError("offline", t("The page did not load completely."), null, t("Check the connection, then try again."), 0);
}
