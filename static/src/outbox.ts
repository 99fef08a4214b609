// Answers wait here until the server has acknowledged them, across reloads, closed tabs and lost connections.

import { ApiError } from "./api";
import type { Store } from "./participant/store";

/** One answer to one trial, as the server takes it. Sending it twice has the same effect as once. */
export interface Answer {
  trial_index: number;
  revision: number;
  [field: string]: unknown;
}

export interface OutboxOptions<A extends Answer> {
  store: Store;
  /** Hands one answer to the server; resolves once the server has it for good. */
  send: (answer: A) => Promise<unknown>;
  /** The server held another answer under the same number, and that one counts. */
  onConflict?: (answer: A, stored: unknown) => void;
  random?: () => number;
}

const FIRST_DELAY = 500;
const LONGEST_DELAY = 20_000;
const FOLDER = "answer/";

/** Emits `change` whenever `waiting`, `failing` or `refusal` may have changed. */
export class Outbox<A extends Answer = Answer> extends EventTarget {
  readonly #options: OutboxOptions<A>;
  readonly #refused = new Set<string>();
  #running: Promise<void> | null = null;
  #stopped = false;
  #wake: (() => void) | null = null;
  #failures = 0;

  /** The last answer that the server would not take, in its own words; the answer itself stays on this device. */
  refusal: ApiError | null = null;

  constructor(options: OutboxOptions<A>) {
    super();
    this.#options = options;
  }

  /** Keep an answer, then send it as soon as that is possible. It is on the device before this returns. */
  put(answer: A): void {
    this.#options.store.set(keyOf(answer), answer);
    this.#changed();
    void this.flush();
  }

  /** The answers that the server has not acknowledged yet. */
  get pending(): A[] {
    const { store } = this.#options;
    return store.keys(FOLDER).flatMap((key) => store.get<A>(key) ?? []);
  }

  get waiting(): number {
    return this.#options.store.keys(FOLDER).length;
  }

  /** True while the last attempt failed for want of a connection or of a healthy server. */
  get failing(): boolean {
    return this.#failures > 0;
  }

  /** Send what waits; resolves when nothing is left that could be sent. */
  flush(): Promise<void> {
    if (this.#stopped) return Promise.resolve();
    this.#wake?.();
    this.#running ??= this.#run().finally(() => {
      this.#running = null;
      this.#changed();
    });
    return this.#running;
  }

  /** Stop sending, because another tab has taken over; what waits stays on the device for it. */
  stop(): void {
    this.#stopped = true;
    this.#wake?.();
  }

  async #run(): Promise<void> {
    for (let key = this.#next(); key && !this.#stopped; key = this.#next()) {
      const answer = this.#options.store.get<A>(key);
      if (!answer) this.#options.store.remove(key);
      else await this.#attempt(key, answer);
    }
  }

  async #attempt(key: string, answer: A): Promise<void> {
    try {
      await this.#options.send(answer);
      this.#settle(key);
    } catch (error) {
      if (!(error instanceof ApiError) || error.transient) return this.#pause();
      if (error.code === "already_answered") {
        this.#settle(key);
        this.#options.onConflict?.(answer, error.detail["stored"]);
      } else {
        this.#refused.add(key);
        this.refusal = error;
        this.#changed();
      }
    }
  }

  #next(): string | undefined {
    return this.#options.store.keys(FOLDER).find((key) => !this.#refused.has(key));
  }

  #settle(key: string): void {
    this.#failures = 0;
    this.#options.store.remove(key);
    // What was refused and then mended is as good as taken: the newest answer to a step counts.
    for (const refused of this.#refused) {
      if (stepOf(refused) !== stepOf(key) || refused > key) continue;
      this.#refused.delete(refused);
      this.#options.store.remove(refused);
    }
    if (!this.#refused.size) this.refusal = null;
    this.#changed();
  }

  /** Wait longer after every failure, with chance in it so that many browsers do not come back as one. */
  #pause(): Promise<void> {
    const longest = Math.min(LONGEST_DELAY, FIRST_DELAY * 2 ** this.#failures++);
    const delay = longest * (0.5 + 0.5 * (this.#options.random ?? Math.random)());
    this.#changed();
    return new Promise((resolve) => {
      const timer = setTimeout(() => this.#wake?.(), delay);
      this.#wake = () => {
        clearTimeout(timer);
        this.#wake = null;
        resolve();
      };
    });
  }

  #changed(): void {
    this.dispatchEvent(new Event("change"));
  }
}

/** Keys sort by trial, then revision, so that answers leave in the order in which they were given. */
function keyOf({ trial_index, revision }: Answer): string {
  return `${FOLDER}${String(trial_index).padStart(6, "0")}.${String(revision).padStart(4, "0")}`;
}

const stepOf = (key: string): string => key.slice(0, key.lastIndexOf("."));
