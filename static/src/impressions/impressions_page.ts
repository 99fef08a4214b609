// <impressions-page>: from answers in adjectives to clusters, live under the thresholds and the cut.
import { html, LitElement, nothing, svg, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api, ApiError } from "../api";
import { problemNote } from "../graph/problem";
import { icon } from "../icons";
import { dataOf } from "../results/chart";
import { debounced, Latest } from "../studio/latest";
import type { Ask } from "./events";
import { limitsOf, remembered, sameLimits, together, type Choices, type Decided, type Impressions, type Limits } from "./model";
import { attempt } from "./problem";
import "./cluster_list";
import "./comparison";
import "./impression_map";
import "./pair_table";
import "./space_maker";
import "./stability";

const SETTLED = 700; // ms without a change, after which choices are saved
/** Bars still without answers: where each begins, and how long it is. */
const BLANK = [[6, 140], [30, 110], [46, 126], [84, 92]] as const;

@customElement("impressions-page")
export class ImpressionsPage extends LitElement {
  @property() study = "";
  @state() private data: Impressions | null = null;
  /** What the sliders and the cut say; the data follow. */
  @state() private limits: Limits | null = null;
  @state() private problem: ApiError | null = null;
  /** Why a save was refused. It stays until a later one by hand goes well. */
  @state() private refused: ApiError | null = null;
  @state() private saving: "saved" | "waiting" | "saving" | null = null;
  private decided: Decided = { names: {}, moved: {} };
  private readonly wanted = new URLSearchParams(location.search);
  private readonly previews = new Latest<Limits>((limits) => this.preview(limits));
  private readonly saveSoon = debounced<void>(() => void this.save(), SETTLED);
  /** The end of the last change on its way: each begins with what the one before has left. */
  private saved: Promise<void> = Promise.resolve();
  /** When those choices were saved that this page last saw; others are not written over. */
  private savedAt: string | null = null;

  protected override createRenderRoot(): HTMLElement {
    const inPage = dataOf<Impressions>("impressions");
    if (inPage) this.take(inPage);
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener("pagehide", this.leave);
    if (!this.data) void this.load();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("pagehide", this.leave);
  }

  private get address(): string {
    return `/api/v1/studies/${this.study}/impressions`;
  }

  private get query(): Record<string, string | null> {
    return { part: this.wanted.get("part"), kind: this.wanted.get("kind") };
  }

  private attempt(act: () => Promise<void>): Promise<void> {
    return attempt(act, (problem) => (this.problem = problem));
  }

  private load(): Promise<void> {
    return this.attempt(async () => this.take(await api.get<Impressions>(this.address, { query: this.query })));
  }

  private take(data: Impressions): void {
    this.show(data);
    this.limits = limitsOf(data.choices);
  }

  private show(data: Impressions): void {
    this.data = data;
    this.savedAt ??= data.saved_at;
    this.decided = remembered(this.decided, data.choices);
  }

  /** What the thresholds would give. A late answer never takes the place of a newer wish. */
  private preview(limits: Limits): Promise<void> {
    return this.attempt(async () => {
      this.show(await api.get<Impressions>(this.address, { query: { ...this.query, ...limits } }));
    });
  }

  private readonly changed = ({ detail }: Ask<"limits">): void => {
    if (!this.limits) return;
    this.limits = { ...this.limits, ...detail };
    this.previews.ask(this.limits);
    if (!this.data?.may_edit) return;
    this.saving = "waiting";
    this.saveSoon();
  };

  private readonly renamed = ({ detail: { key, title } }: Ask<"rename">): void => {
    void this.decide(({ names, moved }) => {
      const { [key]: _, ...others } = names;
      return { names: title ? { ...others, [key]: title } : others, moved };
    });
  };

  private readonly moved = ({ detail: { pair, to } }: Ask<"move">): void => {
    void this.decide(({ names, moved }) => {
      const { [pair]: _, ...others } = moved;
      return { names, moved: to ? { ...others, [pair]: to } : others };
    });
  };

  private decide(change: (now: Decided) => Decided): Promise<void> {
    this.refused = null;
    return this.save(change);
  }

  /** Saves thresholds and cut as they are, and whatever else is changed. */
  private save(change: (now: Decided) => Decided = (now) => now): Promise<void> {
    this.saved = this.saved.catch(() => {}).then(() => this.put(change));
    return this.saved;
  }

  private async put(change: (now: Decided) => Decided): Promise<void> {
    const { data, limits } = this;
    if (!data?.may_edit || !limits) return;
    this.saving = "saving";
    const decided = change(this.decided);
    let went = false;
    await attempt(async () => {
      const saved = await this.send(data, { ...limits, ...decided });
      this.savedAt = saved.saved_at;
      this.decided = decided;
      if (this.isAt(limits)) this.show(saved);
      went = true;
    }, (problem) => (this.refused = problem ?? this.refused));
    this.saving = !went ? null : this.isAt(limits) ? "saved" : "waiting";
  }

  /** The request outlives the page: somebody may name a cluster and go. */
  private send({ part, kind }: Impressions, choices: Choices): Promise<Impressions> {
    const query = { kind, ...(this.savedAt ? { seen: this.savedAt } : {}) };
    return api.put<Impressions>(`${this.address}/${part.id}`, choices, { query, keepalive: true });
  }

  private isAt(limits: Limits): boolean {
    return this.limits !== null && sameLimits(this.limits, limits);
  }

  /** Whoever leaves before the change has settled keeps it all the same. */
  private readonly leave = (): void => {
    const { data, limits } = this;
    if (this.saving !== "waiting" || !data || !limits) return;
    void this.send(data, { ...limits, ...this.decided }).catch(() => {}); // nobody is there to be told
  };

  private readonly settle = (): Promise<void> => (this.saving === "waiting" ? this.save() : this.saved);

  protected override render(): TemplateResult {
    const { data, limits } = this;
    const problem = this.problem ?? this.refused;
    return html`${problem ? html`<div class="page-problem">${problemNote(problem, data ? undefined : () => void this.load())}</div>` : nothing}
      ${data && limits ? this.page(data, limits) : this.problem ? nothing : html`<p class="quiet loading" role="status">The answers are being counted.</p>`}`;
  }

  private page(data: Impressions, limits: Limits): TemplateResult {
    return html`${this.whose(data)}${this.parts(data)}
      ${data.problem && !hasAnswers(data) ? this.empty(data) : html`<p class="sentence first-sentence">${together(data.sentence)}</p>
        <p class="small quiet standing">${this.standing(data)}</p>
        ${data.notes.length ? html`<div class="note notes">${icon("info")}<div>${data.notes.map((note) => html`<p>${note}</p>`)}</div></div>` : nothing}
        <div @limits=${this.changed} @rename=${this.renamed} @move=${this.moved}>
          <section class="section" aria-labelledby="pairs"><header><h2 class="figure-title" id="pairs">Which pairs say something</h2>
            <p>A pair is left out where no clip stands out in it (μ* too low), or where people see the same clip differently (σ̄, the mean sample standard deviation, too high). Move the thresholds: the rest follows.</p>
            <p>Both are in steps of the answers, from −${data.reach} to ${data.reach}: μ* is 0 where all clips seem neutral and ${data.reach} at most; σ̄ is 0 where everybody agrees. After Oshita et al., section 3.4, equations 1 to 3.</p></header>
            <pair-table .data=${data} .limits=${limits}></pair-table></section>
          ${data.problem ? html`<p class="note section" role="status">${icon("info")}<span>${data.problem}</span></p>` : this.solution(data, limits)}
        </div>`}`;
  }

  private solution(data: Impressions, limits: Limits): TemplateResult {
    return html`<section class="section" aria-labelledby="together"><impression-map .data=${data} .limits=${limits}></impression-map></section>
      <section class="section" aria-labelledby="clusters"><cluster-list .data=${data}></cluster-list></section>
      <section class="section" aria-labelledby="compared"><solution-comparison .data=${data} .settle=${this.settle}></solution-comparison></section>
      <section class="section" aria-labelledby="stable"><solution-stability .data=${data}></solution-stability></section>
      <section class="section" aria-labelledby="space"><space-maker .data=${data} .settle=${this.settle}></space-maker></section>`;
  }

  private standing({ may_edit }: Impressions): TemplateResult | string {
    const words = { saved: "Saved.", waiting: "Not saved yet.", saving: "Saving…" };
    return may_edit
      ? html`<span role="status" data-saving=${this.saving ?? "none"}>${this.saving ? words[this.saving] : "Changes are saved by themselves."}</span>`
      : "You may try other thresholds and cuts here; only an editor’s are saved.";
  }

  private to(part: string, kind: string): string {
    return `?part=${encodeURIComponent(part)}${kind === "simulated" ? "&kind=simulated" : ""}`;
  }

  private whose({ kind, simulated, part }: Impressions): TemplateResult | typeof nothing {
    if (kind === "simulated") {
      return html`<div class="note simulated" role="note">${icon("info")}<p><b>Simulated participants.</b> Nobody gave these answers: they are made up, by rules stated beforehand. <a href=${this.to(part.id, "participant")}>Show people’s answers</a></p></div>`;
    }
    if (!simulated) return nothing;
    return html`<p class="small quiet switch">${simulated} simulated participants are kept apart. <a href=${this.to(part.id, "simulated")}>Show their answers</a></p>`;
  }

  private parts({ parts, part, kind }: Impressions): TemplateResult | typeof nothing {
    if (parts.length < 2) return nothing;
    return html`<nav class="chips part-switch" aria-label="Part of the study">${parts.map(({ id }) => html`<a class="chip" href=${this.to(id, kind)}
      aria-current=${id === part.id ? "true" : nothing}>${id.replaceAll("_", " ")}</a>`)}</nav>`;
  }

  private empty({ problem }: Impressions): TemplateResult {
    return html`<section class="empty"><svg class="disc" viewBox="0 0 220 80" aria-hidden="true">
      ${BLANK.map(([x, width], row) => svg`<rect class="bar" x=${x} y=${4 + row * 20} width=${width} height="10" rx="2"/>`)}</svg>
      <h2 class="figure-title">Not enough answers yet</h2><p>${problem}</p>
      <div class="buttons"><a class="button" href="/research/studies/${this.study}">Back to the results</a></div></section>`;
  }
}

/** Whether there is anything that thresholds could choose from. */
const hasAnswers = ({ participants, pairs }: Impressions): boolean => participants > 1 && pairs.some(({ peak }) => peak !== null);
