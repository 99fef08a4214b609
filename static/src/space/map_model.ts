// A plane through the space: where examples lie on two of its sliders. No DOM in here.

export interface Spot {
  x: number;
  y: number;
}

export interface Example extends Spot {
  name: string;
  weight: number;
}

/** The corners of the convex hull, counter-clockwise (Andrew 1979). */
export function hull(spots: readonly Spot[]): Spot[] {
  const sorted = [...spots].sort((a, b) => a.x - b.x || a.y - b.y);
  const turns = (a: Spot, b: Spot, c: Spot) => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) <= 0;
  const half = (ordered: readonly Spot[]) => {
    const corners: Spot[] = [];
    for (const spot of ordered) {
      while (corners.length > 1 && turns(corners.at(-2)!, corners.at(-1)!, spot)) corners.pop();
      corners.push(spot);
    }
    return corners.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

/** The nearest spot that is no farther away than this; null where there is none. */
export function nearest(spots: readonly Spot[], to: Spot, reach: number): number | null {
  let found: number | null = null;
  let least = reach;
  spots.forEach((spot, index) => {
    const distance = Math.hypot(spot.x - to.x, spot.y - to.y);
    if (distance <= least) [found, least] = [index, distance];
  });
  return found;
}

const STEP = 0.02;
const LEAP = 0.1;
const DIRECTIONS: Record<string, [x: number, y: number]> = {
  ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1],
};

export const inside = (value: number): number => Math.min(Math.max(Math.round(value * 100) / 100, 0), 1);

/** Where a key takes a spot; null for a key that means nothing here. */
export function stepped({ x, y }: Spot, key: string, far: boolean): Spot | null {
  const [across, up] = DIRECTIONS[key] ?? [0, 0];
  const by = far ? LEAP : STEP;
  return across || up ? { x: inside(x + across * by), y: inside(y + up * by) } : null;
}

/** The next example that a key leads to: left and right by where they lie across, up and down by how high. */
export function neighbour(examples: readonly Spot[], from: number, key: string): number | null {
  const [across, up] = DIRECTIONS[key] ?? [0, 0];
  if (!across && !up) return null;
  const order = examples.map((_, index) => index).sort((a, b) =>
    across ? examples[a]!.x - examples[b]!.x : examples[a]!.y - examples[b]!.y);
  return order[order.indexOf(from) + across + up] ?? null;
}
