/**
 * `<motion-thumbnail src figure poster-time>`: a still that moves when pointed at or focused.
 *
 * However many a page has, they share one WebGL context and two stages: one draws stills, one after
 * the other and only for cards on screen; the other plays the one card that somebody looks at.
 */
import { loadBody, loadClip } from "./assets";
import type { Body } from "./body";
import type { MotionClip } from "./clip";
import { Player } from "./player";
import { Surface } from "./renderer";
import { Stage } from "./stage";
import { viewerStyles } from "./styles";
import { hasWebGL } from "./support";
import { modeOf, watchMode } from "./theme";
import { tierChooser } from "./tier";
import { Visibility } from "./visibility";

/** What to listen on: pointing at any part of a card plays it. */
const CARD = "a, button, li, article, [data-card]";
const MARGIN = { top: 14, bottom: 14, side: 8 };

/** Draws stills one a frame, so that a long page never blocks. */
class StillQueue {
  private readonly waiting = new Set<MotionThumbnail>();
  private scheduled = false;
  private stage: Stage | null = null;

  add(thumbnail: MotionThumbnail): void {
    this.waiting.add(thumbnail);
    this.schedule();
  }

  remove(thumbnail: MotionThumbnail): void {
    this.waiting.delete(thumbnail);
  }

  private schedule(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => this.drawNext());
  }

  private drawNext(): void {
    this.scheduled = false;
    const [next] = this.waiting;
    if (!next) return;
    this.waiting.delete(next);
    if (next.surface) {
      this.stage ??= new Stage(next.surface);
      next.drawStill(this.stage);
    }
    if (this.waiting.size > 0) this.schedule();
  }
}

/** Plays one thumbnail at a time. */
class LivePlayer {
  private readonly player = new Player();
  private stage: Stage | null = null;
  private playing: MotionThumbnail | null = null;
  private last = 0;

  start(thumbnail: MotionThumbnail, clip: MotionClip): void {
    if (!thumbnail.surface || this.playing === thumbnail) return;
    this.stop();
    this.stage ??= new Stage(thumbnail.surface);
    this.playing = thumbnail;
    thumbnail.prepare(this.stage);
    this.player.load([clip]);
    this.player.loop = true;
    this.player.seek(thumbnail.posterTime);
    this.player.play();
    this.last = performance.now();
    requestAnimationFrame((now) => this.frame(now, thumbnail));
  }

  stop(thumbnail: MotionThumbnail | null = this.playing): void {
    if (!thumbnail || thumbnail !== this.playing) return;
    this.playing = null;
    stills.add(thumbnail);
  }

  private frame(now: number, thumbnail: MotionThumbnail): void {
    if (this.playing !== thumbnail || !thumbnail.surface || !this.stage) return;
    this.player.advance((now - this.last) / 1000);
    this.last = now;
    this.stage.setTime(this.player.elapsed);
    this.stage.draw(thumbnail.surface);
    requestAnimationFrame((later) => this.frame(later, thumbnail));
  }
}

const stills = new StillQueue();
const live = new LivePlayer();

export class MotionThumbnail extends HTMLElement {
  static readonly observedAttributes = ["src", "figure", "poster-time", "theme"];

  surface: Surface | null = null;
  private clip: MotionClip | null = null;
  private body: Body | null = null;
  private load = 0;
  private stale = true;
  private card: Element | null = null;
  private stopWatching = () => {};
  private readonly visibility = new Visibility(this, () => this.refresh());
  private readonly resized = new ResizeObserver(() => this.redraw());
  private readonly begin = () => this.clip && live.start(this, this.clip);
  private readonly end = () => live.stop(this);

  constructor() {
    super();
    const root = this.attachShadow({ mode: "open" });
    root.adoptedStyleSheets = [viewerStyles()];
  }

  connectedCallback(): void {
    if (!hasWebGL()) return;
    this.surface = new Surface();
    this.surface.onLost = () => this.redraw();
    this.shadowRoot!.append(this.surface.element);
    this.visibility.start();
    this.resized.observe(this);
    this.stopWatching = watchMode(() => this.redraw());
    this.listen(this.closest(CARD) ?? this);
    void this.fetch();
  }

  disconnectedCallback(): void {
    this.load += 1;
    live.stop(this);
    stills.remove(this);
    this.listen(null);
    this.stopWatching();
    this.visibility.stop();
    this.resized.disconnect();
    this.surface?.dispose();
    this.surface = null;
  }

  attributeChangedCallback(name: string): void {
    if (!this.surface) return;
    if (name === "src" || name === "figure") void this.fetch();
    else this.redraw();
  }

  /** The still is there. */
  get drawn(): boolean {
    return this.clip !== null && !this.stale;
  }

  /** Seconds of the still frame; the middle where nobody chose. */
  get posterTime(): number {
    const asked = this.getAttribute("poster-time");
    const duration = this.clip?.duration ?? 0;
    return Math.min(asked === null || asked === "" ? duration / 2 : Number(asked), duration);
  }

  /** Sets a stage up for this card. */
  prepare(stage: Stage): void {
    const { surface, clip, body } = this;
    if (!surface || !clip || !body) return;
    const { clientWidth: width, clientHeight: height } = this;
    surface.resize(width, height, devicePixelRatio);
    stage.setTier(tierChooser().tier);
    stage.setFrame({ width, height, ...MARGIN });
    stage.cast([{ clip, body, role: "clay", ghost: null }]);
    stage.setMode(modeOf(this.getAttribute("theme")));
  }

  drawStill(stage: Stage): void {
    if (!this.surface || !this.clip || this.clientWidth === 0) return;
    this.stale = false;
    this.prepare(stage);
    stage.setTime(this.posterTime);
    stage.draw(this.surface);
  }

  private redraw(): void {
    this.stale = true;
    this.refresh();
  }

  private refresh(): void {
    if (!this.visibility.visible) live.stop(this);
    else if (this.stale && this.clip && this.body) stills.add(this);
  }

  private async fetch(): Promise<void> {
    const load = (this.load += 1);
    const src = this.getAttribute("src");
    if (!src) return;
    const figure = this.getAttribute("figure") || src;
    try {
      const [clip, body] = await Promise.all([loadClip(src), loadBody(figure)]);
      if (load !== this.load) return;
      this.clip = clip;
      this.body = body;
      this.redraw();
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      this.dispatchEvent(new CustomEvent("error", { detail: { message } }));
    }
  }

  private listen(card: Element | null): void {
    const change = (method: "addEventListener" | "removeEventListener") => {
      for (const name of ["pointerenter", "focusin"]) this.card?.[method](name, this.begin);
      for (const name of ["pointerleave", "focusout"]) this.card?.[method](name, this.end);
    };
    change("removeEventListener");
    this.card = card;
    change("addEventListener");
  }
}

if (!customElements.get("motion-thumbnail")) {
  customElements.define("motion-thumbnail", MotionThumbnail);
}

declare global {
  interface HTMLElementTagNameMap {
    "motion-thumbnail": MotionThumbnail;
  }
}
