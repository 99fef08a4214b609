// Of several figures on one page: how long each has been in view while it moved.

/** After so much of a figure's movement in view, it counts as seen. */
const SEEN_MS = 1_000;
/** So much of a figure must be on the screen. */
const SHARE = 0.6;

export class Glances {
  readonly #ms: number[];
  readonly #inView = new Set<number>();
  readonly #observer: IntersectionObserver;
  #last: number | null = null;

  constructor(cells: readonly Element[], before: readonly number[] = []) {
    this.#ms = cells.map((_, place) => before[place] ?? 0);
    const places = new Map(cells.map((cell, place) => [cell, place]));
    this.#observer = new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) {
        const place = places.get(target)!;
        if (isIntersecting) this.#inView.add(place);
        else this.#inView.delete(place);
      }
    }, { threshold: SHARE });
    for (const cell of cells) this.#observer.observe(cell);
  }

  stop(): void {
    this.#observer.disconnect();
  }

  get ms(): readonly number[] {
    return this.#ms;
  }

  /** The viewer has been watched for so long by now, ms; returns whether a figure has just become seen. */
  watched(total: number): boolean {
    const passed = this.#last === null ? 0 : Math.max(0, total - this.#last);
    this.#last = total;
    const before = this.unseen;
    for (const place of this.#inView) this.#ms[place]! += passed;
    return this.unseen < before;
  }

  isSeen(place: number): boolean {
    return (this.#ms[place] ?? 0) >= SEEN_MS;
  }

  /** How many figures have not been seen yet. */
  get unseen(): number {
    return this.#ms.filter((_, place) => !this.isSeen(place)).length;
  }
}
