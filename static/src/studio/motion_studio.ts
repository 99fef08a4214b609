// <motion-studio>: edits how a motion feels. Left how it moves, right what came of it, below when.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { ApiError } from "../api";
import type { MotionViewer } from "../viewer";
import { easedWords } from "./checks";
import { CompareKey } from "./compare_key";
import { dropDraft } from "./draft";
import { movementPanel, type NamedPose, type Offers } from "./movement_panel";
import type { ClipPicker } from "./picker";
import { RETARGET, type Steps } from "./recipe";
import { resultPanel, type ResultActs } from "./result_panel";
import * as server from "./server";
import { asApiError, Session } from "./session";
import { stage, type StageState } from "./stage_view";
import { topBar, type Drawer, type TopActs } from "./top_bar";
import "./picker";
import "./time_strip";

const EDITED = 0;
const ORIGINAL = 1;
const NO_CONTACTS = { left: [], right: [] };

@customElement("motion-studio")
export class MotionStudio extends LitElement {
  @property({ attribute: "clip" }) wanted = "";
  @state() private session: Session | null = null;
  @state() private offers: Omit<Offers, "clips"> = { presets: [], operations: [], poses: [] };
  @state() private clips: server.Clip[] = [];
  @state() private failure: ApiError | null = null;
  @state() private original = false;
  @state() private arrangement: StageState["arrangement"] = "ghost";
  @state() private drawer: Drawer | null = null;
  @state() private busy = false;
  @state() private said = "";
  @state() private eased: { steps: Steps; words: string } | null = null;
  @query("motion-viewer") private viewer!: MotionViewer | null;
  @query("clip-picker") private picker!: ClipPicker;
  /** The viewer of the clip on the stage, once it is ready. */
  @state() private stageViewer: MotionViewer | null = null;
  private shownAt = 0;
  private readonly compareKey = new CompareKey(() => this.original, (original) => this.compare(original));
  private readonly online = () => {
    if (this.failure?.transient) this.failure = null;
    this.session?.retry();
  };
  private readonly keyDown = (event: KeyboardEvent) => this.onKey(event);
  private readonly keyUp = (event: KeyboardEvent) => event.key.toLowerCase() === "c" && this.compareKey.up(event);

  protected override createRenderRoot(): HTMLElement {
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener("online", this.online);
    addEventListener("keydown", this.keyDown);
    addEventListener("keyup", this.keyUp);
    void this.attempt(() => this.begin());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("online", this.online);
    removeEventListener("keydown", this.keyDown);
    removeEventListener("keyup", this.keyUp);
  }

  private async begin(): Promise<void> {
    await this.updateComplete;
    await Promise.all([this.wanted ? this.open(this.wanted) : this.picker.show(), this.stock()]);
  }

  private async stock(): Promise<void> {
    const [presets, operations, poses, clips] = await Promise.all([
      server.presets(), server.operations(), server.poses(), server.clips(),
    ]);
    this.offers = { presets, operations, poses };
    this.clips = clips;
  }

  /** Open a clip: a source as it is, an edited one as the recipe that made it. On another body it is a source. */
  private async open(id: string): Promise<void> {
    const opened = await server.clipOf(id);
    if (opened.provenance?.recipe.some(({ operation }) => operation === RETARGET)) opened.provenance = null;
    const source = opened.provenance ? await server.clipOf(opened.provenance.source) : opened;
    const sameStage = this.session?.source.id === source.id;
    this.session = new Session(source, opened, (glb, at) => this.put(glb, at), () => this.requestUpdate());
    this.wanted = id;
    if (sameStage) this.session.begin(false);
    this.compare(false);
    this.said = "";
    history.replaceState(null, "", `?clip=${id}`);
    document.title = `${opened.name} · Studio · Manner`;
  }

  /** Give the edited figure another motion. */
  private put(glb: ArrayBuffer, askedAt: number): void {
    this.viewer?.setMotion(EDITED, glb);
    this.shownAt = askedAt;
    if (askedAt) performance.measure("manner:applied", { start: askedAt });
  }

  /** The motion of the last change is on the screen. */
  private onMotion(): void {
    if (this.shownAt) performance.measure("manner:change", { start: this.shownAt });
    this.shownAt = 0;
  }

  private onReady(): void {
    this.arrange();
    this.stageViewer = this.viewer;
    this.session?.begin(true);
  }

  private compare(original: boolean): void {
    this.original = original;
    this.arrange();
  }

  private arrange(): void {
    const { viewer, original, arrangement } = this;
    if (!viewer) return;
    viewer.setAttribute("arrange", original ? "one" : arrangement);
    viewer.setShown(EDITED, !original);
    viewer.setShown(ORIGINAL, original || arrangement !== "one");
  }

  private async attempt<T>(act: () => Promise<T>): Promise<T | undefined> {
    this.busy = true;
    try {
      this.failure = null;
      return await act();
    } catch (error) {
      this.failure = asApiError(error);
      return undefined;
    } finally {
      this.busy = false;
    }
  }

  private async save(): Promise<string | undefined> {
    const { session } = this;
    if (!session) return undefined;
    return this.attempt(async () => {
      session.names = this.variants.map(({ name }) => name);
      const id = await session.save();
      this.wanted = id;
      history.replaceState(null, "", `?clip=${id}`);
      this.clips = await server.clips();
      return id;
    });
  }

  private async download(suffix: string): Promise<void> {
    const id = await this.save();
    if (!id) return;
    const link = document.createElement("a");
    link.href = `/api/v1/clips/${id}.${suffix}`;
    link.download = "";
    link.click();
  }

  private async capture(): Promise<void> {
    const { viewer, session } = this;
    if (!viewer || !session) return;
    const id = await this.save();
    if (!id) return;
    await this.attempt(async () => {
      const share = viewer.duration > 0 ? viewer.currentTime / viewer.duration : 0;
      const frame = Math.round(share * ((session.checked?.frames ?? session.source.frames) - 1));
      await server.capture(id, frame, `${viewer.currentTime.toFixed(2)} s of ${session.source.name}`);
      this.offers = { ...this.offers, poses: await server.poses() };
    });
  }

  private forget({ id, name }: NamedPose): void {
    if (!confirm(`Delete the pose “${name}”?`)) return;
    void this.attempt(async () => {
      await server.forget(id);
      this.offers = { ...this.offers, poses: await server.poses() };
    });
  }

  private discard({ id, name, recipe_source }: server.Clip): void {
    if (!confirm(`Delete “${name}”? It goes from the library too.`)) return;
    void this.attempt(async () => {
      await server.remove(id);
      dropDraft(id);
      if (id === this.session?.saved.id) await this.open(recipe_source!);
      this.clips = await server.clips();
    });
  }

  private onKey(event: KeyboardEvent): void {
    const { session } = this;
    const typing = (event.composedPath()[0] as HTMLElement).matches?.("input:not([type=range]), textarea, select");
    if (!session || typing || this.querySelector("dialog[open]")) return;
    const key = event.key.toLowerCase();
    if (event.ctrlKey || event.metaKey) {
      if (key !== "z" && key !== "y") return;
      event.preventDefault();
      if (key === "y" || event.shiftKey) session.redo();
      else session.undo();
    } else if (key === "c" && !event.altKey) this.compareKey.down(event);
    else if (key === "g" && !event.altKey) this.toggleGhost();
    else if (key === "escape") this.closeDrawer();
  }

  private closeDrawer(): void {
    this.querySelector<HTMLElement>(".drawer-acts [aria-expanded=true]")?.focus();
    this.drawer = null;
  }

  private toggleGhost(): void {
    this.arrangement = this.arrangement === "ghost" ? "one" : "ghost";
    this.compare(false);
  }

  /** A pointer's gesture on any control is one entry of the history; when it happened is measured. */
  private note(event: Event): void {
    if (!this.session) return;
    this.session.askedAt = event.timeStamp;
    if (event.type === "pointerdown") {
      this.session.history.hold();
      addEventListener("pointerup", () => this.session?.history.release(), { once: true });
      addEventListener("pointercancel", () => this.session?.history.release(), { once: true });
    }
  }

  private get topActs(): TopActs {
    return {
      choose: () => this.picker.show(),
      undo: () => this.session?.undo(),
      redo: () => this.session?.redo(),
      compare: (original) => this.compare(original),
      exports: () => {
        this.drawer = "results";
        void this.updateComplete.then(() => this.querySelector<HTMLElement>("#export")?.focus());
      },
      save: () => void this.save(),
      drawer: (name) => (this.drawer = this.drawer === name ? null : name),
    };
  }

  private get resultActs(): ResultActs {
    return {
      seek: (finding) => this.seek(finding.start),
      easeOff: () => void this.attempt(async () => {
        const share = await this.session!.easeOff();
        this.eased = { steps: this.session!.steps, words: easedWords(share) };
      }),
      open: (id) => void this.attempt(() => this.open(id)),
      remove: (clip) => this.discard(clip),
      saved: async () => [await this.save()].filter((id) => id !== undefined),
      download: (suffix) => void this.download(suffix),
      copied: (words) => (this.said = words),
    };
  }

  /** Said as long as the eased recipe stands. */
  private get easedWords(): string {
    return this.eased && this.eased.steps === this.session?.steps ? this.eased.words : "";
  }

  private seek(time: number): void {
    this.viewer?.pause();
    this.viewer?.seek(time);
  }

  /** What was made from the clip on the stage. */
  private get variants(): server.Clip[] {
    return this.clips.filter(({ recipe_source }) => recipe_source && recipe_source === this.session?.source.id);
  }

  private strip(session: Session): TemplateResult {
    const { checked } = session;
    return html`<section class="studio-strip" aria-label="When"><time-strip .viewer=${this.stageViewer}
      .contacts=${checked?.contacts ?? NO_CONTACTS} .findings=${checked?.report.findings ?? null}></time-strip></section>`;
  }

  protected override render(): TemplateResult {
    const { session, drawer, original, busy, arrangement, failure } = this;
    const note = (event: Event) => this.note(event);
    return html`${topBar(session, { original, busy, drawer }, this.topActs)}
      <div class="studio ${drawer ? `with-${drawer}` : ""}">
        <aside class="side movement" aria-label="How it moves" @pointerdown=${{ handleEvent: note, capture: true }}
          @pointermove=${{ handleEvent: note, capture: true }} @keydown=${{ handleEvent: note, capture: true }}
          @input=${{ handleEvent: note, capture: true }}>
          ${session ? movementPanel(session, { ...this.offers, clips: this.clips }, { capture: () => void this.capture(), forget: (pose) => this.forget(pose) }) : nothing}</aside>
        ${stage(session, { original, arrangement, failure }, {
          ready: () => this.onReady(),
          motion: () => this.onMotion(),
          choose: () => this.picker.show(),
          again: () => void this.attempt(() => this.begin()),
          dismiss: () => (this.failure = null),
          arrange: (arrangement) => {
            this.arrangement = arrangement;
            this.compare(false);
          },
        })}
        ${session ? this.strip(session) : nothing}
        <aside class="side results" aria-label="What came of it">
          ${session ? resultPanel(session, { variants: this.variants, said: this.said, eased: this.easedWords, busy: this.busy }, this.resultActs) : nothing}</aside>
      </div>
      <clip-picker .clips=${this.clips} @pick=${({ detail }: CustomEvent<string>) => void this.attempt(() => this.open(detail))}></clip-picker>`;
  }
}
