// What is measured around an answer. Times in ms.

import type { Move } from "../trials/kind";
import type { Attention } from "./clock";
import type { Measures } from "./course";
import type { Store } from "./store";

/** How the figures were watched; counts and milliseconds, summed over reloads within the step. */
export interface Viewing {
  plays: number;
  viewing_ms: number;
  camera_moves: number;
  dropped_frames: number;
}

/** The server takes no longer time, about four months. */
const LONGEST_MS = 1e10;

export const UNWATCHED: Viewing = { plays: 0, viewing_ms: 0, camera_moves: 0, dropped_frames: 0 };

/** What this page needs of <motion-viewer>. */
export interface Viewer {
  statistics: {
    plays: number;
    viewingMs: number;
    cameraMoves: number;
    droppedFrames: number;
    camera?: readonly [number, number, number, number][];
    tier: string | number;
  };
  paused: boolean;
  play(): void;
  pause(): void;
}

export function watched(viewer: Viewer | null): Viewing {
  if (!viewer?.statistics) return UNWATCHED;
  const { plays, viewingMs, cameraMoves, droppedFrames } = viewer.statistics;
  return { plays, viewing_ms: viewingMs, camera_moves: cameraMoves, dropped_frames: droppedFrames };
}

/** Counts of before a reload, plus those since. */
export function sum(before: Viewing, since: Viewing): Viewing {
  const entries = Object.keys(UNWATCHED).map((key) => {
    const name = key as keyof Viewing;
    return [name, before[name] + since[name]];
  });
  return Object.fromEntries(entries) as Viewing;
}

/** Since this device first opened the session, by the monotonic clock within each page. */
export function elapsedSince(store: Store, now = performance.timeOrigin + performance.now()): number {
  const began = store.get<number>("began");
  if (began === null) store.set("began", now);
  return Math.max(0, now - (began ?? now));
}

/** Everything that a step's record holds, before it is made ready for sending. */
export interface Watched {
  attention: Attention;
  elapsed: number;
  viewer: Viewer | null;
  viewing: Viewing;
  /** Of several figures, how long each was in view and moving. */
  figures: readonly number[];
  /** The positions that sliders showed before they were touched. */
  start: Record<string, number>;
  /** The way that sliders went, of a kind that keeps it. */
  path?: readonly Move[];
}

export function measures({ attention, elapsed, viewer, viewing, figures, start, path = [] }: Watched): Measures {
  return {
    rt_ms: tenth(attention.spent_ms),
    time_elapsed_ms: tenth(elapsed),
    client_time: new Date().toISOString(),
    record: {
      // A page without figures has no plays and no tier: nothing was there to be watched.
      ...(viewer ? { ...viewing, viewing_ms: tenth(viewing.viewing_ms), tier: String(viewer.statistics?.tier) } : {}),
      ...(viewer?.statistics?.camera?.length ? { camera: [...viewer.statistics.camera] } : {}),
      ...(figures.length > 1 ? { figure_ms: figures.map(tenth) } : {}),
      ...(Object.keys(start).length ? { start } : {}),
      ...(path.length ? { path: path.map(([ms, slider, position]): [number, string, number] => [ms, slider, position]) } : {}),
      hidden_ms: tenth(attention.hidden_ms),
      blur_count: attention.blur_count,
      viewport: { width: innerWidth, height: innerHeight, pixel_ratio: devicePixelRatio },
    },
  };
}

/** Browsers resolve 0.1 ms or less; more digits would only look exact. A clock that was years off costs no answer. */
function tenth(milliseconds: number): number {
  return Math.min(LONGEST_MS, Math.round(milliseconds * 10) / 10);
}
