// <time-strip>: when things happen in a motion. Transport, ruler, foot contacts, marks of the checks.
//
// It brings play, replay, speed and loop: with `viewer` it shows and drives that viewer by itself. Without one, `duration`, `frames` and `time` are set
// from outside. `contacts` and `findings` always are; `findings` null = not known yet.
// Events: `seek` {time}, `finding` {finding}, `loop` {loop}. The page loads styles/time-strip.css.
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { guard } from "lit/directives/guard.js";
import { SPEEDS } from "../viewer/controls";
import { icon } from "../viewer/dom";
import type { MotionViewer } from "../viewer/element";
import { timeWords, type Finding } from "./checks";
import { follow } from "./strip/drag";
import { marks, type Mark } from "./strip/marks";
import { frameOf, keyed, onFrame, placeOf, rangeOf, ticks, type Range } from "./strip/scale";

/** Seconds in which each foot stands. */
export interface Contacts {
  left: [number, number][];
  right: [number, number][];
}

const HEARD = ["frame", "motion", "ready"] as const;
const SIDES = ["left", "right"] as const;

@customElement("time-strip")
export class TimeStrip extends LitElement {
  @property({ type: Number }) duration = 0;
  @property({ type: Number }) frames = 0;
  @property({ type: Number }) time = 0;
  @property({ attribute: false }) contacts: Contacts = { left: [], right: [] };
  @property({ attribute: false }) findings: readonly Finding[] | null = null;
  /** Play only this, again and again. */
  @property({ attribute: false }) loop: Range | null = null;
  @property({ attribute: false }) viewer: MotionViewer | null = null;
  @state() private paused = true;
  @state() private width = 0;
  @query(".strip-tracks") private tracks!: HTMLElement;
  @query("[role=slider]") private slider!: HTMLElement;
  private readonly icons = { start: icon("start"), play: icon("play"), pause: icon("pause"), replay: icon("replay"), loop: icon("loop") };
  private readonly resized = new ResizeObserver(() => (this.width = this.tracks.clientWidth));

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.resized.disconnect();
    this.leave(this.viewer);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    if (this.hasUpdated) this.resized.observe(this.tracks);
    this.join(this.viewer);
  }

  protected override firstUpdated(): void {
    this.resized.observe(this.tracks);
  }

  protected override willUpdate(changed: PropertyValues): void {
    const before = (changed as Map<string, unknown>).get("viewer");
    if (!(changed as Map<string, unknown>).has("viewer")) return;
    this.leave(before as MotionViewer | null);
    this.join(this.viewer);
  }

  private join(viewer: MotionViewer | null): void {
    for (const name of HEARD) viewer?.addEventListener(name, this.hear);
    viewer?.addEventListener("ended", this.again);
    if (viewer) this.hear();
  }

  private leave(viewer: MotionViewer | null | undefined): void {
    for (const name of HEARD) viewer?.removeEventListener(name, this.hear);
    viewer?.removeEventListener("ended", this.again);
  }

  private readonly hear = (): void => {
    const { viewer, loop } = this;
    if (!viewer) return;
    this.duration = viewer.duration;
    this.frames = viewer.frameTime > 0 ? Math.round(viewer.duration / viewer.frameTime) + 1 : 0;
    this.time = viewer.currentTime;
    this.paused = viewer.paused;
    const outside = loop && (this.time < loop.start || this.time >= loop.end);
    if (outside && !this.paused) viewer.seek(loop.start);
  };

  /** The motion has ended within the loop. */
  private readonly again = (): void => {
    if (!this.loop || !this.viewer) return;
    this.viewer.seek(this.loop.start);
    this.viewer.play();
  };

  private tell(name: string, detail: unknown): void {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true }));
  }

  private seek(time: number): void {
    this.time = time;
    this.viewer?.seek(time);
    this.tell("seek", { time });
  }

  private step(time: number): void {
    this.viewer?.pause();
    this.seek(time);
  }

  private toggle(): void {
    if (this.paused) this.viewer?.play();
    else this.viewer?.pause();
  }

  private setLoop(loop: Range | null): void {
    this.loop = loop;
    this.tell("loop", { loop });
  }

  private loopBetween(start: number, end: number): void {
    this.setLoop(rangeOf(start, end, this.duration / 100));
  }

  private open(mark: Mark): void {
    this.step(onFrame(mark.worst.start, this.duration, this.frames));
    this.tell("finding", { finding: mark.worst });
  }

  private onPointer(event: PointerEvent): void {
    const target = event.target as Element;
    if (!event.isPrimary || event.button !== 0 || target.closest("button") || !this.duration) return;
    event.preventDefault(); // no selection of text
    this.slider.focus({ preventScroll: true });
    if (target.closest(".strip-ruler")) this.dragLoop(event);
    else this.dragTime(event);
  }

  private dragTime(event: PointerEvent): void {
    const playing = !this.paused;
    follow(event, this.tracks, {
      move: (share) => this.step(onFrame(share * this.duration, this.duration, this.frames)),
      end: () => playing && this.viewer?.play(),
    });
  }

  /** A drag along the ruler chooses what is repeated; a click there goes to the moment. */
  private dragLoop(event: PointerEvent): void {
    const { loop } = this;
    let from: number | null = null;
    let to = 0;
    follow(event, this.tracks, {
      move: (share) => {
        to = share * this.duration;
        from ??= to;
        this.loop = rangeOf(from, to, this.duration / 100) ?? loop;
      },
      end: (moved) => {
        if (!moved) this.seek(onFrame(to, this.duration, this.frames));
        this.setLoop(this.loop);
      },
    });
  }

  private onKey(event: KeyboardEvent): void {
    if (event.altKey || event.ctrlKey || event.metaKey || !this.duration) return;
    const time = keyed(event.key, event.shiftKey, this);
    if (time !== undefined) this.step(time);
    else if (event.key === " ") this.toggle();
    else if (event.key === "i") this.loopBetween(this.time, this.loop?.end ?? this.duration);
    else if (event.key === "o") this.loopBetween(this.loop?.start ?? 0, this.time);
    else if (event.key === "Escape" && this.loop) this.setLoop(null);
    else return;
    event.preventDefault();
  }

  protected override render(): TemplateResult {
    return html`<div class="strip-head">${this.transport()}${this.reading()}${this.tools()}</div>
      <div class="strip-rows">
        <div class="strip-names" aria-hidden="true"><span>Left foot</span><span>Right foot</span><span>Check</span></div>
        <div class="strip-tracks" @pointerdown=${this.onPointer}>${this.ruler()}${this.feet()}${this.checks()}${this.now()}</div>
      </div>`;
  }

  private transport(): TemplateResult {
    const { icons, paused } = this;
    const name = paused ? "Play" : "Pause";
    const button = (words: string, picture: SVGElement, click: () => void) =>
      html`<button type="button" aria-label=${words} title=${words} @click=${click}>${picture}</button>`;
    return html`<div class="strip-transport">
      ${button("To the start", icons.start, () => this.step(this.loop?.start ?? 0))}
      ${button(name, paused ? icons.play : icons.pause, () => this.toggle())}
      ${button("Replay from the start", icons.replay, () => this.replay())}
    </div>`;
  }

  private replay(): void {
    if (this.loop) this.seek(this.loop.start);
    else this.seek(0);
    this.viewer?.play();
  }

  private reading(): TemplateResult {
    const frame = frameOf(this.time, this.duration, this.frames) + 1;
    return html`<p class="strip-reading"><b>${this.time.toFixed(2)} s</b> of ${this.duration.toFixed(2)} s
      <span class="frame">· frame ${frame}</span></p>`;
  }

  private tools(): TemplateResult | typeof nothing {
    const { viewer, loop, icons } = this;
    if (!viewer) return nothing;
    const words = loop ? `Loop ${loop.start.toFixed(1)}–${loop.end.toFixed(1)} s` : "Loop";
    const toggleLoop = () => {
      if (loop) return this.setLoop(null);
      viewer.loop = !viewer.loop;
      this.requestUpdate();
    };
    return html`<div class="strip-tools">
      <select aria-label="Speed" title="Speed" @change=${(event: Event) => (viewer.speed = Number((event.target as HTMLSelectElement).value))}>
        ${SPEEDS.map((speed) => html`<option value=${speed} ?selected=${speed === viewer.speed}>${speed}×</option>`)}
      </select>
      <button type="button" aria-label=${words} aria-pressed=${Boolean(loop) || viewer.loop} title="Drag along the ruler, or press I and O, to repeat a part"
        @click=${toggleLoop}>${icons.loop}<span>${words}</span></button>
    </div>`;
  }

  private ruler(): TemplateResult {
    const { duration, width, loop } = this;
    return html`<div class="strip-ruler">
      ${loop ? html`<i class="strip-range" .style=${span(loop.start, loop.end, duration)}></i>` : nothing}
      ${guard([duration, width], () =>
        ticks(duration, width).map(({ time, label }) =>
          html`<span class=${label ? "strip-tick" : "strip-tick short"} .style=${`left: ${placeOf(time, duration)}%`}>${label ?? nothing}</span>`))}
    </div>`;
  }

  private feet(): unknown {
    const { contacts, duration } = this;
    return guard([contacts, duration], () =>
      SIDES.map((side) => {
        const stands = contacts[side].map(([start, end]) => `${start.toFixed(1)} to ${end.toFixed(1)}`);
        const words = `The ${side} foot stands ${stands.length ? `from ${stands.join(", ")} seconds` : "nowhere"}`;
        return html`<div class="strip-foot" role="img" aria-label=${words}>
          ${contacts[side].map(([start, end]) => html`<i .style=${span(start, end, duration)}></i>`)}
        </div>`;
      }));
  }

  private checks(): unknown {
    const { findings, duration, width } = this;
    return guard([findings, duration, width], () => html`<div class="strip-checks">
      ${findings?.length === 0 ? html`<span class="strip-fine">nothing found</span>` : nothing}
      ${(findings ?? []).map(({ start, end }) => html`<i .style=${span(start, end, duration)}></i>`)}
      ${marks(findings ?? [], duration, width).map((mark) => this.mark(mark))}
    </div>`);
  }

  private mark(mark: Mark): TemplateResult {
    const { worst, words, labelled, before } = mark;
    const full = `${words}, ${timeWords(worst)}`;
    return html`<button type="button" class=${before ? "strip-mark before" : "strip-mark"} aria-label=${full} title=${full}
      .style=${`left: ${placeOf(mark.findings[0]!.start, this.duration)}%`} @click=${() => this.open(mark)}>
      <svg viewBox="0 0 16 16" aria-hidden="true"><path d="M8 1.5 15.2 14.5H.8z"></path><path class="sign" d="M8 6v4M8 12.2v.1"></path></svg>
      ${labelled ? html`<span>${words}</span>` : nothing}</button>`;
  }

  private now(): TemplateResult {
    const { time, duration } = this;
    const frame = frameOf(time, duration, this.frames) + 1;
    return html`<div class="strip-now" role="slider" tabindex="0" aria-label="Current time" aria-valuemin="0"
      aria-valuemax=${duration.toFixed(2)} aria-valuenow=${time.toFixed(2)}
      aria-valuetext=${`${time.toFixed(2)} of ${duration.toFixed(2)} seconds, frame ${frame}`}
      .style=${`left: ${placeOf(time, duration)}%`} @keydown=${this.onKey}></div>`;
  }
}

/** A stretch of time as a style. */
function span(start: number, end: number, duration: number): string {
  const left = placeOf(start, duration);
  return `left: ${left}%; width: ${placeOf(end, duration) - left}%`;
}

declare global {
  interface HTMLElementTagNameMap {
    "time-strip": TimeStrip;
  }
}
