// What stands in a history is what the stage shall show: one request at a time, the newest wish next. Where a motion
// cannot be made, the last one stays; where the server cannot be reached, it is asked again.
import { ApiError } from "../api";
import type { History } from "./history";
import { debounced, Latest } from "./latest";

/** Puts a motion on the stage. */
export type Show = (glb: ArrayBuffer, askedAt: number) => void;

export const AGAIN_AFTER = 2000;
const CHECK_AFTER = 400;

export abstract class Staging<Wish, Kept = Wish> {
  abstract readonly history: History<Kept>;
  /** Why the stage does not show what is wished. */
  problem: ApiError | null = null;
  /** The moment of the event that asks for the next motion; 0 where none is measured. */
  askedAt = 0;
  /** What the stage shows. */
  protected shown: Wish | null = null;
  private asking = false;
  protected readonly shows = new Latest<Wish>((wish) => this.show(wish));
  protected readonly checks = new Latest<Wish>((wish) => this.check(wish));
  /** Not during a drag: its motions are made by the process that would check. */
  protected readonly checkSoon: (wish: Wish) => void = debounced(
    (wish) => (this.history.isHeld ? this.checkSoon(wish) : this.checks.ask(wish)), CHECK_AFTER,
  );

  protected constructor(protected readonly changed: () => void) {}

  /** What the stage shall show. */
  protected abstract get wish(): Wish;
  protected abstract put(wish: Wish, askedAt: number): Promise<void>;
  protected abstract check(wish: Wish): Promise<void>;
  protected abstract refresh(): void;

  /** The stage shows what is wished. */
  get isShown(): boolean {
    return this.shown === this.wish;
  }

  /** The stage will change by itself. */
  get isBusy(): boolean {
    return !this.isShown && (this.asking || !this.problem);
  }

  undo(): void {
    this.history.undo();
    this.refresh();
  }

  redo(): void {
    this.history.redo();
    this.refresh();
  }

  /** Ask again for what is not there yet. */
  retry(): void {
    if (this.problem) this.refresh();
  }

  /** What was said of a problem stays until its end is known. */
  private async show(wish: Wish): Promise<void> {
    const { askedAt } = this;
    this.askedAt = 0;
    this.asking = true;
    if (this.problem) this.changed();
    try {
      await this.put(wish, askedAt);
      this.shown = wish;
      this.problem = null;
    } catch (error) {
      this.problem = asApiError(error);
      if (this.problem.transient) setTimeout(() => this.retry(), AGAIN_AFTER);
    }
    this.asking = false;
    this.changed();
  }
}

export function asApiError(error: unknown): ApiError {
  if (error instanceof ApiError) return error;
  const message = error instanceof Error ? error.message : String(error);
  return new ApiError("not_shown", message, null, "Undo the last change.", 500);
}
