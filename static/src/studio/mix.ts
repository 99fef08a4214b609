// A mix on the stage: of how many motions, and in which authoring space it was made, if that is known.
import { api } from "../api";
import type { components } from "../api-types";
import { mixedOf } from "./recipe";
import { stepsOf, type ClipDetail } from "./server";

type SpaceLine = components["schemas"]["SpaceLine"];

export interface Mix {
  examples: number;
  space: SpaceLine | null;
}

/** Null for a motion that is no mix. The space only leads back: where it cannot be found, nothing is lost. */
export async function mixOf({ provenance }: ClipDetail, space: string | null): Promise<Mix | null> {
  const examples = mixedOf(stepsOf(provenance?.recipe ?? []));
  if (!examples) return null;
  const known = space ? await api.get<{ spaces: SpaceLine[] }>("/api/v1/spaces").catch(() => null) : null;
  return { examples: examples.length, space: known?.spaces.find(({ id }) => id === space) ?? null };
}
