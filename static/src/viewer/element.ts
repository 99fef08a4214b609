/**
 * `<motion-viewer>`: shows motions on a small stage and lets a person look, play and turn.
 *
 * Attributes: `src`, `figure`, or one `<motion-figure src figure as label ghost>` for each figure;
 * `controls` ("none", "views": only the named views, "simple", "full"), `arrange`, `theme`, `tier`,
 * `loop`, `autoplay`, `static`, `azimuth`, `poster-time`, `label`, `in-step` (the first figure keeps
 * its time, the others are as far through their clips as it is through its own). Another source,
 * role or label loads anew; nothing below does.
 *
 * `setMotion(index, glb)` gives a figure another motion of the same skeleton; moment, play state and
 * view stay. `setPose(index, root, rotations)` poses it from outside, with `live` set.
 * `setShown(index, shown)` and `arrange` ("ghost": ghosts behind as marked, "beside": all side by
 * side, "one": alone, the first that is shown, "cells": each alone in its own of the `cells`, CSS
 * pixels from the viewer's upper left, all of one size) choose who is on view. `view(name)` turns to
 * "three-quarter", "front" or "side", `look(azimuth, elevation, zoom)` to any view. `figures[i].jointPositions()` are metres, x y z a joint.
 *
 * Events: `ready`, `frame` {time} after every drawn frame, `timeupdate` {time} some ten times a
 * second, `motion` {index} when a motion from `setMotion` is first on view, `ended`, `error`
 * {message}, `progress` {loaded, total} of the files, `unsupported`.
 */
import { describeArea, helpText, nameArea } from "./area";
import type { Body } from "./body";
import { PRESETS, type Preset } from "./camera";
import { wantedFigures, type Wanted } from "./casting";
import { readClip } from "./clip";
import { Controls, type Playable } from "./controls";
import { make, numberOf } from "./dom";
import { FrameLoop } from "./frame_loop";
import { parseGlb } from "./glb";
import { handleKey, listenToPointer } from "./input";
import { furnish, stageFrame } from "./layout";
import { Legend } from "./legend";
import { Loading } from "./loading";
import { failureMessage, unsupportedMessage } from "./overlay";
import { PlaybackElement } from "./playback";
import { Surface, type Area } from "./renderer";
import { ARRANGEMENTS, Stage, type Arrangement, type Performer } from "./stage";
import { standingClip } from "./standing";
import { Statistics, type Tier, type ViewingStatistics } from "./statistics";
import { viewerStyles } from "./styles";
import { hasWebGL } from "./support";
import { modeOf, wantsStillness, watchMode } from "./theme";
import { tierChooser } from "./tier";

/** `timeupdate` comes at most this often while playing. */
const TELL_MS = 100;

export class MotionViewer extends PlaybackElement implements Playable {
  static readonly observedAttributes = [
    "src", "figure", "theme", "controls", "loop", "poster-time", "static", "azimuth", "tier", "label",
    "arrange",
  ];

  private readonly counts = new Statistics();
  private readonly legend = new Legend();
  private readonly area = make("div", { class: "stage" });
  private readonly overlay = make("div");
  private readonly frames = new FrameLoop(this, (now, passed) => this.onFrame(now, passed));
  private readonly resized = new ResizeObserver(() => this.layOut());
  private readonly markup = new MutationObserver(() => this.reload());
  private stage: Stage | null = null;
  private controls: Controls | null = null;
  private stopWatching = () => {};
  /** The camera has moved since the labels were put over their figures. */
  private labelsStale = true;
  private reloadQueued = false;
  private readonly loading = new Loading({
    say: (message) => this.say(message),
    await: (body) => this.awaitMotion(body),
    progress: (loaded, total) => this.tell("progress", { loaded, total }),
    begin: (performers, wanted) => this.begin(performers, wanted),
    fail: (error) => this.fail(error),
  });
  private wanted: Wanted[] = [];
  /** A pose has come from outside since the last frame. */
  private posed = false;
  /** Figures whose new motion has not been drawn yet. */
  private unseen: number[] = [];
  private lastTold = 0;
  private chosenPreset: Preset | null = "three-quarter";
  private ownCells: readonly Area[] = [];

  constructor() {
    super();
    const root = this.attachShadow({ mode: "open" });
    root.adoptedStyleSheets = [viewerStyles()];
    root.append(this.area, helpText(), this.legend.element, this.overlay);
    const turn = {
      orbit: (azimuth: number, elevation: number) => this.turnBy(azimuth, elevation),
      zoomBy: (factor: number) => this.zoomBy(factor),
      turned: () => !this.isStatic && this.counts.countCameraMove(),
    };
    listenToPointer(this.area, turn, () => this.isFull);
    this.addEventListener("keydown", (event) => this.onKey(event, turn));
    this.player.onStart = () => this.counts.countPlay();
    this.player.onEnd = () => this.tell("ended");
  }

  connectedCallback(): void {
    if (!hasWebGL()) return this.giveUp();
    this.stage = new Stage(new Surface());
    this.stage.surface.onLost = () => this.request();
    this.stage.arrange(this.arrange);
    this.area.prepend(this.stage.surface.element);
    this.stopWatching = watchMode(() => this.applyTheme());
    this.frames.start();
    this.markup.observe(this, { childList: true, subtree: true, attributes: true,
      attributeFilter: ["src", "figure", "as", "role", "ghost", "label"] });
    this.resized.observe(this);
    this.applyTheme();
    this.applyTier();
    this.buildControls();
    this.reload();
  }

  disconnectedCallback(): void {
    this.frames.stop();
    this.loading.cancel();
    this.player.pause();
    this.stopWatching();
    this.markup.disconnect();
    this.resized.disconnect();
    this.stage?.dispose();
    this.stage?.surface.dispose();
    this.stage = null;
  }

  attributeChangedCallback(name: string): void {
    if (!this.stage) return;
    if (name === "src" || name === "figure") this.reload();
    else if (name === "theme") this.applyTheme();
    else if (name === "tier") this.applyTier();
    else if (name === "controls" || name === "static") this.buildControls();
    else if (name === "loop") this.applyLoop();
    else if (name === "azimuth") this.stage.setAzimuth(numberOf(this, "azimuth"));
    else if (name === "label") nameArea(this.area, this);
    else if (name === "arrange") this.applyArrangement();
    this.request();
  }

  get figures(): readonly { jointPositions(): Float32Array }[] {
    return this.stage?.figures ?? [];
  }

  get statistics(): ViewingStatistics {
    return this.counts.report(this.tier);
  }

  get cameraMoved(): boolean {
    return this.stage?.orbit.moved ?? false;
  }

  get preset(): Preset | null {
    return this.chosenPreset;
  }

  /** Poses come from outside: the viewer's own clock stands still. */
  get live(): boolean {
    return this.isLive;
  }

  set live(live: boolean) {
    this.isLive = live;
    this.player.pause();
    this.frames.restart();
    this.request();
  }

  get arrange(): Arrangement {
    const asked = this.getAttribute("arrange") as Arrangement;
    return ARRANGEMENTS.includes(asked) ? asked : "ghost";
  }

  set arrange(arrangement: Arrangement) {
    this.setAttribute("arrange", arrangement);
  }

  /** Where each figure is drawn with `arrange="cells"`. */
  set cells(cells: readonly Area[]) {
    this.ownCells = cells;
    this.layOut();
  }

  /**
   * Gives a figure another motion at once; body, moment, play state and view stay.
   *
   * Throws GlbError when the file is no motion or one for another skeleton, RangeError when there
   * is no such figure (yet); the old motion then goes on.
   */
  setMotion(index: number, glb: ArrayBuffer): void {
    const stage = this.begunStage();
    stage.setMotion(index, readClip(parseGlb(glb)), wantsStillness());
    this.player.swap(stage.timed);
    this.shortestFrame = stage.frameTime;
    this.unseen.push(index);
    this.request();
  }

  /**
   * Poses a figure from outside and stops the own clock (`live`).
   *
   * @param root metres. @param rotations J × 4, xyzw, in the order of the clip's joints.
   * Throws RangeError when the numbers do not fit the figure.
   */
  setPose(index: number, root: ArrayLike<number>, rotations: ArrayLike<number>): void {
    this.begunStage().setPose(index, root, rotations, performance.now() / 1000);
    if (!this.isLive) this.live = true;
    this.posed = true;
    this.request();
  }

  /** Shows or hides one figure, its ground with it. */
  setShown(index: number, shown: boolean): void {
    this.stage?.setShown(index, shown);
    this.showLegend();
    this.request();
  }

  resetCamera(): void {
    this.chosenPreset = this.hasAttribute("azimuth") ? null : "three-quarter";
    this.stage?.orbit.reset(wantsStillness());
    this.counts.countCameraMove();
    this.request();
  }

  /** Turns to one of the named views. */
  view(preset: Preset): void {
    this.chosenPreset = preset;
    this.stage?.orbit.flyTo(PRESETS[preset], wantsStillness());
    this.counts.countCameraMove();
    this.request();
  }

  /** Where a point of the stage (metres) is seen: pixels from the upper left, null before `ready`. */
  project(x: number, y: number, z: number): { x: number; y: number } | null {
    return this.stage && this.loaded ? this.stage.project(x, y, z) : null;
  }

  private get isStatic(): boolean {
    return this.hasAttribute("static");
  }

  private get isFull(): boolean {
    return ["full", "views"].includes(this.getAttribute("controls") ?? "") && !this.isStatic;
  }

  private get tier(): Tier {
    const asked = this.getAttribute("tier");
    return asked === "full" || asked === "plain" ? asked : tierChooser().tier;
  }

  private tell(name: string, detail?: unknown): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  protected showMoment(): void {
    if (this.loaded && !this.isLive) this.stage?.setTime(this.player.elapsed);
  }

  private begunStage(): Stage {
    if (!this.stage || !this.loaded) throw new RangeError("No figure is here yet; wait for “ready”.");
    return this.stage;
  }

  private giveUp(): void {
    this.area.hidden = true;
    this.overlay.replaceChildren(unsupportedMessage());
    queueMicrotask(() => this.tell("unsupported"));
  }

  private buildControls(): void {
    this.controls?.bar.remove();
    this.controls?.views?.remove();
    this.controls = null;
    describeArea(this.area, this.isStatic);
    if (this.getAttribute("controls") !== "none" && !this.isStatic) {
      this.controls = new Controls(this, this.isFull);
      this.showBar();
      this.shadowRoot!.append(this.controls.bar);
      if (this.controls.views) this.shadowRoot!.append(this.controls.views);
      this.resized.observe(this.controls.bar);
    }
    this.layOut();
  }

  /** A page with a time strip of its own has no use for the bar. */
  private showBar(): void {
    const unwanted = this.getAttribute("controls") === "views";
    if (this.controls) this.controls.bar.hidden = unwanted || !this.loaded;
  }

  private applyTheme(): void {
    this.stage?.setMode(modeOf(this.getAttribute("theme")));
    this.request();
  }

  private applyTier(): void {
    this.stage?.setTier(this.tier);
    this.layOut();
  }

  private applyLoop(): void {
    const asked = this.getAttribute("loop");
    this.player.loop = asked === null || asked === "auto" ? this.player.endless : asked !== "off";
  }

  private applyArrangement(): void {
    this.stage?.arrange(this.arrange);
    this.showLegend();
  }

  private showLegend(): void {
    if (this.stage) this.legend.show(this.wanted, this.stage);
    this.layOut();
  }

  private layOut(): void {
    if (!this.stage || this.clientWidth === 0) return;
    const { clientWidth: width, clientHeight: height, controls } = this;
    const furniture = furnish(controls, this.legend.element, this.overlay);
    const [cell] = this.arrange === "cells" ? this.ownCells : [];
    this.stage.setCells(this.ownCells);
    this.stage.setFrame(stageFrame(cell?.width ?? width, cell?.height ?? height, furniture));
    this.labelsStale = true;
    const ratio = this.tier === "plain" ? Math.min(devicePixelRatio, 1.5) : devicePixelRatio;
    this.stage.surface.resize(width, height, ratio);
    this.request();
  }

  private reload(): void {
    if (this.reloadQueued) return;
    this.reloadQueued = true;
    queueMicrotask(() => {
      this.reloadQueued = false;
      if (!this.stage) return;
      this.clearStage();
      void this.loading.fetch(wantedFigures(this));
    });
  }

  private clearStage(): void {
    this.loaded = false;
    this.player.load([]);
    this.stage?.cast([]);
    this.wanted = [];
    this.overlay.replaceChildren();
    this.showBar();
    nameArea(this.area, this);
    this.showLegend();
  }

  private awaitMotion(body: Body): void {
    this.stage?.cast([{ body, clip: standingClip(body), role: "original", ghost: "loading" }]);
    this.request();
  }

  private begin(performers: Performer[], wanted: Wanted[]): void {
    const { stage, player } = this;
    if (!stage) return;
    this.overlay.replaceChildren();
    stage.setAzimuth(numberOf(this, "azimuth"));
    stage.inStep = this.hasAttribute("in-step");
    stage.cast(performers);
    player.load(stage.timed);
    this.shortestFrame = stage.frameTime;
    this.applyLoop();
    this.counts.reset();
    this.loaded = true;
    this.wanted = wanted;
    this.showBar();
    this.showLegend();
    if (this.hasAttribute("autoplay") && !this.isStatic) player.play();
    else this.seek(numberOf(this, "poster-time") ?? 0);
    this.frames.restart();
    this.drawFrame(performance.now());
    this.tell("ready");
    this.request();
  }

  /** Puts words under the stage, which makes room for them. */
  private say(message: HTMLElement): void {
    this.overlay.replaceChildren(message);
    this.layOut();
  }

  private fail(error: Error): void {
    this.stage?.cast([]);
    this.say(failureMessage(error, () => this.reload()));
    this.tell("error", { message: error.message });
  }

  /** Turns the view to these degrees and this zoom at once. */
  look(azimuth: number, elevation: number, zoom: number): void {
    this.stage?.orbit.look(azimuth, elevation, zoom);
    this.chosenPreset = null;
    this.labelsStale = true;
    this.request();
  }

  private turnBy(azimuth: number, elevation: number): void {
    if (this.isStatic) return;
    this.chosenPreset = null;
    this.stage?.orbit.orbit(azimuth, elevation);
    this.labelsStale = true;
    this.request();
  }

  private zoomBy(factor: number): void {
    this.stage?.orbit.zoomBy(factor);
    this.request();
  }

  private onKey(event: KeyboardEvent, turn: Parameters<typeof handleKey>[2]): void {
    const origin = event.composedPath()[0] as HTMLElement;
    const own = origin === this.area || origin === this.controls?.scrubber;
    if (!own && (event.key === " " || origin.localName === "select")) return;
    if (!this.loaded || this.isStatic) return;
    if (handleKey(event, this, turn, this.isFull)) event.preventDefault();
  }

  protected request(): void {
    if (this.stage) this.frames.ask();
  }

  /** Returns whether more frames are to follow. */
  private onFrame(now: number, passed: number): boolean {
    const { player, stage } = this;
    if (!stage) return false;
    const { posed } = this;
    this.posed = false;
    const moving = !player.paused || posed;
    player.advance(passed / 1000);
    stage.orbit.advance(passed);
    if (moving && passed > 0) this.counts.countInterval(passed);
    const busy = this.drawFrame(now);
    // Only frames in a running sequence say what a frame costs: the first one compiles shaders.
    if (passed > 0) this.counts.countWork(busy);
    if (moving && passed > 0 && tierChooser().note(passed)) this.applyTier();
    return !player.paused || posed || stage.orbit.flying;
  }

  /** Poses and draws; returns the main-thread time it took, in milliseconds. */
  private drawFrame(now: number): number {
    const { stage } = this;
    if (!stage) return 0;
    const started = performance.now();
    this.showMoment();
    stage.draw();
    if (this.labelsStale) this.legend.place(stage.labelPlaces());
    this.labelsStale = stage.orbit.flying;
    const busy = performance.now() - started;
    if (this.loaded) this.countFrame(stage);
    this.controls?.update();
    this.tellOfFrame(now);
    return busy;
  }

  private countFrame({ orbit }: Stage): void {
    this.counts.countFrame();
    this.counts.countSight(orbit.azimuth, orbit.elevation, orbit.zoom);
  }

  private tellOfFrame(now: number): void {
    this.tell("frame", { time: this.currentTime });
    for (const index of this.unseen.splice(0)) this.tell("motion", { index });
    if (now - this.lastTold < TELL_MS && !this.player.paused) return;
    this.lastTold = now;
    this.tell("timeupdate", { time: this.currentTime });
  }
}
