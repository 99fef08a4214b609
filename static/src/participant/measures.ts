// What is measured around an answer. Times in ms.

import type { Attention } from "./clock";
import { UNWATCHED, type Measures, type Viewing } from "./course";
import type { Store } from "./store";

/** What this page needs of <motion-viewer>. */
export interface Viewer {
  statistics: {
    plays: number;
    viewingMs: number;
    cameraMoves: number;
    droppedFrames: number;
    tier: string | number;
  };
  replay(): void;
  pause(): void;
}

export function watched(viewer: Viewer | null): Viewing {
  if (!viewer?.statistics) return UNWATCHED;
  const { plays, viewingMs, cameraMoves, droppedFrames } = viewer.statistics;
  return { plays, viewing_ms: viewingMs, camera_moves: cameraMoves, dropped_frames: droppedFrames };
}

/** Counts of before a reload, plus those since, less what the viewer had counted for the trial before. */
export function sum(before: Viewing, since: Viewing, counted: Viewing): Viewing {
  const entries = Object.keys(UNWATCHED).map((key) => {
    const name = key as keyof Viewing;
    return [name, before[name] + Math.max(0, since[name] - counted[name])];
  });
  return Object.fromEntries(entries) as Viewing;
}

/** Since this device first opened the session, by the monotonic clock within each page. */
export function elapsedSince(store: Store, now = performance.timeOrigin + performance.now()): number {
  const began = store.get<number>("began");
  if (began === null) store.set("began", now);
  return Math.max(0, now - (began ?? now));
}

export function measures(attention: Attention, elapsed: number, viewing: Viewing, viewer: Viewer | null): Measures {
  const tier = viewer?.statistics?.tier;
  return {
    rt_ms: tenth(attention.spent_ms),
    time_elapsed_ms: tenth(elapsed),
    client_time: new Date().toISOString(),
    record: {
      ...viewing,
      viewing_ms: tenth(viewing.viewing_ms),
      hidden_ms: tenth(attention.hidden_ms),
      blur_count: attention.blur_count,
      ...(tier === undefined ? {} : { tier: String(tier) }),
      viewport: { width: innerWidth, height: innerHeight, pixel_ratio: devicePixelRatio },
    },
  };
}

/** Browsers resolve 0.1 ms or less; more digits would only look exact. */
function tenth(milliseconds: number): number {
  return Math.round(milliseconds * 10) / 10;
}
