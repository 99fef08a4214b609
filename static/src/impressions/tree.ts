// Ward's tree as lines. Heights go from the leaves (0) to the root; places count leaves from the first row.
import type { Merge } from "./model";

export interface Branch {
  height: number;
  /** Where its two branches hang: their middles and heights. */
  ends: [End, End];
  /** The leaves below it, by place. */
  places: number[];
}

interface End {
  at: number;
  height: number;
  places: number[];
}

/**
 * Every merge with its place in the drawing, the lowest first.
 *
 * @param order for each leaf, by its number in the merges, the row in which it stands.
 */
export function branches(merges: readonly Merge[], order: readonly number[]): Branch[] {
  const ends: End[] = order.map((place) => ({ at: place, height: 0, places: [place] }));
  return merges.map(({ left, right, height }) => {
    const pair = [ends[left], ends[right]] as [End, End];
    const places = [...pair[0].places, ...pair[1].places];
    ends.push({ at: (pair[0].at + pair[1].at) / 2, height, places });
    return { height, ends: pair, places };
  });
}

/** How many clusters a cut at this height makes; a merge exactly there is not cut. */
export const clustersAt = (merges: readonly Merge[], height: number): number =>
  1 + merges.filter((merge) => merge.height > height).length;

/** Where to draw the cut into so many clusters: halfway between the last merge kept and the first undone. */
export function cutHeight(merges: readonly Merge[], clusters: number): number {
  const top = merges.at(-1)?.height ?? 1;
  const undone = merges.at(merges.length - clusters + 1)?.height;
  const kept = merges[merges.length - clusters]?.height ?? 0;
  return clusters <= 1 || undone === undefined ? top * 1.04 : (kept + undone) / 2;
}

/** The cluster that most of these leaves are in: what a branch is coloured by, also when a leaf was moved by hand. */
export function commonest(clusters: readonly number[]): number | null {
  const counts = new Map<number, number>();
  for (const cluster of clusters) counts.set(cluster, (counts.get(cluster) ?? 0) + 1);
  return [...counts].sort((one, other) => other[1] - one[1])[0]?.[0] ?? null;
}
