// <graph-page>: a motion graph to walk through, look at and change.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { api, ApiError } from "../api";
import { icon } from "../icons";
import { Latest } from "../studio/latest";
import { amountSlider } from "../studio/slider";
import type { MotionViewer } from "../viewer";
import { graphMap } from "./graph_map";
import {
  arrowsOf, clipWords, directionsOf, keyOf, neutral, sameKey, startOf, seconds,
  type Direction, type GraphDetail, type GraphTransitions, type Key, type Manner,
} from "./model";
import type { Queued } from "./pose_stream";
import { problemNote } from "./problem";
import { HeldKeys, pad } from "./steering";
import { transitionTable } from "./transition_table";
import { Walker } from "./walker";
import "../viewer";

const ROWS = 30;
/** The stances that come with the server, in the words of the sliders. */
const POSTURES: [name: string, label: string][] = [
  ["head_down", "Head down"],
  ["elbows_away", "Elbows away"],
  ["hands_and_feet_closer", "Hands and feet closer"],
  ["hands_away_and_feet_apart", "Hands and feet apart"],
];

type Limits = Pick<GraphDetail, "threshold" | "fade">;
type Draft = Limits & { found: GraphTransitions | null };
type Change = Partial<Pick<GraphDetail, "name" | "threshold" | "fade" | "removed" | "added">>;

@customElement("graph-page")
export class GraphPage extends LitElement {
  @property() graph = "";
  /** Shows the character; tests look at its time. */
  walker: Walker | null = null;
  @state() private detail: GraphDetail | undefined;
  @state() private problem: ApiError | null = null;
  @state() private trouble: ApiError | null = null;
  @state() private manner: Manner = neutral();
  @state() private pressed: Direction | null = "stop";
  @state() private held: Direction | null = null;
  @state() private shown: Queued | null = null;
  /** The transition that is to be looked at, until somebody steers again. */
  @state() private asked: Key | null = null;
  @state() private filter = { from: "", to: "" };
  @state() private most = ROWS;
  /** What threshold and fade would give while their sliders move. */
  @state() private draft: Draft | null = null;
  /** Changes on their way to the server, and the end of the last of them. */
  @state() private saving = 0;
  private saved: Promise<void> = Promise.resolve();
  private readonly previews = new Latest<Draft>((draft) => this.preview(draft));
  private readonly keys = new HeldKeys((direction) => this.hold(direction));

  protected override createRenderRoot(): HTMLElement {
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.keys.connect();
    void this.load();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.keys.disconnect();
    this.walker?.stop();
  }

  private get address(): string {
    return `/api/v1/graphs/${this.graph}`;
  }

  private get own(): boolean {
    return this.detail?.kind === "own";
  }

  private async load(): Promise<void> {
    await this.attempt(async () => {
      this.detail = await api.get<GraphDetail>(this.address);
      document.title = `${this.detail.name} · Graphs · Manner`;
    });
  }

  private async attempt(act: () => Promise<void>): Promise<void> {
    try {
      await act();
      this.problem = null;
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      this.problem = error;
    }
  }

  // Walking

  private readonly onReady = (): void => {
    const viewer = this.querySelector<MotionViewer>("motion-viewer");
    const start = this.detail && startOf(this.detail);
    if (!viewer || !start || this.walker) return;
    viewer.live = true;
    this.walker = new Walker(`${this.address}/play`, viewer, this.detail!.members[0]!.frame_time, start, {
      moved: (shown) => (this.shown = shown),
      failed: (error) => this.stumbled(error),
    });
    this.walker.change(this.manner);
    this.walker.start();
    if (this.asked) this.show(this.asked); // whoever was quicker than the figure is not forgotten
    else this.follow();
  };

  /** The place may have become a dead end, when the graph was changed: begin again. */
  private stumbled(error: ApiError | null): void {
    this.trouble = error;
    const start = this.detail && startOf(this.detail);
    if (error && !error.transient && start && this.walker) {
      this.walker.begin({ ...start, manner: this.manner });
      this.walker.steer(start.clip);
      this.pressed = null;
    }
  }

  private hold(direction: Direction | null): void {
    this.held = direction;
    if (direction === "stop") this.pressed = "stop";
    this.follow();
  }

  private press(direction: Direction): void {
    this.pressed = direction;
    this.follow();
  }

  private follow(): void {
    this.asked = null;
    const known = directionsOf(this.detail?.members.map(({ name }) => name) ?? []);
    const direction = this.held ?? this.pressed ?? "stop";
    const clip = known[direction] ?? known.stop ?? known.ahead;
    if (clip) this.walker?.steer(clip);
  }

  private goTo(name: string): void {
    this.asked = null;
    const known = directionsOf(this.detail?.members.map((member) => member.name) ?? []);
    const [direction] = Object.entries(known).find(([, clip]) => clip === name) ?? [];
    this.pressed = (direction as Direction | undefined) ?? null;
    this.walker?.steer(name);
  }

  private show(key: Key): void {
    this.goTo(key.target);
    this.asked = key;
    this.walker?.show(keyOf(key));
    this.querySelector(".graph-stage")?.scrollIntoView({ block: "nearest" });
  }

  private move(manner: Partial<Manner>): void {
    this.manner = { ...this.manner, ...manner };
    this.walker?.change(this.manner);
  }

  // Changing

  private request(change: Change): Omit<GraphDetail, "id" | "kind" | "members" | "fade_frames" | "transitions" | "dead_ends"> {
    const { name, clips, threshold, fade, removed, added } = this.detail!;
    return { name, clips, threshold, fade, removed, added, ...change };
  }

  private keep(limits: Partial<Limits>): void {
    void this.save(() => limits);
  }

  /** One change after the other: each begins with what the one before has left. */
  private save(changed: (now: GraphDetail) => Change): Promise<void> {
    this.saving += 1;
    this.saved = this.saved.catch(() => {}).then(() => this.attempt(async () => {
      this.detail = await api.put<GraphDetail>(this.address, this.request(changed(this.detail!)));
      this.draft = null;
    })).finally(() => (this.saving -= 1));
    return this.saved;
  }

  private tryOut(limits: Partial<Limits>): void {
    const { threshold, fade } = this.detail!;
    this.draft = { threshold, fade, ...this.draft, ...limits, found: null };
    this.previews.ask(this.draft);
  }

  private async preview(draft: Draft): Promise<void> {
    const { name: _, ...shape } = this.request({ threshold: draft.threshold, fade: draft.fade });
    await this.attempt(async () => {
      const found = await api.post<GraphTransitions>("/api/v1/graphs/preview", shape);
      if (this.draft === draft) this.draft = { ...draft, found };
    });
  }

  private async copy(): Promise<void> {
    await this.attempt(async () => {
      const made = await api.post<GraphDetail>("/api/v1/graphs", this.request({ name: `${this.detail!.name} (copy)` }));
      location.assign(`/graphs/${made.id}`);
    });
  }

  private async discard(): Promise<void> {
    if (!confirm(`Delete “${this.detail!.name}”? Its clips stay in the library.`)) return;
    await this.attempt(async () => {
      await api.delete(this.address);
      location.assign("/graphs");
    });
  }

  // Looks

  protected override render(): TemplateResult {
    const { detail } = this;
    return html`<p class="crumbs small"><a href="/graphs">Graphs</a> <span aria-hidden="true">/</span></p>
      ${detail ? this.header(detail) : html`<h1>Motion graph</h1>`}
      ${this.problem ? problemNote(this.problem, () => void this.load()) : nothing}
      ${detail ? this.body(detail) : this.problem ? nothing : html`<p class="quiet" role="status">The clips are being compared.</p>`}`;
  }

  private header(detail: GraphDetail): TemplateResult {
    const rename = (event: Event) => {
      const name = (event.target as HTMLInputElement).value.trim();
      if (name && name !== detail.name) void this.save(() => ({ name }));
    };
    return html`<header class="page-header">
      ${this.own
        ? html`<h1 class="visually-hidden">${detail.name}</h1><input class="input title graph-name" aria-label="Name" maxlength="200" .value=${detail.name} @change=${rename}>`
        : html`<h1>${detail.name}</h1>`}
      <div class="buttons">
        <button class="button" type="button" @click=${() => void this.copy()}>${icon("copy")}${this.own ? "Copy" : "Copy and change"}</button>
        ${this.own ? html`<button class="button danger" type="button" @click=${() => void this.discard()}>Delete</button>` : nothing}
      </div></header>`;
  }

  private body(detail: GraphDetail): TemplateResult {
    return html`<div class="graph-layout">
      <section class="graph-stage" aria-label="Character">${this.stage(detail)}</section>
      <aside class="graph-side">${this.controls()}${this.drawing(detail)}${this.limits(detail)}</aside>
      <section class="graph-transitions" aria-label="Transitions"><h2>Transitions</h2>
        ${transitionTable(
          { graph: detail, ...this.filter, most: this.most, chosen: this.asked ?? this.shown?.piece.taken ?? null },
          {
            filter: (from, to) => ((this.filter = { from, to }), (this.most = ROWS)),
            more: () => (this.most += 2 * ROWS),
            show: (transition) => this.show(transition),
            remove: (transition) => void this.leaveOut(transition),
            restore: (key) => void this.save(({ removed }) => ({ removed: removed.filter((one) => !sameKey(one, key)) })),
            add: (key) => void this.save(({ added }) => ({ added: [...added, key] })),
          },
        )}</section>
    </div>`;
  }

  /** One that was added by hand is simply gone; one that was found is remembered as left out. */
  private async leaveOut(transition: Key & { added: boolean }): Promise<void> {
    await this.save(({ removed, added }) => transition.added
      ? { added: added.filter((one) => !sameKey(one, transition)) }
      : { removed: [...removed, keyOf(transition)] });
  }

  private stage(detail: GraphDetail): TemplateResult {
    const [first] = detail.members;
    if (!startOf(detail)) {
      return html`<div class="empty"><h2 class="figure-title">Nothing can follow anything</h2>
        <p>No two moments of these clips are alike enough. ${this.own ? "Raise the threshold, or add a transition by hand." : ""}</p></div>`;
    }
    if (!first?.figure_url) {
      return html`<div class="empty"><h2 class="figure-title">No figure can stand on this skeleton</h2>
        <p>Which joint is hips, head, arm or leg was not found.</p></div>`;
    }
    const known = directionsOf(detail.members.map(({ name }) => name));
    return html`<motion-viewer src=${first.glb_url} figure=${first.figure_url} theme="auto" controls="views"
        aria-label="The steered character" @ready=${this.onReady}></motion-viewer>
      ${this.trouble ? html`<p class="note stage-note" role="status">${icon("info")}<span>${this.trouble.message}</span></p>` : nothing}
      <div class="steering"><p class="tiny steering-state">${this.whereabouts(detail)}</p>
        ${pad(known, this.held ?? this.pressed, (direction) => this.press(direction))}
        <p class="tiny steering-hint">Arrow keys or W A S D: held, they steer; a button stays pressed.</p></div>`;
  }

  private whereabouts({ members }: GraphDetail): TemplateResult | string {
    const { shown } = this;
    if (!shown) return "On the way to its place";
    const { after, taken, ahead, wait } = shown.piece;
    const now = taken ? `${clipWords(taken.source)} → ${clipWords(taken.target)}` : clipWords(after.clip);
    if (!ahead) return html`<b>${now}</b>`;
    return html`<b>${now}</b>, next ${clipWords(ahead.target)} in ${seconds(wait, members[0]!.frame_time)}`;
  }

  private controls(): TemplateResult {
    const { path, timing, postures } = this.manner;
    const amount = (label: string, value: number, range: [number, number, number], set: (value: number) => void) =>
      amountSlider({ label, value, min: range[0], max: range[1], neutral: range[2], step: 0.05 }, set);
    const changed = JSON.stringify(this.manner) !== JSON.stringify(neutral());
    return html`<section @pointerup=${leaveSlider}><header><h2>How it moves</h2>
        <button class="link-button" type="button" ?hidden=${!changed} @click=${() => this.move(neutral())}>Reset</button></header>
      ${amount("Path length", path, [0, 2, 1], (value) => this.move({ path: value }))}
      ${amount("Timing", timing, [0, 2, 1], (value) => this.move({ timing: value }))}
      ${POSTURES.map(([name, label]) =>
        amount(label, postures[name] ?? 0, [-1, 2, 0], (value) => this.move({ postures: { ...postures, [name]: value } })),
      )}</section>`;
  }

  private drawing({ members, transitions }: GraphDetail): TemplateResult {
    const piece = this.shown?.piece;
    return html`<section><header><h2>Graph</h2><span class="tiny">arrows carry their number of transitions</span></header>
      ${graphMap(
        {
          names: members.map(({ name }) => name),
          arrows: arrowsOf(this.draft?.found?.transitions ?? transitions),
          current: piece?.after.clip ?? null,
          next: piece?.taken ?? piece?.ahead ?? null,
          taking: Boolean(piece?.taken),
        },
        (name) => this.goTo(name),
      )}</section>`;
  }

  private limits(detail: GraphDetail): TemplateResult {
    const { threshold = 0.07, fade = 0.3 } = { ...detail, ...this.draft };
    const found = this.draft ? this.draft.found : detail;
    const slider = (label: string, value: number, unit: string, range: [number, number, number], name: "threshold" | "fade", scale: number) => html`<label class="limit">
      <span>${label}</span><input type="range" min=${range[0]} max=${range[1]} step=${range[2]} .value=${String(value)} ?disabled=${!this.own}
        aria-valuetext="${value} ${unit}" @input=${(event: Event) => this.tryOut({ [name]: numberOf(event) / scale })}
        @change=${(event: Event) => this.keep({ [name]: numberOf(event) / scale })}>
      <span class="number">${value} ${unit}</span></label>`;
    return html`<section @pointerup=${leaveSlider}><header><h2>Likeness</h2>
        <span class="tiny" role="status">${found ? `${found.transitions.length} transitions` : "counting"}${this.saving ? ", saving" : ""}</span></header>
      ${slider("Threshold", Math.round(threshold * 1000) / 10, "cm", [1, 30, 0.5], "threshold", 100)}
      ${slider("Cross-fade", Math.round(fade * 100) / 100, "s", [0.1, 1, 0.05], "fade", 1)}
      <p class="tiny">${this.own
        ? found?.dead_ends ? `${found.dead_ends} more lead nowhere and are left out.` : "Two moments may follow each other when their joints are no farther apart than this."
        : "This graph comes with the server. Copy it to change its transitions."}</p></section>`;
  }
}

const numberOf = (event: Event): number => Number((event.target as HTMLInputElement).value);

/** After a slider was moved by pointer, arrows steer again. */
function leaveSlider(event: Event): void {
  if (event.target instanceof HTMLInputElement) event.target.blur();
}
