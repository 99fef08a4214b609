// <motion-space>: authors a motion by how it feels. Left the sliders, right the mix of examples, below when.
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { ApiError } from "../api";
import type { ExportActs, Suffix } from "../studio/export_panel";
import type { ClipPicker } from "../studio/picker";
import * as studio from "../studio/server";
import { asApiError } from "../studio/session";
import type { MotionViewer } from "../viewer";
import { language } from "../words";
import { feelPanel, type FeelActs } from "./feel_panel";
import type { JoinDialog } from "./join_dialog";
import { keytimePanel, type KeytimeActs } from "./keytime_panel";
import { mixedContacts } from "./keytimes";
import { mapPanel, type Axes } from "./map_panel";
import {
  added, carried, clustersOf, middle, mixed, moved, placeOfExample, removed, slidersOf, swapped, switched, weighed, type Kind, type Place,
} from "./model";
import type { Chosen, PairChooser } from "./pair_chooser";
import * as server from "./server";
import { SpaceSession } from "./session";
import { stage } from "./stage";
import { spaceBar, type Drawer } from "./space_bar";
import { weightsPanel, type WeightActs } from "./weights_panel";
import { languagesOf } from "./words";
import "../studio/picker";
import "../studio/time_strip";
import "./join_dialog";
import "./pair_chooser";

const FIGURE = 0;
/** Here a drawer hides the time strip. */
const PHONE = "(max-width: 699px)";

@customElement("motion-space")
export class MotionSpace extends LitElement {
  @property({ attribute: "space" }) wanted = "";
  @state() private session: SpaceSession | null = null;
  @state() private failure: ApiError | null = null;
  @state() private drawer: Drawer | null = null;
  @state() private busy = false;
  @state() private said = "";
  /** What was made of the space, in words. */
  @state() private told = "";
  @state() private language = language();
  @state() private axes: Axes | null = null;
  @state() private clips: studio.Clip[] = [];
  @state() private stageViewer: MotionViewer | null = null;
  @query("motion-viewer") private viewer!: MotionViewer | null;
  @query("pair-chooser") private chooser!: PairChooser;
  @query("clip-picker") private picker!: ClipPicker;
  @query("join-dialog") private joining!: JoinDialog;
  private shownAt = 0;
  /** The weights as a drag found them: at 100 % the others' proportions would be lost for the way back. */
  private gripped: Place | null = null;
  private readonly online = () => {
    if (this.failure?.transient) void this.begin();
    this.session?.retry();
  };
  private readonly keyDown = (event: KeyboardEvent) => this.onKey(event);

  protected override createRenderRoot(): HTMLElement {
    this.replaceChildren();
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener("online", this.online);
    addEventListener("keydown", this.keyDown);
    void this.begin();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("online", this.online);
    removeEventListener("keydown", this.keyDown);
  }

  private begin(): Promise<void> {
    return this.attempt(async () => this.open(await server.space(this.wanted)));
  }

  private open(space: server.Space, from?: Place): void {
    this.wanted = space.id;
    this.session = new SpaceSession(space, (glb, at) => this.put(glb, at), () => this.requestUpdate(), from);
    const spoken = this.languages;
    if (spoken.length && !spoken.includes(this.language)) this.language = spoken[0]!;
    history.replaceState(null, "", `/studio/spaces/${space.id}`);
    document.title = `${space.name} · Spaces · Manner`;
  }

  private get languages(): string[] {
    const { adjectives, features } = this.session!.space.definition;
    return languagesOf(adjectives, features);
  }

  private put(glb: ArrayBuffer, askedAt: number): void {
    this.viewer?.setMotion(FIGURE, glb);
    this.shownAt = askedAt;
    if (askedAt) performance.measure("manner:applied", { start: askedAt });
  }

  /** The motion of the last change is on the screen. */
  private onMotion(): void {
    if (this.shownAt) performance.measure("manner:change", { start: this.shownAt });
    this.shownAt = 0;
  }

  private onReady(): void {
    this.stageViewer = this.viewer;
    this.session?.begin();
  }

  private async attempt(act: () => Promise<void> | void): Promise<void> {
    this.busy = true;
    try {
      this.failure = null;
      await act();
    } catch (error) {
      this.failure = asApiError(error);
    } finally {
      this.busy = false;
    }
  }

  private move(change: (place: Place) => Place, control: string): void {
    const { session } = this;
    session?.move(change(session.place), control);
  }

  private save(): Promise<void> {
    return this.attempt(async () => void (await this.session!.save()));
  }

  private download(suffix: Suffix): Promise<void> {
    return this.attempt(async () => {
      const id = await this.session!.save();
      const link = document.createElement("a");
      link.href = `/api/v1/clips/${id}.${suffix}`;
      link.download = "";
      link.click();
    });
  }

  private onKey(event: KeyboardEvent): void {
    const typing = (event.composedPath()[0] as HTMLElement).matches?.("input:not([type=range]), textarea, select");
    if (!this.session || typing || this.querySelector("dialog[open]")) return;
    const key = event.key.toLowerCase();
    if (event.ctrlKey || event.metaKey) {
      if (key !== "z" && key !== "y") return;
      event.preventDefault();
      if (key === "y" || event.shiftKey) this.session.redo();
      else this.session.undo();
    } else if (key === "escape") this.escape();
  }

  private escape(): void {
    if (this.session?.looking !== null) return this.session?.look(null);
    this.querySelector<HTMLElement>(".drawer-acts [aria-expanded=true]")?.focus();
    this.drawer = null;
  }

  /** A pointer's gesture on any control is one entry of the history; when it happened is measured. */
  private note(event: Event): void {
    if (!this.session) return;
    this.session.askedAt = event.timeStamp;
    if (event.type === "pointerdown") {
      this.gripped = null;
      this.session.history.hold();
      addEventListener("pointerup", () => this.session?.history.release(), { once: true });
      addEventListener("pointercancel", () => this.session?.history.release(), { once: true });
    }
  }

  /** Where the mix lies on a slider. */
  private whereIs(id: string, kind: Kind): number {
    const { space, weights } = this.session!;
    const slider = slidersOf(space, kind, this.language).find((one) => one.id === id);
    return mixed(slider?.values ?? [], weights);
  }

  private choose({ id, instead }: Chosen): void {
    const { by } = this.session!.place;
    if (by === "weights") return;
    const value = this.whereIs(id, by);
    this.move((place) => (instead ? swapped(place, instead, id, value) : added(place, id, value)), "pairs");
    void this.updateComplete.then(() => this.querySelector<HTMLElement>(`[data-slider="${id}"] input`)?.focus());
  }

  private openDrawer(name: Drawer): void {
    this.drawer = this.drawer === name ? null : name;
  }

  private get feelActs(): FeelActs {
    return {
      by: (by) => this.move((place) => switched(place, by, this.session!.space, this.session!.weights), "interface"),
      speak: (language) => (this.language = language),
      set: (id, value) => this.move((place) => moved(place, { [id]: value }), id),
      add: () => this.chooser.show(),
      swap: (id) => this.chooser.show(id),
      remove: (id) => {
        this.move((place) => removed(place, id), "pairs");
        void this.updateComplete.then(() => this.querySelector<HTMLElement>(".slider-acts button")?.focus());
      },
      middle: () => this.move(middle, "middle"),
      weights: () => (this.drawer = "results"),
    };
  }

  private get weightActs(): WeightActs & ExportActs {
    return {
      weigh: (clip, weight) => {
        const { place, space, weights, history } = this.session!;
        const from = this.gripped ?? switched(place, "weights", space, weights);
        this.gripped = history.isHeld ? from : null;
        this.move(() => weighed(from, clip, weight), clip);
      },
      look: (index) => this.look(index),
      join: () => void this.chooseClip(),
      variant: async () => ({ ...(await this.session!.recipe()), name: this.session!.name || this.session!.suggestedName }),
      download: (suffix) => void this.download(suffix),
      copied: (words) => (this.said = words),
    };
  }

  private look(index: number): void {
    this.session!.look(this.session!.looking === index ? null : index);
    if (matchMedia(PHONE).matches) this.drawer = null; // its events stand under the stage
  }

  private goTo(index: number): void {
    this.move((place) => placeOfExample(place, this.session!.space, index), "example");
  }

  private keytimeActs(session: SpaceSession, index: number): KeytimeActs {
    const { clip } = session.space.definition.examples[index]!;
    return {
      move: ({ name, time }) => {
        session.setKeytimes(index, { ...session.keytimesOf(index), [name]: time }, `${clip} ${name}`);
        this.viewer?.pause();
        this.viewer?.seek(time);
      },
      find: () => void this.attempt(async () => session.setKeytimes(index, await server.keytimes(clip), "find")),
      save: () => void this.attempt(() => this.renew()),
    };
  }

  /** The space's next version takes this one's place on the page: it stands where this one stood, moved events are in it. */
  private async renew(join: string[] = []): Promise<void> {
    const { place, name, changedKeytimes } = this.session!;
    const space = await server.version(this.wanted, { join, keytimes: changedKeytimes ?? {} });
    this.open(space, carried(place, space));
    this.session!.name = name;
    this.told = `Version ${space.number} is made.`;
  }

  private async chooseClip(): Promise<void> {
    await this.attempt(async () => {
      this.clips = await studio.clips();
    });
    if (!this.failure) this.picker.show();
  }

  private async join(clip: string): Promise<void> {
    await this.attempt(() => this.renew([clip]));
    if (!this.failure) return this.joining.close();
    this.joining.refuse(this.failure);
    this.failure = null;
  }

  private showExports(): void {
    this.drawer = "results";
    void this.updateComplete.then(() => this.querySelector<HTMLElement>("#export")?.focus());
  }

  protected override render(): TemplateResult {
    const { session, drawer, busy } = this;
    const note = { handleEvent: (event: Event) => this.note(event), capture: true };
    const acts = {
      undo: () => session?.undo(),
      redo: () => session?.redo(),
      exports: () => this.showExports(),
      save: () => void this.save(),
      drawer: (name: Drawer) => this.openDrawer(name),
    };
    return html`${spaceBar(session, { drawer, busy }, acts)}
      <div class="studio space ${drawer ? `with-${drawer}` : ""}">
        <aside class="side movement" aria-label="How it feels" @pointerdown=${note} @pointermove=${note} @keydown=${note} @input=${note}>
          ${session ? feelPanel(session, { language: this.language, languages: this.languages, map: this.map(session) }, this.feelActs) : nothing}</aside>
        ${stage(session, this.failure, {
          ready: () => this.onReady(),
          motion: () => this.onMotion(),
          goTo: (index) => this.goTo(index),
          again: () => void this.begin(),
          dismiss: () => (this.failure = null),
        })}
        ${session ? this.strip(session) : nothing}
        <aside class="side results" aria-label="The mix" @pointerdown=${note} @pointermove=${note} @keydown=${note} @input=${note}>
          ${session ? weightsPanel(session, { said: this.said, told: this.told, busy }, this.weightActs) : nothing}</aside>
      </div>
      ${session ? this.dialogs(session) : nothing}`;
  }

  private map(session: SpaceSession): TemplateResult | typeof nothing {
    const { place, space } = session;
    const kind = place.by === "weights" ? (space.definition.adjectives ? "adjectives" : "features") : place.by;
    return mapPanel(session, kind, slidersOf(space, kind, this.language), this.axes, {
      choose: (axes) => (this.axes = axes),
      place: ({ x, y }, [across, up]) =>
        this.move((place) => moved(switched(place, kind, space, session.weights), { [across]: x, [up]: y }), "map"),
      example: (index) => this.goTo(index),
    });
  }

  private strip(session: SpaceSession): TemplateResult {
    return html`<section class="studio-strip" aria-label="When"><time-strip .viewer=${this.stageViewer}
      .contacts=${mixedContacts(session)} .findings=${session.findings}></time-strip>
      ${session.looking === null ? nothing : keytimePanel(session, session.looking, this.busy, this.keytimeActs(session, session.looking))}</section>`;
  }

  private dialogs(session: SpaceSession): TemplateResult {
    const { examples } = session.space.definition;
    const there = new Set(examples.map(({ clip }) => clip));
    const clip = (wanted: string) => this.clips.find(({ id }) => id === wanted)!;
    const joined = ({ detail }: CustomEvent<string>) => void this.joining.show(clip(detail), clip(examples[0]!.clip));
    return html`${this.pairs(session)}
      <clip-picker .clips=${this.clips.filter(({ id }) => !there.has(id))} @pick=${joined}></clip-picker>
      <join-dialog space=${session.space.id} language=${this.language} next=${session.nextVersion} @join=${({ detail }: CustomEvent<string>) => void this.join(detail)}></join-dialog>`;
  }

  private pairs({ place, space }: SpaceSession): TemplateResult | typeof nothing {
    const { by } = place;
    const sliders = by === "weights" ? null : space.definition[by];
    if (by === "weights" || !sliders) return nothing;
    const clusters = clustersOf(sliders, slidersOf(space, by, this.language), this.language);
    return html`<pair-chooser heading=${by === "adjectives" ? "Choose a pair" : "Choose a feature"} .clusters=${clusters}
      .taken=${Object.keys(place[by])} @choose=${({ detail }: CustomEvent<Chosen>) => this.choose(detail)}></pair-chooser>`;
  }
}
