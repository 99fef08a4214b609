// Bodies that clips share, and a motion put onto another one. No DOM in here.
import { api } from "../api";
import type { components } from "../api-types";
import type { Steps } from "../studio/recipe";
import type { Clip } from "./model";

type Schemas = components["schemas"];
export type Body = Schemas["SkeletonView"];
export type Fit = Schemas["Retargeting"];
export type ClipDetail = Schemas["ClipDetail"];
export type Cut = "none" | "found" | "whole";

export const CUTS: readonly [cut: Cut, words: string, hint: string][] = [
  ["none", "The whole motion", "as long as it is"],
  ["found", "One cycle of it", "for a walk or run: its most even stride, made to go round"],
  ["whole", "All of it, as one cycle", "where it is one stride already"],
];

export const clipOf = (id: string) => api.get<ClipDetail>(`/api/v1/clips/${id}?motion=false`);
export const bodies = async () => (await api.get<Schemas["SkeletonList"]>("/api/v1/skeletons")).skeletons;
export const keep = (id: string) => api.post<ClipDetail>(`/api/v1/clips/${id}/confirm`);
export const fitOf = (clip: Clip, onto: string, cycle: Cut) =>
  api.get<Fit>(`/api/v1/clips/${clip.id}/retargeting`, { query: { onto, cycle } });
export const preview = (clip: Clip, onto: string, cut: Cut) => tried(clip, recipe(clip, onto, cut));
/** The same stretch of the motion on the body that performed it, so that both begin at one instant. */
export const onItsOwn = (clip: Clip, cut: Cut) => (cut === "none" ? api.bytes(clip.glb_url) : tried(clip, cycle(clip, cut)));
const tried = (clip: Clip, operations: Steps) => api.bytesFor("/api/v1/clips/preview", { source: clip.id, operations });
export const make = (clip: Clip, onto: string, cut: Cut, name: string) =>
  api.post<ClipDetail>("/api/v1/clips", { source: clip.id, operations: recipe(clip, onto, cut), name });

/** The steps that put a clip onto the body of another; a cycle is cut on the body that it was performed by. */
export function recipe(clip: Pick<Clip, "duration">, onto: string, cut: Cut): Steps {
  return [...cycle(clip, cut), { operation: "retarget@1", parameters: { clip: onto } }];
}

function cycle({ duration }: Pick<Clip, "duration">, cut: Cut): Steps {
  if (cut === "none") return [];
  return [{ operation: "cycle@1", parameters: cut === "whole" ? { start: 0, end: duration } : {} }];
}

/** Who else moves a clip's skeleton, and why that matters. */
export function sharedBy(clip: Clip, all: readonly Body[]): string {
  const others = (all.find(({ id }) => id === clip.skeleton_hash)?.clips ?? 0) - (clip.state === "kept" ? 1 : 0);
  const own = others < 1
    ? "This clip moves a skeleton of its own."
    : `${others} other ${others === 1 ? "clip moves" : "clips move"} the same skeleton as this one.`;
  return `${own} Clips of one authoring space must share one.`;
}

/** The bodies that a clip can be put onto; of that named by `asked` it is that clip which shows it. */
export function others(clip: Clip, all: readonly Body[], asked?: Clip): Body[] {
  const offered = all.filter(({ id }) => id !== clip.skeleton_hash);
  if (!asked) return offered;
  const first = offered.filter(({ id }) => id === asked.skeleton_hash).map((body) => ({ ...body, example: asked }));
  return [...first, ...offered.filter(({ id }) => id !== asked.skeleton_hash)];
}

export const bodyWords = ({ clips, example }: Body): string =>
  `${metres(example.stature)} tall · ${clips} ${clips === 1 ? "clip" : "clips"}`;

/** What the error is made of: word and value. */
export function lines(clip: Clip, { example }: Body, fit: Fit): [word: string, value: string][] {
  const { resting } = fit;
  return [
    ["Limbs turn", `${degrees(fit.greatest_direction)} at most; mean ${degrees(fit.mean_direction)}`],
    ["Feet slide", `${millimetres(fit.slip)} while they stand`],
    ["Soles", `${millimetres(fit.sole_height)} off the floor in the mean`],
    ["Stature", `${metres(clip.stature)}, then ${metres(example.stature)}`],
    ...(resting.length ? [["At rest", named(resting)] as [string, string]] : []),
  ];
}

const NAMED = 3;
const named = (joints: readonly string[]): string =>
  joints.slice(0, NAMED).join(", ") + (joints.length > NAMED ? ` and ${joints.length - NAMED} more` : "");
const metres = (length: number): string => `${length.toFixed(2)} m`;
const millimetres = (length: number): string => `${least(1000 * length, length < 0.01 ? 1 : 0)} mm`;
const degrees = (angle: number): string => `${least((180 / Math.PI) * angle, 1)}°`;
/** A number with so many decimals, but none that would look like nothing at all. */
const least = (value: number, decimals: number): string =>
  value > 0 && value < 10 ** -decimals ? `less than ${10 ** -decimals}` : value.toFixed(decimals);
