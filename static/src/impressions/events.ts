// What the parts of the page ask of it. All bubble.
import type { Limits } from "./model";

interface Asked {
  /** A threshold or the cut is being moved. */
  limits: Partial<Limits>;
  /** A cluster has a name, or (empty) none of its own any more. */
  rename: { key: string; title: string };
  /** A pair goes to the cluster of another pair, or (null) back to where the tree puts it. */
  move: { pair: string; to: string | null };
}

export function ask<K extends keyof Asked>(from: HTMLElement, what: K, detail: Asked[K]): void {
  from.dispatchEvent(new CustomEvent(what, { detail, bubbles: true }));
}

export type Ask<K extends keyof Asked> = CustomEvent<Asked[K]>;
