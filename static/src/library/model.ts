// What the library shows of a clip, and how it finds one. No DOM in here.

export interface Clip {
  id: string;
  name: string;
  source: "sample" | "imported";
  state: "kept" | "to_confirm" | "retired";
  tags: Record<string, string>;
  frames: number;
  frame_time: number;
  duration: number;
  cyclic: boolean;
  stature: number;
  poster_time: number;
  glb_url: string;
  /** None where the skeleton lacks a human's parts. */
  figure_url: string | null;
  page_url: string;
}

export interface Note {
  text: string;
  line?: number | null;
  where?: string | null;
}

export interface Report {
  repairs: Note[];
  questions: Note[];
  /** Metres per unit of the file. */
  unit: number;
  unit_name: string;
  up_axis: string;
  stature: number;
  roles: Record<string, string>;
  missing_roles: string[];
  joint_names: string[];
  frames: number;
  frame_time: number;
  duration: number;
}

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
  ["imported", "Imported", (clip) => clip.source === "imported"],
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
  const shown = [emotion ?? style, speed === "normal" ? undefined : speed, actor];
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
