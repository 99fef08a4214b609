// Edits that were not saved stay in this browser until they are, or are thrown away.
import type { Steps } from "./recipe";

export interface Draft {
  steps: Steps;
  name: string;
  preset: string | null;
}

const place = (clip: string): string => `manner-studio-draft:${clip}`;

export function keepDraft(clip: string, draft: Draft, storage?: Storage): void {
  try {
    (storage ?? localStorage).setItem(place(clip), JSON.stringify(draft));
  } catch {
    // A full or forbidden store: the edits live on as long as the page does.
  }
}

export function dropDraft(clip: string, storage?: Storage): void {
  try {
    (storage ?? localStorage).removeItem(place(clip));
  } catch {
    // A browser that forbids the store has kept nothing.
  }
}

/** The draft of a clip; null where there is none, or none that can be read. */
export function findDraft(clip: string, storage?: Storage): Draft | null {
  try {
    const found = JSON.parse((storage ?? localStorage).getItem(place(clip)) ?? "null") as Partial<Draft> | null;
    if (!found || !Array.isArray(found.steps) || typeof found.name !== "string") return null;
    return { steps: found.steps, name: found.name, preset: found.preset ?? null };
  } catch {
    return null;
  }
}
