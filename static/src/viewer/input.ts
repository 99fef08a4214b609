/** Looking around with mouse, pen or finger, and every control from the keyboard. */
import type { Playable } from "./controls";
import { SPEEDS } from "./controls";

export interface Turnable {
  orbit(azimuth: number, elevation: number): void;
  zoomBy(factor: number): void;
  /** A drag or a key press that turned the view is over. */
  turned(): unknown;
}

const DEGREES_PER_PIXEL = 0.4;
const KEY_DEGREES = 10;
/** Less than this is a trembling finger, not a drag. */
const DRAG_PIXELS = 3;

export function listenToPointer(stage: HTMLElement, target: Turnable, zooms: () => boolean): void {
  let last: { id: number; x: number; y: number; moved: number } | null = null;
  stage.addEventListener("pointerdown", (event) => {
    if (!event.isPrimary || event.button !== 0) return;
    last = { id: event.pointerId, x: event.clientX, y: event.clientY, moved: 0 };
    stage.setPointerCapture(event.pointerId);
  });
  stage.addEventListener("pointermove", (event) => {
    if (!last || event.pointerId !== last.id) return;
    const across = event.clientX - last.x;
    const down = event.clientY - last.y;
    last.moved += Math.abs(across) + Math.abs(down);
    last.x = event.clientX;
    last.y = event.clientY;
    if (last.moved > DRAG_PIXELS) {
      target.orbit(-across * DEGREES_PER_PIXEL, down * DEGREES_PER_PIXEL);
    }
  });
  const release = () => {
    if (last && last.moved > DRAG_PIXELS) target.turned();
    last = null;
  };
  stage.addEventListener("pointerup", release);
  stage.addEventListener("pointercancel", release);
  stage.addEventListener(
    "wheel",
    (event) => {
      // Pinching a touchpad arrives as a wheel with Ctrl; a plain wheel scrolls the page.
      if (!event.ctrlKey || !zooms()) return;
      event.preventDefault();
      target.zoomBy(Math.exp(-event.deltaY * 0.01));
    },
    { passive: false },
  );
}

/**
 * Handles a key if it means something here. Returns whether it did.
 * Speed and loop belong to the tools (`full`): a participant's stimulus keeps its pace.
 */
export function handleKey(
  event: KeyboardEvent,
  viewer: Playable,
  target: Turnable,
  full: boolean,
): boolean {
  if (event.ctrlKey || event.metaKey) return false;
  if (event.altKey) return orbitByKey(event.key, target);
  const step = viewer.frameTime * (event.shiftKey ? 10 : 1);
  const actions: Record<string, () => void> = {
    " ": () => (viewer.paused ? viewer.play() : viewer.pause()),
    r: () => viewer.replay(),
    ArrowLeft: () => stepTo(viewer, viewer.currentTime - step),
    ArrowRight: () => stepTo(viewer, viewer.currentTime + step),
    Home: () => stepTo(viewer, 0),
    End: () => stepTo(viewer, viewer.duration),
    "0": () => viewer.resetCamera(),
    ...(full ? toolKeys(viewer, target) : {}),
  };
  const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  action?.();
  return action !== undefined;
}

function toolKeys(viewer: Playable, target: Turnable): Record<string, () => void> {
  return {
    l: () => (viewer.loop = !viewer.loop),
    "[": () => changeSpeed(viewer, -1),
    "]": () => changeSpeed(viewer, 1),
    "+": () => target.zoomBy(1.1),
    "-": () => target.zoomBy(1 / 1.1),
  };
}

function orbitByKey(key: string, target: Turnable): boolean {
  const turns: Record<string, [number, number]> = {
    ArrowLeft: [-KEY_DEGREES, 0],
    ArrowRight: [KEY_DEGREES, 0],
    ArrowUp: [0, KEY_DEGREES],
    ArrowDown: [0, -KEY_DEGREES],
  };
  const turn = turns[key];
  if (!turn) return false;
  target.orbit(...turn);
  target.turned();
  return true;
}

function stepTo(viewer: Playable, seconds: number): void {
  viewer.pause();
  viewer.seek(seconds);
}

function changeSpeed(viewer: Playable, by: number): void {
  const nearest = SPEEDS.findIndex((speed) => speed >= viewer.speed);
  const index = Math.min(Math.max(nearest + by, 0), SPEEDS.length - 1);
  viewer.speed = SPEEDS[index]!;
}
