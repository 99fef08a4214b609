// <motion-studio>: edits how a motion feels. Left how it moves, right what came of it, below when.
import { html, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { easedWords } from "./checks";
import { CompareKey } from "./compare_key";
import { dropDraft } from "./draft";
import { mixOf, type Mix } from "./mix";
import { movementPanel, type NamedPose, type Offers } from "./movement_panel";
import type { ClipPicker } from "./picker";
import type { Steps } from "./recipe";
import { resultPanel, type ResultActs } from "./result_panel";
import * as server from "./server";
import { Session } from "./session";
import { stage, type StageState } from "./stage_view";
import { topBar, type TopActs } from "./top_bar";
import { Workbench } from "./workbench";
import "./picker";
import "./time_strip";

const EDITED = 0;
const ORIGINAL = 1;
const NO_CONTACTS = { left: [], right: [] };

@customElement("motion-studio")
export class MotionStudio extends Workbench<Session> {
  @property({ attribute: "clip" }) wanted = "";
  @state() private offers: Omit<Offers, "clips"> = { presets: [], operations: [], poses: [] };
  @state() private clips: server.Clip[] = [];
  @state() private original = false;
  @state() private arrangement: StageState["arrangement"] = "ghost";
  @state() private eased: { steps: Steps; words: string } | null = null;
  @query("clip-picker") private picker!: ClipPicker;
  private mix: Mix | null = null;
  private readonly compareKey = new CompareKey(() => this.original, (original) => this.compare(original));
  private readonly keyUp = (event: KeyboardEvent) => event.key.toLowerCase() === "c" && this.compareKey.up(event);

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener("keyup", this.keyUp);
    void this.attempt(() => this.begin());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
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

  /** Open a clip: one to begin from as it is, an edited one as the recipe that made it. */
  private async open(id: string): Promise<void> {
    const found = await server.clipOf(id);
    const opened = found.variant_of ? found : { ...found, provenance: null };
    const source = found.variant_of ? await server.clipOf(found.variant_of) : found;
    const space = this.session ? this.mix?.space?.id : new URLSearchParams(location.search).get("space");
    this.mix = await mixOf(source, space ?? null);
    const sameStage = this.session?.source.id === source.id;
    this.session = new Session(source, opened, (glb, at) => this.put(glb, at), () => this.requestUpdate());
    this.wanted = id;
    if (sameStage) this.session.begin(false);
    this.compare(false);
    this.said = "";
    this.standAt(id);
    document.title = `${opened.name} · Studio · Manner`;
  }

  /** The page's address; that of a mix goes on leading back to its space. */
  private standAt(clip: string): void {
    const space = this.mix?.space;
    history.replaceState(null, "", `?clip=${clip}${space ? `&space=${space.id}` : ""}`);
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

  private async save(): Promise<string | undefined> {
    const { session } = this;
    if (!session) return undefined;
    return this.attempt(async () => {
      session.names = this.variants.map(({ name }) => name);
      const id = await session.save();
      this.wanted = id;
      this.standAt(id);
      this.clips = await server.clips();
      return id;
    });
  }

  private async download(suffix: string): Promise<void> {
    const id = await this.save();
    if (id) this.take(id, suffix);
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

  private discard({ id, name, variant_of }: server.Clip): void {
    if (!confirm(`Delete “${name}”? It goes from the library too.`)) return;
    void this.attempt(async () => {
      await server.remove(id);
      dropDraft(id);
      if (id === this.session?.saved.id) await this.open(variant_of!);
      this.clips = await server.clips();
    });
  }

  protected override reconnected(): void {
    this.failure = null;
  }

  protected override press(key: string, event: KeyboardEvent): void {
    if (key === "c" && !event.altKey) this.compareKey.down(event);
    else if (key === "g" && !event.altKey) this.toggleGhost();
    else if (key === "escape") this.closeDrawer();
  }

  private toggleGhost(): void {
    this.arrangement = this.arrangement === "ghost" ? "one" : "ghost";
    this.compare(false);
  }

  private get topActs(): TopActs {
    return {
      choose: () => this.picker.show(),
      undo: () => this.session?.undo(),
      redo: () => this.session?.redo(),
      compare: (original) => this.compare(original),
      exports: () => this.showExports(),
      save: () => void this.save(),
      drawer: (name) => this.toggle(name),
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
    return this.clips.filter(({ variant_of }) => variant_of && variant_of === this.session?.source.id);
  }

  private strip(session: Session): TemplateResult {
    const { checked } = session;
    return html`<section class="studio-strip" aria-label="When"><time-strip .viewer=${this.stageViewer}
      .contacts=${checked?.contacts ?? NO_CONTACTS} .findings=${checked?.report.findings ?? null}></time-strip></section>`;
  }

  protected override render(): TemplateResult {
    const { session, drawer, original, busy, arrangement, failure, noted } = this;
    return html`${topBar(session, { original, busy, drawer, mix: this.mix }, this.topActs)}
      <div class="studio ${drawer ? `with-${drawer}` : ""}">
        <aside class="side movement" aria-label="How it moves" @pointerdown=${noted} @pointermove=${noted} @keydown=${noted} @input=${noted}>
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
