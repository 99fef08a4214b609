// <motion-space>: authors a motion by how it feels. Left the sliders, right the mix of examples, below when.
import { html, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { ExportActs, Suffix } from "../studio/export_panel";
import type { ClipPicker } from "../studio/picker";
import * as studio from "../studio/server";
import type { Drawer } from "../studio/top_bar";
import { Workbench } from "../studio/workbench";
import { language } from "../words";
import { dialogs, type DialogActs } from "./dialogs";
import { feelPanel, type FeelActs } from "./feel_panel";
import type { JoinDialog } from "./join_dialog";
import { keytimePanel, type KeytimeActs } from "./keytime_panel";
import { mixedContacts } from "./keytimes";
import { mapPanel, type Axes, type MapActs } from "./map_panel";
import {
  added, carried, lost, middle, mixed, moved, placeOfExample, removed, slidersOf, swapped, switched, weighed, type Kind, type Place,
} from "./model";
import type { Chosen, PairChooser } from "./pair_chooser";
import * as server from "./server";
import { SpaceSession } from "./session";
import { stage } from "./stage";
import { spaceBar } from "./space_bar";
import { weightsPanel, type WeightActs } from "./weights_panel";
import { languagesOf } from "./words";
import "../studio/time_strip";

/** Here a drawer hides the time strip. */
const PHONE = "(max-width: 699px)";

@customElement("motion-space")
export class MotionSpace extends Workbench<SpaceSession> {
  @property({ attribute: "space" }) wanted = "";
  /** What was made of the space, in words. */
  @state() private told = "";
  @state() language = language();
  @state() private axes: Axes | null = null;
  @state() clips: studio.Clip[] = [];
  @query("pair-chooser") private chooser!: PairChooser;
  @query("clip-picker") private picker!: ClipPicker;
  @query("join-dialog") private joining!: JoinDialog;
  /** The weights as a drag found them: at 100 % the others' proportions would be lost for the way back. */
  private gripped: Place | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    void this.begin();
  }

  protected override reconnected(): void {
    void this.begin();
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

  private onReady(): void {
    this.stageViewer = this.viewer;
    this.session?.begin();
  }

  private move(change: (place: Place) => Place, control: string): void {
    const { session } = this;
    session?.move(change(session.place), control);
  }

  private save(): Promise<string | undefined> {
    return this.attempt(() => this.session!.save());
  }

  private download(suffix: Suffix): Promise<void> {
    return this.attempt(async () => {
      this.take(await this.session!.save(), suffix);
    });
  }

  protected override press(key: string): void {
    if (key !== "escape") return;
    if (this.session!.looking === null) this.closeDrawer();
    else this.session!.look(null);
  }

  protected override note(event: Event): void {
    if (event.type === "pointerdown") this.gripped = null;
    super.note(event);
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
      saved: async () => [await this.save()].filter((id) => id !== undefined),
    };
  }

  private get mapActs(): MapActs {
    return {
      choose: (axes) => (this.axes = axes),
      move: (change) => this.move(change, "map"),
      goTo: (index) => this.goTo(index),
    };
  }

  private get dialogActs(): DialogActs {
    const clip = (wanted: string) => this.clips.find(({ id }) => id === wanted)!;
    return {
      choose: (chosen) => this.choose(chosen),
      pick: (picked) => void this.joining.show(clip(picked), clip(this.session!.space.definition.examples[0]!.clip)),
      join: (joining) => void this.join(joining),
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
    const { place, name, changedKeytimes, space: before } = this.session!;
    const space = await server.version(this.wanted, { join, keytimes: changedKeytimes ?? {} });
    this.open(space, carried(place, space));
    this.session!.name = name;
    const gone = lost(before, space, this.language);
    this.told = `Version ${space.number} is made.${gone ? ` It has no longer: ${gone}. Version ${before.number} stays under Spaces.` : ""}`;
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

  protected override render(): TemplateResult {
    const { session, drawer, busy, noted } = this;
    const acts = {
      undo: () => session?.undo(),
      redo: () => session?.redo(),
      exports: () => this.showExports(),
      save: () => void this.save(),
      drawer: (name: Drawer) => this.toggle(name),
    };
    return html`${spaceBar(session, { drawer, busy }, acts)}
      <div class="studio space ${drawer ? `with-${drawer}` : ""}">
        <aside class="side movement" aria-label="How it feels" @pointerdown=${noted} @pointermove=${noted} @keydown=${noted} @input=${noted}>
          ${session ? feelPanel(session, { language: this.language, languages: this.languages, map: mapPanel(session, this.language, this.axes, this.mapActs) }, this.feelActs) : nothing}</aside>
        ${stage(session, this.failure, {
          ready: () => this.onReady(),
          motion: () => this.onMotion(),
          goTo: (index) => this.goTo(index),
          again: () => void this.begin(),
          dismiss: () => (this.failure = null),
        })}
        ${session ? this.strip(session) : nothing}
        <aside class="side results" aria-label="The mix" @pointerdown=${noted} @pointermove=${noted} @keydown=${noted} @input=${noted}>
          ${session ? weightsPanel(session, { said: this.said, told: this.told, busy }, this.weightActs) : nothing}</aside>
      </div>
      ${session ? dialogs(session, this, this.dialogActs) : nothing}`;
  }

  private strip(session: SpaceSession): TemplateResult {
    return html`<section class="studio-strip" aria-label="When"><time-strip .viewer=${this.stageViewer}
      .contacts=${mixedContacts(session)} .findings=${session.findings}></time-strip>
      ${session.looking === null ? nothing : keytimePanel(session, session.looking, this.busy, this.keytimeActs(session, session.looking))}</section>`;
  }
}
