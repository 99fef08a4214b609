// How long a trial took, and how much of that the person was away.

/** Milliseconds since the page began, never going back. */
export type Now = () => number;

/** Counted within one trial, in milliseconds where a time. */
export interface Attention {
  spent_ms: number;
  hidden_ms: number;
  blur_count: number;
}

export const NOTHING_YET: Attention = { spent_ms: 0, hidden_ms: 0, blur_count: 0 };

/** Runs from `start` on; what an earlier visit of the same trial counted (before a reload) is added. */
export class TrialClock {
  readonly #now: Now;
  readonly #page: Document;
  #before = NOTHING_YET;
  #began: number | null = null;
  #hiddenSince: number | null = null;
  #hidden = 0;
  #blurs = 0;

  constructor(now: Now = () => performance.now(), page: Document = document) {
    this.#now = now;
    this.#page = page;
    page.addEventListener("visibilitychange", () => this.#visibility());
    page.defaultView?.addEventListener("blur", () => void this.#blurs++);
  }

  get running(): boolean {
    return this.#began !== null;
  }

  start(before: Attention = NOTHING_YET): void {
    this.#before = before;
    this.#began = this.#now();
    this.#hidden = 0;
    this.#blurs = 0;
    this.#hiddenSince = this.#page.hidden ? this.#began : null;
  }

  stop(): void {
    this.#began = null;
  }

  read(): Attention {
    if (this.#began === null) return NOTHING_YET;
    const now = this.#now();
    const away = this.#hiddenSince === null ? 0 : now - this.#hiddenSince;
    return {
      spent_ms: this.#before.spent_ms + now - this.#began,
      hidden_ms: this.#before.hidden_ms + this.#hidden + away,
      blur_count: this.#before.blur_count + this.#blurs,
    };
  }

  #visibility(): void {
    if (this.#began === null) return;
    if (this.#page.hidden) this.#hiddenSince ??= this.#now();
    else if (this.#hiddenSince !== null) {
      this.#hidden += this.#now() - this.#hiddenSince;
      this.#hiddenSince = null;
    }
  }
}
