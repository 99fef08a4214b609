// One space being authored in: where one stands, what was before, the motion on the stage, what is saved.
import { api } from "../api";
import type { Finding } from "../studio/checks";
import { History } from "../studio/history";
import { Latest } from "../studio/latest";
import { freeName } from "../studio/names";
import { same } from "../studio/recipe";
import type { Edited } from "../studio/server";
import * as studio from "../studio/server";
import { asApiError, Staging, type Show } from "../studio/staging";
import { findState, keepState, type State } from "./draft";
import { nameOf, pointOf, start, type Place } from "./model";
import * as server from "./server";

export class SpaceSession extends Staging<Place, State> {
  readonly history: History<State>;
  name = "";
  saved: { id: string; name: string; place: Place } | null = null;
  /** Of the motion on the stage: the examples' weights, in their order, and how far outside of them it is. */
  weights: readonly number[];
  outside = 0;
  /** The example that is looked at instead of the mix. */
  looking: number | null = null;
  private isReady = false;
  private readonly looks = new Latest<number>((index) => this.showExample(index));
  private checked: { place: Place; findings: Finding[] } | null = null;
  private readonly files = new Map<string, ArrayBuffer>();

  /** `from`: where to begin; without it where one stood last, or in the middle. */
  constructor(readonly space: server.Space, private readonly stage: Show, changed: () => void, from?: Place) {
    super(changed);
    const state = from ? { place: from, keytimes: {} } : (findState(space) ?? { place: start(space), keytimes: {} });
    this.history = new History<State>(state);
    this.weights = Object.values(state.place.weights);
  }

  get place(): Place {
    return this.history.present.place;
  }

  protected override get wish(): Place {
    return this.place;
  }

  get isSaved(): boolean {
    return this.saved !== null && this.saved.place === this.place && (!this.name || this.name === this.saved.name);
  }

  get suggestedName(): string {
    return nameOf(this.place, this.space);
  }

  /** The stage can take motions. */
  begin(): void {
    this.isReady = true;
    this.shown = null;
    this.refresh();
  }

  move(place: Place, control: string): void {
    this.looking = null;
    this.history.set({ ...this.history.present, place }, control);
    this.refresh();
  }

  call(name: string): void {
    this.name = name;
    this.changed();
  }

  /** An example's events: as they were moved, or as the space has them. */
  keytimesOf(index: number): server.Keytimes {
    const { clip, keytimes } = this.space.definition.examples[index]!;
    return this.history.present.keytimes[clip] ?? (keytimes as server.Keytimes);
  }

  setKeytimes(index: number, keytimes: server.Keytimes, control: string): void {
    const { clip } = this.space.definition.examples[index]!;
    const { place, keytimes: others } = this.history.present;
    this.history.set({ place, keytimes: { ...others, [clip]: keytimes } }, control);
    keepState(this.space.id, this.history.present);
    this.changed();
  }

  /** The examples whose events were moved away from where the space has them. */
  get changedKeytimes(): Record<string, server.Keytimes> | null {
    const known = new Map(this.space.definition.examples.map(({ clip, keytimes }) => [clip, keytimes]));
    const changed = Object.entries(this.history.present.keytimes).filter(([clip, keytimes]) => !same(keytimes, known.get(clip)));
    return changed.length ? Object.fromEntries(changed) : null;
  }

  /** What the checks found in the mix on the stage; null as long as that is not known. */
  get findings(): Finding[] | null {
    return this.looking === null && this.checked?.place === this.place ? this.checked.findings : null;
  }

  /** What this space becomes when it is changed. */
  get nextVersion(): string {
    return this.space.newest ? `version ${this.space.number + 1}` : "a new version";
  }

  /** Look at an example as it is; null goes back to the mix. */
  look(index: number | null): void {
    this.looking = index;
    if (index === null) this.refresh(true);
    else this.looks.ask(index);
    this.changed();
  }

  recipe(): Promise<Edited> {
    return server.recipe(this.space.id, pointOf(this.place));
  }

  /** Keep the mix as a clip of the library; tells its id. */
  async save(): Promise<string> {
    if (this.isSaved) return this.saved!.id;
    const { place } = this;
    const [edited, clips] = await Promise.all([this.recipe(), studio.clips()]);
    const wanted = this.name || this.suggestedName;
    const others = clips.filter(({ id }) => id !== this.saved?.id).map(({ name }) => name);
    const name = freeName(wanted, others);
    const clip = await studio.save(edited, name);
    const named = [name, wanted].includes(clip.name) ? clip : await studio.rename(clip.id, name);
    this.saved = { id: named.id, name: named.name, place };
    this.name = named.name;
    this.changed();
    return named.id;
  }

  protected override refresh(again = false): void {
    keepState(this.space.id, this.history.present);
    if (this.place.by === "weights") this.weights = Object.values(this.place.weights);
    if (this.isReady && (again || !this.isShown)) this.shows.ask(this.place);
    this.changed();
  }

  protected override async put(place: Place, askedAt: number): Promise<void> {
    const { glb, weights, outside } = await server.motion(this.space.id, pointOf(place));
    if (this.looking === null) this.stage(glb, askedAt);
    if (this.place.by !== "weights") this.weights = weights;
    this.outside = outside;
    this.checkSoon(place);
  }

  /** Of a mix that is gone already, or that could not be checked, nothing is said. */
  protected override async check(place: Place): Promise<void> {
    if (place !== this.place) return;
    try {
      const { report } = await studio.check(await this.recipe());
      this.checked = { place, findings: report.findings };
    } catch {
      this.checked = null;
    }
    this.changed();
  }

  private async showExample(index: number): Promise<void> {
    const address = this.space.clips[index]!.glb_url;
    try {
      const glb = this.files.get(address) ?? (await api.bytes(address));
      this.files.set(address, glb);
      if (this.looking === index) this.stage(glb, 0);
    } catch (error) {
      this.looking = null;
      this.problem = asApiError(error);
    }
    this.changed();
  }
}
