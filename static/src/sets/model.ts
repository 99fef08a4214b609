// What a set is made of and how far its making is. No DOM in here.

import type { components } from "../api-types";

export type Clip = components["schemas"]["ClipView"];
export type Preset = components["schemas"]["PresetView"];
export type Planned = components["schemas"]["PlannedClip"];
export type Job = components["schemas"]["JobDetail"];
export type JobItem = components["schemas"]["JobItem"];

/** Which clips by which presets; single ones may be left out or called otherwise. */
export interface Choice {
  sources: ReadonlySet<string>;
  presets: ReadonlySet<string>;
  leftOut: ReadonlySet<string>;
  names: ReadonlyMap<string, string>;
  /** The tag by which the whole set is found again. */
  set: string;
}

export const NOTHING: Choice = {
  sources: new Set(),
  presets: new Set(),
  leftOut: new Set(),
  names: new Map(),
  set: "modified",
};

export const keyOf = ({ source, preset }: Pick<Planned, "source" | "preset">): string => `${source} ${preset}`;

/** The choice with one source or preset more, or less. */
export function toggled(choice: Choice, what: "sources" | "presets", id: string): Choice {
  const chosen = new Set(choice[what]);
  if (!chosen.delete(id)) chosen.add(id);
  return { ...choice, [what]: chosen };
}

/** The choice that comes to just this plan. */
export function choiceOf(plan: readonly Planned[]): Choice {
  const sources = new Set(plan.map(({ source }) => source));
  const presets = new Set(plan.map(({ preset }) => preset));
  const wanted = new Set(plan.map(keyOf));
  const product = [...sources].flatMap((source) => [...presets].map((preset) => keyOf({ source, preset })));
  const leftOut = new Set(product.filter((key) => !wanted.has(key)));
  return { ...NOTHING, sources, presets, leftOut, set: plan[0]?.tags.set ?? NOTHING.set };
}

/** What is to be made, as the API takes it. */
export function requested(choice: Choice, planned: readonly Planned[]) {
  return planned.map(({ source, preset, name, tags }) => ({
    source,
    preset,
    name: choice.names.get(keyOf({ source, preset }))?.trim() || name,
    tags: { ...tags, set: choice.set.trim() || NOTHING.set },
  }));
}

/** Clips that can be edited and hold every word in name or tags. */
export function matching(clips: readonly Clip[], query: string): Clip[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  return clips.filter((clip) => {
    const text = [clip.name, ...Object.values(clip.tags)].join(" ").toLowerCase();
    return clip.state === "kept" && words.every((word) => text.includes(word));
  });
}

export const isOpen = ({ state }: Pick<Job, "state">): boolean => state === "waiting" || state === "running";
export const settled = ({ done, failed }: Pick<Job, "done" | "failed">): number => done + failed;

/** "1 clip", "1 200 clips". */
export function clipCount(count: number): string {
  return `${grouped(count)} clip${count === 1 ? "" : "s"}`;
}

/** "7 of 20 made, 1 could not be made". */
export function progressWords(job: Pick<Job, "done" | "failed" | "total">): string {
  const made = `${grouped(job.done)} of ${grouped(job.total)} made`;
  return job.failed ? `${made}, ${grouped(job.failed)} could not be made` : made;
}

/** One line for how a job ended. */
export function endWords(job: Pick<Job, "state" | "done" | "failed" | "total">): string {
  const { done, failed, total } = job;
  if (job.state === "cancelled") {
    return done ? `Stopped. ${clipCount(done)} of ${grouped(total)} had been made and stay.` : "Stopped before anything was made.";
  }
  if (!failed) return total === 1 ? "The clip is made." : `All ${clipCount(total)} are made.`;
  return done ? `${clipCount(done)} made, ${grouped(failed)} could not be made.` : "None of them could be made.";
}

/** A moment at which so many clips were settled; times in seconds. */
export interface Mark {
  time: number;
  settled: number;
}

const WINDOW = 12; // seconds that the pace is taken from: the first clips wait for processes to start

/** Marks with a new one, without those that are too old to tell today's pace. */
export function marked(marks: readonly Mark[], mark: Mark): Mark[] {
  const recent = marks.filter(({ time }) => time > mark.time - WINDOW);
  return [...recent, mark];
}

/** How long it will still take, as a person says it; nothing while that cannot be told. */
export function timeLeft(marks: readonly Mark[], total: number): string {
  const [first, last] = [marks[0], marks.at(-1)];
  if (!first || !last || last.settled <= first.settled) return "";
  const pace = (last.settled - first.settled) / (last.time - first.time);
  const seconds = (total - last.settled) / pace;
  if (seconds < 10) return "a few seconds left";
  if (seconds < 90) return `about ${Math.round(seconds / 10) * 10} seconds left`;
  return `about ${Math.round(seconds / 60)} minutes left`;
}

/** 1200 as "1 200", its parts not parted at a line's end. */
const grouped = (count: number): string => String(count).replace(/\B(?=(\d{3})+$)/g, "\u202f");
