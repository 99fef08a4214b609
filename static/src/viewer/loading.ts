/** Fetches what a viewer wants, one wish at a time: a newer wish makes an older one void. */
import { loadBody } from "./assets";
import type { Body } from "./body";
import { fetchPerformers, type Wanted } from "./casting";
import { loadingMessage, PATIENCE_MS } from "./overlay";
import type { Performer } from "./stage";

export interface Audience {
  /** Words for a wait that has become noticeable. */
  say(message: HTMLElement): void;
  /** The body has come before its motion. */
  await(body: Body): void;
  progress(loaded: number, total: number): void;
  begin(performers: Performer[], wanted: Wanted[]): void;
  fail(error: Error): void;
}

export class Loading {
  private wish = 0;

  constructor(private readonly audience: Audience) {}

  /** Whatever is still on its way is no longer wanted. */
  cancel(): void {
    this.wish += 1;
  }

  async fetch(wanted: Wanted[]): Promise<void> {
    const wish = (this.wish += 1);
    if (wanted.length === 0) return;
    const current = () => wish === this.wish;
    const waiting = this.announce(wanted[0]!.figure, current);
    try {
      const performers = await fetchPerformers(wanted, (loaded, total) => {
        if (!current()) return;
        waiting.show(loaded / total);
        this.audience.progress(loaded, total);
      });
      if (current()) this.audience.begin(performers, wanted);
    } catch (error) {
      const known = error instanceof Error ? error : new Error(String(error));
      if (current()) this.audience.fail(known);
    } finally {
      waiting.stop();
    }
  }

  /** After a moment of patience: a thin bar, and a pale standing figure. */
  private announce(figure: string, current: () => boolean) {
    const message = loadingMessage();
    let over = false;
    const speak = async () => {
      if (!current()) return;
      this.audience.say(message.element);
      const body = await loadBody(figure);
      if (current() && !over) this.audience.await(body);
    };
    // A body that does not come is told of by the fetch itself.
    const timer = setTimeout(() => void speak().catch(() => {}), PATIENCE_MS);
    const stop = () => {
      over = true;
      clearTimeout(timer);
    };
    return { show: message.show, stop };
  }
}
