// The clock of a match. It goes on from what was counted before a reload, and rests while the line is down.

export class Stopwatch {
  #before = 0;
  #since: number | null = null;

  /** @param now milliseconds since the page began, never going back. */
  constructor(private readonly now: () => number = () => performance.now()) {}

  get running(): boolean {
    return this.#since !== null;
  }

  get ms(): number {
    return this.#before + (this.#since === null ? 0 : this.now() - this.#since);
  }

  /** Begins, or goes on, from so many milliseconds. */
  start(before = this.ms): void {
    this.#before = before;
    this.#since = this.now();
  }

  rest(): void {
    this.#before = this.ms;
    this.#since = null;
  }
}
