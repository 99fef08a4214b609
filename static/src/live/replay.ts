// One participant's way, step by step: each trial's figures on the stage, from where they were seen.
import type { components } from "../api-types";
import type { MotionViewer } from "../viewer/motion_viewer";

type Step = components["schemas"]["ReplayStep"];
/** [ms since the figures came, azimuth°, elevation°, zoom] */
type Sight = [number, number, number, number];

export class Replay {
  private chosen = -1;
  private playing = 0;

  constructor(
    private readonly steps: readonly Step[],
    private readonly list: HTMLElement,
    private readonly stage: HTMLElement,
  ) {
    list.addEventListener("click", (event) => {
      const button = (event.target as Element).closest<HTMLElement>("[data-step]");
      if (button) this.show(Number(button.dataset.step));
    });
    const first = steps.findIndex(({ figures }) => figures.length > 0);
    if (steps.length) this.show(Math.max(first, 0));
  }

  show(index: number): void {
    const step = this.steps[index];
    if (!step || index === this.chosen) return;
    this.chosen = index;
    cancelAnimationFrame(this.playing);
    for (const button of this.list.querySelectorAll<HTMLElement>("[data-step]")) {
      button.setAttribute("aria-pressed", String(Number(button.dataset.step) === index));
    }
    this.stage.replaceChildren(...(step.figures.length ? this.figures(step) : [told("A page without figures")]));
  }

  private figures(step: Step): HTMLElement[] {
    const viewer = document.createElement("motion-viewer");
    viewer.setAttribute("controls", "simple");
    viewer.setAttribute("autoplay", "");
    viewer.setAttribute("loop", "auto");
    viewer.setAttribute("arrange", "beside");
    viewer.setAttribute("label", step.figures.map(({ name }) => name).join(", "));
    viewer.append(...cast(step));
    const camera = step.camera as Sight[];
    if (camera.length) viewer.addEventListener("ready", () => this.follow(viewer, camera), { once: true });
    return [viewer, viewed(step), ...(camera.length ? [this.again(viewer, camera)] : [])];
  }

  /** Turn the view as it was turned then, at the pace of then. */
  private follow(viewer: MotionViewer, camera: readonly Sight[]): void {
    cancelAnimationFrame(this.playing);
    const began = performance.now();
    const turn = (now: number) => {
      const passed = now - began;
      const [, azimuth, elevation, zoom] = sightAt(camera, passed);
      viewer.look(azimuth, elevation, zoom);
      if (viewer.isConnected && passed < camera.at(-1)![0]) this.playing = requestAnimationFrame(turn);
    };
    this.playing = requestAnimationFrame(turn);
  }

  private again(viewer: MotionViewer, camera: readonly Sight[]): HTMLElement {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "button";
    button.textContent = "Turn the view as they did";
    button.addEventListener("click", () => this.follow(viewer, camera));
    const place = document.createElement("p");
    place.append(button);
    return place;
  }
}

/** The view at a moment, straight between the recorded ones. */
export function sightAt(camera: readonly Sight[], ms: number): Sight {
  const next = camera.findIndex(([at]) => at >= ms);
  if (next === -1) return camera.at(-1)!;
  const after = camera[next]!;
  const before = camera[next - 1];
  if (!before) return after;
  const share = (ms - before[0]) / (after[0] - before[0] || 1);
  // The shorter way around: 179° and −179° are neighbours.
  const turn = ((((after[1] - before[1] + 180) % 360) + 360) % 360) - 180;
  return [
    ms,
    before[1] + share * turn,
    before[2] + share * (after[2] - before[2]),
    before[3] + share * (after[3] - before[3]),
  ];
}

function cast(step: Step): HTMLElement[] {
  const everyone = [
    ...(step.reference ? [{ ...step.reference, as: "reference" }] : []),
    ...step.figures.map((figure) => ({ ...figure, as: step.reference ? "judged" : "" })),
  ];
  return everyone.flatMap(({ glb_url, figure_url, name, as }) => {
    if (!glb_url) return [];
    const figure = document.createElement("motion-figure");
    figure.setAttribute("src", glb_url);
    if (figure_url) figure.setAttribute("figure", figure_url);
    if (as) figure.setAttribute("as", as);
    if (everyone.length > 1) figure.setAttribute("label", name);
    return [figure];
  });
}

function viewed(step: Step): HTMLElement {
  const list = document.createElement("dl");
  list.className = "viewed";
  for (const { label, value } of step.viewed) {
    const pair = document.createElement("div");
    const term = document.createElement("dt");
    const number = document.createElement("dd");
    term.textContent = label;
    number.textContent = value;
    pair.append(term, number);
    list.append(pair);
  }
  return list;
}

function told(text: string): HTMLElement {
  const place = document.createElement("p");
  place.className = "page-told";
  place.textContent = text;
  return place;
}
