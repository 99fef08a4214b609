// Many clips at once: choose clips and presets, see what they come to, make them.

import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, state } from "lit/decorators.js";
import { api, ApiError } from "../api";
import type { components } from "../api-types";
import { icon } from "../icons";
import { chooser } from "./chooser";
import { jobPanel } from "./job_panel";
import { JobWatch } from "./job_watch";
import { choiceOf, clipCount, isOpen, keyOf, NOTHING, requested, toggled, type Choice, type Clip, type Job, type Planned, type Preset } from "./model";
import { plannedList } from "./planned_list";

type Schemas = components["schemas"];

@customElement("set-maker")
export class SetMaker extends LitElement {
  @state() private clips: Clip[] | undefined;
  @state() private presets: Preset[] = [];
  @state() private choice: Choice = NOTHING;
  /** What the server makes of the choice, before single clips are left out. */
  @state() private plan: readonly Planned[] = [];
  @state() private query = "";
  @state() private problem: ApiError | undefined;
  @state() private sending = false;
  private planning: AbortController | undefined;
  private readonly watch = new JobWatch(this, () => void this.attempt(() => this.loadClips()));

  protected override createRenderRoot(): HTMLElement {
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    void this.load();
  }

  private load(): Promise<void> {
    return this.attempt(async () => {
      const [{ presets }, { jobs }, { clips }] = await Promise.all([
        api.get<Schemas["PresetList"]>("/api/v1/presets"),
        api.get<Schemas["JobList"]>("/api/v1/jobs"),
        api.get<Schemas["ClipList"]>("/api/v1/clips"),
      ]);
      const shown = location.hash.slice(1) || jobs.find((job) => job.kind === "clips" && isOpen(job))?.id;
      if (shown) await this.watch.ask(shown);
      this.presets = presets;
      this.clips = clips;
    });
  }

  private async loadClips(): Promise<void> {
    this.clips = (await api.get<Schemas["ClipList"]>("/api/v1/clips")).clips;
  }

  private choose(choice: Choice): void {
    const same = choice.sources === this.choice.sources && choice.presets === this.choice.presets;
    this.choice = choice;
    if (!same) void this.ask(choice);
  }

  /** Ask what the choice comes to; the newest choice counts. */
  private ask(choice: Choice): Promise<void> {
    this.planning?.abort();
    const { signal } = (this.planning = new AbortController());
    if (!choice.sources.size || !choice.presets.size) {
      this.plan = [];
      return Promise.resolve();
    }
    const body = { sources: [...choice.sources], presets: [...choice.presets] };
    return this.attempt(async () => {
      this.plan = (await api.post<Schemas["Plan"]>("/api/v1/clips/batch/plan", body, { signal })).items;
    });
  }

  private chooseFoerger(): Promise<void> {
    return this.attempt(async () => {
      const { items } = await api.get<Schemas["Plan"]>("/api/v1/sets/foerger");
      this.planning?.abort();
      this.choice = choiceOf(items);
      this.plan = items;
    });
  }

  private get items(): Planned[] {
    return this.plan.filter((item) => !this.choice.leftOut.has(keyOf(item)));
  }

  private async make(): Promise<void> {
    this.sending = true;
    await this.attempt(async () => {
      const items = requested(this.choice, this.items);
      this.show(await api.post<Job>("/api/v1/clips/batch", { items }));
    });
    this.sending = false;
  }

  private show(job: Job): void {
    history.replaceState(null, "", `#${job.id}`);
    this.watch.follow(job);
  }

  private again(): void {
    history.replaceState(null, "", location.pathname);
    this.watch.forget();
    void this.ask(this.choice);
  }

  private async attempt(act: () => Promise<void>): Promise<void> {
    try {
      this.problem = undefined;
      await act();
    } catch (error) {
      if (error instanceof DOMException && error.name === "AbortError") return;
      if (!(error instanceof ApiError)) throw error;
      this.problem = error;
    }
  }

  /** When the page turns from choosing to making or back, the focus goes along. */
  protected override updated(): void {
    if (!this.clips) return;
    const { job } = this.watch;
    const stage = job ? (isOpen(job) ? "running" : "ended") : "choosing";
    if (this.dataset.stage && this.dataset.stage !== stage) {
      this.querySelector<HTMLElement>(job ? "#job-title" : "h1")?.focus();
    }
    this.dataset.stage = stage;
  }

  protected override render(): TemplateResult {
    const { job } = this.watch;
    const problem = this.problem ?? (job ? undefined : this.watch.problem);
    return html`<header class="page-header"><h1 tabindex="-1">Sets</h1>
        ${job || !this.clips?.length ? nothing : html`<div class="buttons"><button class="button" type="button" @click=${() => void this.chooseFoerger()}>${icon("sets")}Förger’s 20 modified clips</button></div>`}</header>
      ${problem ? problemNote(problem, this.clips ? undefined : () => void this.load()) : nothing}
      ${job ? this.job(job) : this.clips ? this.choosing(this.clips) : this.problem ? nothing : html`<p class="quiet" role="status">The motions are on their way.</p>`}`;
  }

  private job(job: Job): TemplateResult {
    return jobPanel(job, {
      watch: this.watch,
      made: new Map(this.clips?.map((clip) => [clip.id, clip])),
      stop: () => void this.watch.stop(),
      again: () => this.again(),
    });
  }

  private choosing(clips: Clip[]): TemplateResult {
    if (!clips.length) return noClips();
    return html`<p class="lede">Make many clips in one go: every clip that you choose by every preset.</p>
      <div class="set-columns">
      ${chooser({
        clips,
        presets: this.presets,
        choice: this.choice,
        query: this.query,
        search: (query) => (this.query = query),
        toggle: (what, id) => this.choose(toggled(this.choice, what, id)),
        takeAll: (ids, on) => this.choose(this.withAll(ids, on)),
        callSet: (set) => this.choose({ ...this.choice, set }),
      })}
      <section class="set-plan" aria-labelledby="plan-title">${this.planned()}</section></div>`;
  }

  private planned(): TemplateResult {
    const { items, choice } = this;
    const leftOut = this.plan.length - items.length;
    if (!this.plan.length) {
      return html`<h2 class="figure-title" id="plan-title">Nothing chosen yet</h2>
        <p class="quiet">Choose clips and presets, and what they come to stands here.</p>`;
    }
    return html`<header class="page-header"><h2 class="figure-title" id="plan-title">${clipCount(items.length)}</h2>
        <div class="buttons"><button class="button primary" type="button" ?disabled=${!items.length || this.sending} @click=${() => void this.make()}>
          ${icon("plus")}Make ${items.length === 1 ? "it" : "them"}</button></div></header>
      ${plannedList({
        choice,
        items,
        leftOut,
        rename: (key, name) => this.choose({ ...choice, names: new Map(choice.names).set(key, name) }),
        leaveOut: (key) => this.choose({ ...choice, leftOut: new Set(choice.leftOut).add(key) }),
        putBack: () => this.choose({ ...choice, leftOut: new Set() }),
      })}`;
  }

  private withAll(ids: string[], on: boolean): Choice {
    const sources = new Set(this.choice.sources);
    for (const id of ids) on ? sources.add(id) : sources.delete(id);
    return { ...this.choice, sources };
  }
}

const noClips = () => html`<div class="empty"><h2 class="figure-title">No motions yet</h2>
  <p>A set is made from clips of the library. Import some first.</p>
  <div class="buttons"><a class="button primary" href="/library">Motion library</a></div></div>`;

const problemNote = ({ message, mend }: ApiError, again?: () => void) => html`<div class="note note-bad" role="alert">${icon("warning")}
  <div><p><b>${message}</b></p>${mend ? html`<p>${mend}</p>` : nothing}
  ${again ? html`<p><button class="link-button" type="button" @click=${again}>Try again</button></p>` : nothing}</div></div>`;
