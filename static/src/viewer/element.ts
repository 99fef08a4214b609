/** `<motion-viewer>`: shows motions on a small stage and lets a person look, play and turn. */
import type { Body } from "./body";
import { PRESETS, type Preset } from "./camera";
import { wantedFigures, type Wanted } from "./casting";
import { Controls, type Playable } from "./controls";
import { make } from "./dom";
import { handleKey, listenToPointer } from "./input";
import { stageFrame } from "./layout";
import { Legend } from "./legend";
import { Loading } from "./loading";
import { failureMessage, unsupportedMessage } from "./overlay";
import { Player } from "./player";
import { Surface } from "./renderer";
import { Stage, type Performer } from "./stage";
import { standingClip } from "./standing";
import { Statistics, type Tier, type ViewingStatistics } from "./statistics";
import { viewerStyles } from "./styles";
import { hasWebGL } from "./support";
import { modeOf, wantsStillness, watchMode } from "./theme";
import { tierChooser } from "./tier";
import { Visibility } from "./visibility";

const HELP =
  "Space plays and pauses, R replays, left and right arrow step by frames, Home and End go to the " +
  "ends. Alt with the arrow keys turns the view, 0 resets it.";
const INTERACTIVE = {
  tabindex: "0",
  "aria-roledescription": "moving figure",
  "aria-describedby": "help",
};
/** `timeupdate` comes at most this often while playing. */
const TELL_MS = 100;

export class MotionViewer extends HTMLElement implements Playable {
  static readonly observedAttributes = [
    "src", "figure", "theme", "controls", "loop", "poster-time", "static", "azimuth", "tier", "label",
  ];

  private readonly player = new Player();
  private readonly counts = new Statistics();
  private readonly legend = new Legend();
  private readonly area = make("div", { class: "stage" });
  private readonly overlay = make("div");
  private readonly visibility = new Visibility(this, () => this.request());
  private readonly resized = new ResizeObserver(() => this.layOut());
  private readonly markup = new MutationObserver(() => this.reload());
  private stage: Stage | null = null;
  private controls: Controls | null = null;
  private stopWatching = () => {};
  private frameRequest = 0;
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
  private loaded = false;
  private lastFrame: number | null = null;
  private lastTold = 0;
  private shortestFrame = 0;
  private chosenPreset: Preset | null = "three-quarter";

  constructor() {
    super();
    const root = this.attachShadow({ mode: "open" });
    root.adoptedStyleSheets = [viewerStyles()];
    const help = make("p", { class: "hidden", id: "help" }, HELP);
    root.append(this.area, help, this.legend.element, this.overlay);
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
    this.area.prepend(this.stage.surface.element);
    this.stopWatching = watchMode(() => this.applyTheme());
    this.visibility.start();
    this.markup.observe(this, { childList: true, subtree: true, attributes: true,
      attributeFilter: ["src", "figure", "as", "role", "ghost", "label"] });
    this.resized.observe(this);
    this.applyTheme();
    this.applyTier();
    this.buildControls();
    this.reload();
  }

  disconnectedCallback(): void {
    cancelAnimationFrame(this.frameRequest);
    this.frameRequest = 0;
    this.loading.cancel();
    this.player.pause();
    this.stopWatching();
    this.visibility.stop();
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
    else if (name === "azimuth") this.stage.setAzimuth(this.number("azimuth"));
    else if (name === "label") this.applyLabel();
    this.request();
  }

  get currentTime(): number {
    return this.player.currentTime;
  }

  set currentTime(seconds: number) {
    this.seek(seconds);
  }

  /** Seconds; 0 until `ready`. */
  get duration(): number {
    return this.player.duration;
  }

  get paused(): boolean {
    return this.player.paused;
  }

  /** Seconds of the shortest frame among the clips shown. */
  get frameTime(): number {
    return this.shortestFrame;
  }

  get speed(): number {
    return this.player.speed;
  }

  set speed(speed: number) {
    this.player.speed = Math.min(Math.max(speed, 0.05), 8);
    this.request();
  }

  get loop(): boolean {
    return this.player.loop;
  }

  set loop(loop: boolean) {
    this.player.loop = loop;
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

  play(): void {
    if (!this.loaded) return;
    this.player.play();
    this.request();
  }

  pause(): void {
    this.player.pause();
    this.request();
  }

  replay(): void {
    if (!this.loaded) return;
    this.player.replay();
    this.request();
  }

  /** Goes to a moment and shows it at once, playing or not. */
  seek(seconds: number): void {
    this.player.seek(seconds);
    this.stage?.setTime(this.player.elapsed);
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
    return this.getAttribute("controls") === "full" && !this.isStatic;
  }

  private get tier(): Tier {
    const asked = this.getAttribute("tier");
    return asked === "full" || asked === "plain" ? asked : tierChooser().tier;
  }

  private number(attribute: string): number | null {
    const text = this.getAttribute(attribute);
    const value = Number(text);
    return text !== null && text.trim() !== "" && Number.isFinite(value) ? value : null;
  }

  private tell(name: string, detail?: unknown): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
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
    this.describeStage();
    const kind = this.getAttribute("controls") ?? "simple";
    if (kind !== "none" && !this.isStatic) {
      this.controls = new Controls(this, kind === "full");
      this.controls.bar.hidden = !this.loaded;
      this.shadowRoot!.append(this.controls.bar);
      if (this.controls.views) this.shadowRoot!.append(this.controls.views);
      this.resized.observe(this.controls.bar);
    }
    this.layOut();
  }

  /** A still is a picture; anything else answers to the keyboard and can be reached by it. */
  private describeStage(): void {
    const { area, isStatic } = this;
    area.setAttribute("role", isStatic ? "img" : "application");
    for (const [name, value] of Object.entries(INTERACTIVE)) {
      if (isStatic) area.removeAttribute(name);
      else area.setAttribute(name, value);
    }
  }

  private applyTheme(): void {
    this.stage?.setMode(modeOf(this.getAttribute("theme")));
    this.request();
  }

  private applyTier(): void {
    this.stage?.setTier(this.tier);
    this.stage?.setTime(this.player.elapsed);
    this.layOut();
  }

  private applyLoop(): void {
    const asked = this.getAttribute("loop");
    this.player.loop = asked === null || asked === "auto" ? this.player.endless : asked !== "off";
  }

  private applyLabel(): void {
    const label = this.getAttribute("label") ?? this.getAttribute("aria-label");
    this.area.setAttribute("aria-label", label ?? "Stage with a moving figure");
  }

  private layOut(): void {
    if (!this.stage || this.clientWidth === 0) return;
    const { clientWidth: width, clientHeight: height, controls } = this;
    const frame = stageFrame(width, height, {
      bare: controls === null,
      bar: controls?.bar.hidden === false ? controls.bar.offsetHeight : 0,
      words: (this.overlay.firstElementChild as HTMLElement | null)?.offsetHeight ?? 0,
      head: Math.max(this.legend.element.hidden ? 0 : 24, controls?.views?.offsetHeight ?? 0),
    });
    this.stage.setFrame(frame);
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
    this.legend.show([]);
    this.overlay.replaceChildren();
    if (this.controls) this.controls.bar.hidden = true;
    this.applyLabel();
    this.layOut();
  }

  private awaitMotion(body: Body): void {
    this.stage?.cast([{ body, clip: standingClip(body), role: "original", ghost: "loading" }]);
    this.request();
  }

  private begin(performers: Performer[], wanted: Wanted[]): void {
    const { stage, player } = this;
    if (!stage) return;
    this.overlay.replaceChildren();
    stage.setAzimuth(this.number("azimuth"));
    stage.cast(performers);
    player.load(performers.map(({ clip }) => clip));
    this.shortestFrame = Math.min(...performers.map(({ clip }) => clip.frameTime));
    this.applyLoop();
    this.counts.reset();
    this.loaded = true;
    this.legend.show(wanted.map((one) => ({ ...one, ghost: one.ghost !== null })));
    if (this.controls) this.controls.bar.hidden = false;
    this.layOut();
    if (this.hasAttribute("autoplay") && !this.isStatic) player.play();
    else this.seek(this.number("poster-time") ?? 0);
    this.lastFrame = null;
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

  /** Asks for one more frame, unless nobody could see it. */
  private request(): void {
    if (!this.visibility.visible) this.lastFrame = null;
    else if (this.frameRequest === 0 && this.stage) {
      this.frameRequest = requestAnimationFrame((now) => this.onFrame(now));
    }
  }

  private onFrame(now: number): void {
    this.frameRequest = 0;
    if (!this.stage || !this.visibility.visible) {
      this.lastFrame = null;
      return;
    }
    const passed = this.lastFrame === null ? 0 : now - this.lastFrame;
    const { player, stage } = this;
    const moving = !player.paused;
    player.advance(passed / 1000);
    stage.orbit.advance(passed);
    if (moving && passed > 0) this.counts.countInterval(passed);
    const busy = this.drawFrame(now);
    // Only frames in a running sequence say what a frame costs: the first one compiles shaders.
    if (passed > 0) this.counts.countWork(busy);
    if (moving && passed > 0 && tierChooser().note(passed)) this.applyTier();
    const going = !player.paused || stage.orbit.flying;
    this.lastFrame = going ? now : null;
    if (going) this.request();
  }

  /** Poses and draws; returns the main-thread time it took, in milliseconds. */
  private drawFrame(now: number): number {
    const { stage, player } = this;
    if (!stage) return 0;
    const started = performance.now();
    if (this.loaded) stage.setTime(player.elapsed);
    stage.draw();
    if (this.labelsStale) this.legend.place(stage.labelPlaces());
    this.labelsStale = stage.orbit.flying;
    const busy = performance.now() - started;
    if (this.loaded) this.counts.countFrame();
    this.controls?.update();
    if (now - this.lastTold >= TELL_MS || player.paused) {
      this.lastTold = now;
      this.tell("timeupdate");
    }
    return busy;
  }
}
