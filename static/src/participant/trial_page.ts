// <manner-trial token="…">: shows one clip after the other and keeps every answer safe. Light DOM, so that the
// page's own styles and its skip link reach inside.

import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api, ApiError } from "../api";
import { Outbox } from "../outbox";
import { blank, choose, type Form } from "../trials/semantic_differential";
import { NOTHING_YET, TrialClock } from "./clock";
import { Course, UNWATCHED, type Draft, type GivenAnswer, type Session, type StoredAnswer } from "./course";
import { brand } from "./brand";
import { comment, footer } from "./panel";
import { elapsedSince, measures, sum, watched, type Viewer } from "./measures";
import { clipOnItsWay, lineNote, otherTab, savedMark, sending, stuck, type Line } from "./notices";
import { claimSession } from "./one_tab";
import { Preloader } from "./preload";
import { scales } from "./scales";
import { fingerprint, Store } from "./store";

/** Between two answers at least; a double click must not answer the next clip. */
const ARM_MS = 350;
const SLOW_MS = 5_000;
const SEND_TIMEOUT_MS = 15_000;

type Phase =
  | { name: "opening" | "trial" | "sending" | "other tab" }
  | { name: "stuck"; title: string; text: string; help?: string };

@customElement("manner-trial")
export class TrialPage extends LitElement {
  @property() token = "";
  @state() private phase: Phase = { name: "opening" };
  @state() private form: Form = blank({ scales: [] });
  @state() private clip = "";
  @state() private figure = "";
  /** The current trial's files are there; the viewer does the rest. */
  @state() fetched = false;
  /** Answers are taken. */
  @state() ready = false;
  @state() private slow = false;

  #store!: Store;
  #outbox!: Outbox<GivenAnswer>;
  #course!: Course;
  #preloader!: Preloader;
  #clock = new TrialClock();
  #draft: Draft = { form: this.form, attention: NOTHING_YET, viewing: UNWATCHED };
  /** What the viewer had counted when the trial began, where it goes on with the same clip. */
  #counted = UNWATCHED;
  #lastAnswer = -Infinity;

  protected override createRenderRoot(): HTMLElement {
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#store = new Store(this.token);
    this.#outbox = new Outbox<GivenAnswer>({
      store: this.#store,
      send: (answer) =>
        api.post(`${this.#path}/responses`, answer, {
          keepalive: true,
          signal: AbortSignal.timeout(SEND_TIMEOUT_MS),
        }),
      onConflict: (answer, stored) => this.#course.accept(answer.trial_index, stored as StoredAnswer | undefined),
    });
    this.#outbox.addEventListener("change", () => this.requestUpdate());
    claimSession(fingerprint(this.token), () => this.#yield());
    window.addEventListener("online", () => void this.#outbox.flush());
    window.addEventListener("offline", () => this.requestUpdate());
    window.addEventListener("pagehide", () => this.#keepDraft());
    window.addEventListener("pageshow", (event) => event.persisted && location.reload());
    document.addEventListener("visibilitychange", () => document.hidden && this.#keepDraft());
    window.addEventListener("keydown", (event) => this.#onKey(event));
    void this.#open();
  }

  get #path(): string {
    return `/api/v1/sessions/${encodeURIComponent(this.token)}`;
  }

  get #page(): string {
    return `/take/${encodeURIComponent(this.token)}`;
  }

  get #viewer(): Viewer | null {
    return this.querySelector<HTMLElement & Viewer>("motion-viewer");
  }

  get #line(): Line {
    const { waiting, failing, refusal } = this.#outbox;
    return { waiting, refusal, offline: !navigator.onLine || failing };
  }

  async #open(): Promise<void> {
    try {
      elapsedSince(this.#store);
      // The viewer is large: it comes beside the session and the first clips.
      const viewer = import("../viewer/motion_viewer").catch(incomplete);
      const session = await api.get<Session>(this.#path);
      if (session.state === "complete") return location.replace(`${this.#page}/thanks`);
      if (session.state === "withdrawn") throw new ApiError("withdrawn", "Your answers are deleted.", null, null, 410);
      this.#course = new Course(session, this.#store, this.#outbox);
      const files = session.trials.map(({ glb_url, figure_url }) => [glb_url, ...(figure_url ? [figure_url] : [])]);
      this.#preloader = new Preloader(files, { fetch: (url, onShare) => api.bytes(url, undefined, onShare) });
      void this.#outbox.flush();
      void this.#preloader.want(this.#course.index);
      await viewer;
      await this.#show();
    } catch (error) {
      this.#stuck(error);
    }
  }

  #stuck(error: unknown): void {
    const { message, mend } = error instanceof ApiError ? error : { message: String(error), mend: null };
    this.phase = { name: "stuck", title: message, text: mend ?? "What you have answered is kept." };
  }

  /** Show the current trial as soon as its clip is there, or the end. */
  async #show(): Promise<void> {
    const { index, finished } = this.#course;
    if (finished) return this.#finish();
    this.#draft = this.#course.draft();
    this.phase = { name: "trial" };
    this.form = this.#draft.form;
    this.ready = this.slow = this.fetched = false;
    const patience = setTimeout(() => (this.slow = true), SLOW_MS);
    const [clip = "", figure = ""] = await this.#preloader.want(index, () => this.requestUpdate());
    clearTimeout(patience);
    if (index !== this.#course.index || this.phase.name !== "trial") return;
    this.fetched = true;
    if (clip === this.clip && this.#viewer) {
      this.#counted = watched(this.#viewer);
      this.#viewer.replay();
      this.#begin();
    } else {
      this.#counted = UNWATCHED;
      this.clip = clip;
      this.figure = figure;
    }
  }

  /** The clip's first picture is there: the time runs, and answers are taken. */
  #begin(): void {
    if (this.phase.name !== "trial" || this.#clock.running) return;
    this.#clock.start(this.#draft.attention);
    const arm = () => {
      this.ready = true;
      if (this.#lastAnswer > 0) void this.updateComplete.then(() => this.#focusFirstScale());
    };
    const rest = ARM_MS - (performance.now() - this.#lastAnswer);
    if (rest > 0) setTimeout(arm, rest);
    else arm();
  }

  #focusFirstScale(): void {
    this.querySelector(".panel-scroll")?.scrollTo(0, 0);
    this.querySelector<HTMLInputElement>(".scale input:checked")?.focus({ preventScroll: true });
  }

  #change(form: Form): void {
    this.form = form;
    this.#keepDraft();
  }

  #keepDraft(): void {
    if (this.phase.name !== "trial" || !this.#clock.running) return;
    this.#course.keepDraft({ form: this.form, attention: this.#clock.read(), viewing: this.#viewing });
  }

  get #viewing() {
    return sum(this.#draft.viewing, watched(this.#viewer), this.#counted);
  }

  #next(): void {
    if (!this.ready) return;
    const elapsed = elapsedSince(this.#store);
    this.#course.answer(this.form, measures(this.#clock.read(), elapsed, this.#viewing, this.#viewer));
    this.#leave();
  }

  #back(): void {
    if (!this.ready) return;
    this.#keepDraft();
    this.#course.goTo(this.#course.index - 1);
    this.#leave();
  }

  #leave(): void {
    this.#clock.stop();
    this.#lastAnswer = performance.now();
    void this.#show();
  }

  /** Every answer first, then the end: no code before the server has acknowledged all. */
  async #finish(): Promise<void> {
    this.phase = { name: "sending" };
    await this.#outbox.flush();
    if (this.#outbox.waiting || this.phase.name !== "sending") return;
    try {
      await api.post(`${this.#path}/complete`);
      location.replace(`${this.#page}/thanks`);
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      const missing = error.where?.["missing"];
      if (error.code === "answers_missing" && Array.isArray(missing)) {
        this.#course.reopen(missing as number[]);
        void this.#show();
      } else if (error.transient) setTimeout(() => void this.#finish(), 2_000);
      else this.#stuck(error);
    }
  }

  #yield(): void {
    this.#keepDraft();
    this.#outbox.stop();
    this.#clock.stop();
    this.#viewer?.pause();
    this.phase = { name: "other tab" };
  }

  #onKey(event: KeyboardEvent): void {
    if (event.key !== "Enter" || event.repeat || this.phase.name !== "trial") return;
    const { target } = event;
    const onScale = target instanceof HTMLInputElement && target.type === "radio";
    if (!(event.ctrlKey || event.metaKey || onScale || target === document.body)) return;
    event.preventDefault();
    this.#next();
  }

  protected override render(): TemplateResult {
    const { phase } = this;
    if (phase.name === "trial") return this.#trial();
    const text = {
      opening: () => html`<p class="checking">The first clip is on its way.</p>`,
      sending: () => sending(this.#line, () => location.reload()),
      "other tab": () => otherTab(),
      stuck: () => (phase.name === "stuck" ? stuck(phase.title, phase.text, phase.help) : html``),
    }[phase.name]();
    return html`<header class="topbar">${brand()}</header><main class="plain" id="content" tabindex="-1">${text}</main>`;
  }

  #trial(): TemplateResult {
    const { index, length, answered, session } = this.#course;
    return html`<header class="trial-bar">
        ${brand()}
        <div class="place"><span aria-live="polite"><strong>Clip ${index + 1}</strong> of ${length}</span>
          <progress max=${length} .value=${index} aria-label="Clips answered"></progress></div>
        ${savedMark(this.#line, answered)}
      </header>
      ${lineNote(this.#line)}
      <main class="trial-body" id="content" tabindex="-1">
        <section class="stage" aria-label="The clip">${this.#stage()}</section>
        <form class="panel" @submit=${(event: Event) => { event.preventDefault(); this.#next(); }}>
          <div class="panel-scroll">
            <h1>${session.study.question}</h1>
            <p class="trial-hint">${session.study.hint}</p>
            ${scales(session.study, this.form, (scale, value) => this.#change(choose(this.form, scale, value)))}
            ${comment(session.study, this.form, (form) => this.#change(form))}
          </div>
          ${footer(this.#course, this, () => this.#back())}
        </form>
      </main>`;
  }

  #stage(): TemplateResult {
    return html`${this.clip
        ? html`<motion-viewer theme="light" controls="simple" autoplay loop="auto"
            class=${this.fetched ? "" : "away"} src=${this.clip} figure=${this.figure || nothing}
            @ready=${() => this.#begin()} @unsupported=${() => this.#cannotDraw()}></motion-viewer>`
        : nothing}
      ${this.fetched
        ? nothing
        : clipOnItsWay(this.#preloader.share(this.#course.index), this.slow, () => location.reload())}`;
  }

  #cannotDraw(): void {
    this.phase = {
      name: "stuck",
      title: "This browser cannot draw the clips",
      text: "What you have answered is kept. Open this page’s address in another browser or on another device, and go on there.",
      help: "/no-webgl",
    };
  }
}

function incomplete(): never {
  throw new ApiError("offline", "The page did not load completely.", null, "Check the connection, then try again.", 0);
}
