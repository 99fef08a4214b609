/** The bar under the stage: play, replay, scrub and look around; with more of it in the tools. */
import { t } from "../words";
import type { Preset } from "./camera";
import { icon, make, type IconName } from "./dom";

/** What the controls need of the viewer. */
export interface Playable {
  currentTime: number;
  readonly duration: number;
  readonly paused: boolean;
  readonly frameTime: number;
  speed: number;
  loop: boolean;
  play(): void;
  pause(): void;
  replay(): void;
  seek(seconds: number): void;
  resetCamera(): void;
  view(preset: Preset): void;
  readonly preset: Preset | null;
  readonly cameraMoved: boolean;
}

export const SPEEDS = [0.25, 0.5, 0.75, 1, 1.5, 2];

const VIEWS: [Preset, string][] = [
  ["three-quarter", "Three-quarter"],
  ["front", "Front"],
  ["side", "Side"],
];

function iconButton(name: IconName, label: string, click: () => void): HTMLButtonElement {
  return make("button", { type: "button", "aria-label": label, title: label, click }, icon(name));
}

export class Controls {
  readonly bar: HTMLElement;
  readonly views: HTMLElement | null = null;
  readonly scrubber: HTMLInputElement;
  private readonly playButton: HTMLButtonElement;
  private readonly playIcon = icon("play");
  private readonly pauseIcon = icon("pause");
  private readonly look: { hint: HTMLElement; reset: HTMLElement };
  private readonly seconds = make("b");
  private readonly whole = document.createTextNode("");
  private readonly frame = make("span", { class: "frame" });
  private loopButton: HTMLButtonElement | null = null;
  private speedSelect: HTMLSelectElement | null = null;
  private shownPaused: boolean | null = null;
  private shownMoved: boolean | null = null;
  private shownFrame = -1;
  private shownDuration = -1;
  private resume = false;

  constructor(
    private readonly viewer: Playable,
    readonly full: boolean,
  ) {
    this.playButton = make("button", { type: "button", click: () => this.toggle() }, this.playIcon);
    this.scrubber = this.makeScrubber();
    this.look = {
      hint: make("span", { class: "hint" }, icon("orbit"), make("span", {}, t("Drag to look around"))),
      reset: make(
        "button",
        { type: "button", "aria-label": t("Reset the view"), title: t("Reset the view"), click: () => viewer.resetCamera() },
        icon("orbit"),
        make("span", {}, t("Reset the view")),
      ),
    };
    const look = make("div", { class: "look" }, this.look.hint, this.look.reset);
    const replay = iconButton("replay", t("Replay from the start"), () => viewer.replay());
    this.bar = make("div", { class: `controls${full ? " full" : ""}` });
    this.bar.append(this.playButton, replay, this.scrubber);
    if (full) {
      this.bar.append(...this.makeTools());
      this.views = this.makeViews();
    }
    this.bar.append(look);
    this.update();
  }

  /** Shows the viewer's state; called in every drawn frame, so it touches only what changed. */
  update(): void {
    const { viewer } = this;
    this.updatePlaying(viewer.paused);
    this.updateLook(viewer.cameraMoved);
    const frame = viewer.frameTime > 0 ? Math.round(viewer.currentTime / viewer.frameTime) : 0;
    const { duration } = viewer;
    const newDuration = duration !== this.shownDuration;
    if (newDuration) this.updateDuration(duration);
    const filled = duration > 0 ? (100 * viewer.currentTime) / duration : 0;
    this.scrubber.style.setProperty("--filled", `${filled.toFixed(2)}%`);
    this.scrubber.valueAsNumber = viewer.currentTime;
    if (frame !== this.shownFrame || newDuration) this.updateReading(frame);
    this.updateTools();
  }

  private toggle(): void {
    if (this.viewer.paused) this.viewer.play();
    else this.viewer.pause();
  }

  private updatePlaying(paused: boolean): void {
    if (paused === this.shownPaused) return;
    this.shownPaused = paused;
    const label = paused ? t("Play") : t("Pause");
    this.playButton.replaceChildren(paused ? this.playIcon : this.pauseIcon);
    this.playButton.setAttribute("aria-label", label);
    this.playButton.title = label;
  }

  private updateLook(moved: boolean): void {
    if (moved === this.shownMoved) return;
    this.shownMoved = moved;
    this.look.hint.classList.toggle("away", moved);
    this.look.reset.classList.toggle("away", !moved);
  }

  private updateDuration(duration: number): void {
    this.shownDuration = duration;
    this.scrubber.max = String(duration);
    this.whole.data = ` of ${duration.toFixed(2)} s`;
  }

  private updateReading(frame: number): void {
    const seconds = this.viewer.currentTime.toFixed(2);
    this.shownFrame = frame;
    this.seconds.textContent = `${seconds} s`;
    this.frame.textContent = ` · frame ${frame + 1}`;
    // A reader that is on the scrubber hears its value; while playing it would never stop talking.
    if (this.viewer.paused) {
      const text = t("{place} of {length} seconds", { place: seconds, length: this.shownDuration.toFixed(2) });
      this.scrubber.setAttribute("aria-valuetext", text);
    }
  }

  private updateTools(): void {
    if (!this.full) return;
    const { viewer, loopButton, speedSelect } = this;
    const looping = String(viewer.loop);
    if (loopButton && loopButton.getAttribute("aria-pressed") !== looping) {
      loopButton.setAttribute("aria-pressed", looping);
    }
    if (speedSelect && Number(speedSelect.value) !== viewer.speed) {
      speedSelect.value = String(viewer.speed);
    }
    for (const button of this.views?.children ?? []) {
      const pressed = String((button as HTMLElement).dataset["view"] === viewer.preset);
      if (button.getAttribute("aria-pressed") !== pressed) {
        button.setAttribute("aria-pressed", pressed);
      }
    }
  }

  private makeScrubber(): HTMLInputElement {
    const { viewer } = this;
    const input = () => {
      this.resume ||= !viewer.paused;
      viewer.pause();
      viewer.seek(this.scrubber.valueAsNumber);
    };
    const change = () => {
      if (this.resume) viewer.play();
      this.resume = false;
    };
    return make("input", {
      type: "range", min: "0", max: "1", step: "any", "aria-label": t("Place in the motion"), input, change,
    });
  }

  private makeTools(): HTMLElement[] {
    const { viewer } = this;
    const options = SPEEDS.map((speed) => make("option", { value: String(speed) }, `${speed}×`));
    const speed = make(
      "select",
      { "aria-label": "Speed", title: "Speed", change: () => (viewer.speed = Number(speed.value)) },
      ...options,
    );
    const loop = make(
      "button",
      { type: "button", "aria-pressed": "false", click: () => (viewer.loop = !viewer.loop) },
      icon("loop"),
      make("span", {}, "Loop"),
    );
    this.speedSelect = speed;
    this.loopButton = loop;
    const time = make("span", { class: "time" }, this.seconds, this.whole, this.frame);
    return [time, speed, loop];
  }

  private makeViews(): HTMLElement {
    const buttons = VIEWS.map(([preset, label]) =>
      make(
        "button",
        { type: "button", "data-view": preset, click: () => this.viewer.view(preset) },
        label,
      ),
    );
    return make("div", { class: "views", role: "group", "aria-label": "View" }, ...buttons);
  }
}
