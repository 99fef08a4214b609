// What was, what is and what was undone. A drag, or a run of keys on one control, is one entry.

/** Milliseconds in which further changes by the same control still belong together. */
const TOGETHER = 700;
const LONGEST = 200;

export class History<T> {
  private past: T[] = [];
  private future: T[] = [];
  private last: { control: string; at: number } | null = null;
  private held = false;

  constructor(private current: T) {}

  get present(): T {
    return this.current;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** A change by a control; it joins the entry before when it goes on with the same gesture. */
  set(next: T, control: string, now = performance.now()): void {
    const joins = this.last?.control === control && (this.held || now - this.last.at < TOGETHER);
    if (!joins) this.past = [...this.past, this.current].slice(-LONGEST);
    this.current = next;
    this.future = [];
    this.last = { control, at: now };
  }

  /** A gesture is under way. */
  get isHeld(): boolean {
    return this.held;
  }

  /** A pointer went down: all until it is released is one entry. */
  hold(): void {
    this.held = true;
    this.last = null;
  }

  release(): void {
    this.held = false;
    this.last = null;
  }

  undo(): void {
    const before = this.past.at(-1);
    if (before === undefined) return;
    this.past = this.past.slice(0, -1);
    this.future = [this.current, ...this.future];
    this.show(before);
  }

  redo(): void {
    const [after, ...rest] = this.future;
    if (after === undefined) return;
    this.past = [...this.past, this.current];
    this.future = rest;
    this.show(after);
  }

  private show(state: T): void {
    this.current = state;
    this.last = null;
  }
}
