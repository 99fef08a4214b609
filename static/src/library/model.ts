// What the library shows of a clip, and how it finds one. No DOM in here.

import type { components } from "../api-types";

export type Clip = components["schemas"]["ClipView"];
export type Note = components["schemas"]["Note"];
export type Report = components["schemas"]["ImportReport"];
export type Imported = components["schemas"]["Imported"];

export interface Filter {
  id: string;
  label: string;
  count: number;
}

/** The words that part the library, in the order in which they stand. */
const FAMILIES: [id: string, label: string, has: (clip: Clip) => boolean][] = [
  ["styles", "Styles", (clip) => clip.tags.set === "A"],
  ["emotions", "Emotions", (clip) => clip.tags.set === "B"],
  ["acted", "Acted", (clip) => clip.tags.set === "acted"],
  ["gestures", "Gestures", (clip) => clip.tags.set === "gesture"],
  ["imported", "Imported", (clip) => clip.source === "imported"],
  ["edited", "Edited", (clip) => clip.source === "edited"],
];

/** "All" and every family that has a clip, each with its count. */
export function filtersOf(clips: readonly Clip[]): Filter[] {
  const families = FAMILIES.map(([id, label, has]) => ({ id, label, count: clips.filter(has).length }));
  return [{ id: "", label: "All", count: clips.length }, ...families.filter(({ count }) => count > 0)];
}

/** The clips of a family whose name or tags hold every word of the query; those to confirm come first. */
export function find(clips: readonly Clip[], family: string, query: string): Clip[] {
  const has = FAMILIES.find(([id]) => id === family)?.[2] ?? (() => true);
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  const found = clips.filter((clip) => {
    const text = [clip.name, ...Object.values(clip.tags)].join(" ").toLowerCase();
    return has(clip) && words.every((word) => text.includes(word));
  });
  return found.sort((a, b) => Number(b.state === "to_confirm") - Number(a.state === "to_confirm"));
}

/** The line under a clip's name: what it shows and how long. */
export function caption(clip: Clip): string {
  const { emotion, style, speed, body } = clip.tags;
  const actor = clip.tags.set === "acted" ? body : undefined;
  const edited = clip.source === "edited" ? "edited" : undefined;
  const shown = [emotion ?? style, speed === "normal" ? undefined : speed, actor, edited];
  return [...shown.filter(Boolean), seconds(clip.duration)].join(" · ");
}

export const seconds = (duration: number): string => `${duration.toFixed(1)} s`;
export const framesPerSecond = (frameTime: number): string =>
  `${String(Math.round(10 / frameTime) / 10)} fps`;

/** "1 repair", "3 repairs". */
export const counted = (count: number, word: string): string =>
  `${count} ${word}${count === 1 ? "" : "s"}`;

/** "left_upper_arm" as a person says it. */
export const roleWords = (role: string): string => role.replaceAll("_", " ");
