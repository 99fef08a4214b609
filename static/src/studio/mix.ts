// A mix on the stage: of how many motions, and in which authoring space it was made, if that is known.
import { spaces, type ListedSpace } from "../space/server";
import { mixedOf } from "./recipe";
import { stepsOf, type ClipDetail } from "./server";

export interface Mix {
  examples: number;
  space: ListedSpace | null;
}

/** Null for a motion that is no mix. The space only leads back: where it cannot be found, nothing is lost. */
export async function mixOf({ provenance }: ClipDetail, space: string | null): Promise<Mix | null> {
  const examples = mixedOf(stepsOf(provenance?.recipe ?? []));
  if (!examples) return null;
  const known = space ? await spaces().catch(() => []) : [];
  return { examples: examples.length, space: known.find(({ id }) => id === space) ?? null };
}
