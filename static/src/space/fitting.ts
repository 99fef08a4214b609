// Clips as the examples of a space have to be: on one skeleton, and one cycle each where the others are cycles.
import { freeName } from "../studio/names";
import type { Steps } from "../studio/recipe";
import * as studio from "../studio/server";

type Shape = Pick<studio.Clip, "id" | "skeleton_hash" | "cyclic">;

/** What has to be done to a clip before it can be mixed with this one: cut where it was recorded, then moved. */
export function fittingSteps(clip: Shape, like: Shape): Steps {
  return [
    ...(like.cyclic && !clip.cyclic ? [{ operation: "cycle@1", parameters: {} }] : []),
    ...(clip.skeleton_hash === like.skeleton_hash ? [] : [{ operation: "retarget@1", parameters: { clip: like.id } }]),
  ];
}

/** "one cycle of it, on the examples’ skeleton" */
export function fittingWords(steps: Steps): string {
  const words: Record<string, string> = { "retarget@1": "on the examples’ skeleton", "cycle@1": "one cycle of it" };
  return steps.map(({ operation }) => words[operation]).join(", ");
}

/** A copy that fits, kept in the library; the clip itself where it fits already. */
export async function fitted(clip: studio.Clip, like: Shape, taken: readonly string[]): Promise<studio.Clip> {
  const operations = fittingSteps(clip, like);
  if (!operations.length) return clip;
  return studio.save({ source: clip.id, operations }, freeName(`${clip.name} fitted`, taken));
}
