// The next clips are fetched ahead of time, so that a person never waits for one.

/** Fetches one file; `onShare` hears how much of it is there, from 0 to 1. */
export type Fetch = (url: string, onShare: (share: number) => void) => Promise<ArrayBuffer>;

export interface PreloadOptions {
  fetch: Fetch;
  /** Makes an address from which the fetched bytes can be read as often as needed. */
  keep?: (bytes: ArrayBuffer) => string;
  /** How many trials beyond the current one are fetched. */
  ahead?: number;
  wait?: (milliseconds: number) => Promise<void>;
}

/** Addresses of the files that one trial shows. */
export type Files = readonly string[];

const LONGEST_WAIT = 8_000;

/** Files are fetched once, one after another, the current trial's first; a failure is tried again. */
export class Preloader {
  readonly #plan: readonly Files[];
  readonly #options: Required<PreloadOptions>;
  readonly #ready = new Map<string, string>();
  readonly #shares = new Map<string, number>();
  #wanted: string[] = [];
  #working = false;
  #listeners = new Set<() => void>();

  constructor(plan: readonly Files[], options: PreloadOptions) {
    this.#plan = plan;
    this.#options = { keep: objectUrl, ahead: 2, wait: pause, ...options };
  }

  /** Fetch the files of trial `index` and of the ones after it; resolves when the trial's own are there. */
  async want(index: number, onProgress: () => void = () => {}): Promise<Files> {
    const files = this.#plan[index] ?? [];
    this.#wanted = [...new Set(this.#plan.slice(index, index + 1 + this.#options.ahead).flat())];
    void this.#work();
    while (!this.#has(files)) {
      await this.#change();
      onProgress();
    }
    return files.map((url) => this.#ready.get(url) ?? url);
  }

  /** How much of trial `index` is there, from 0 to 1. */
  share(index: number): number {
    const files = this.#plan[index] ?? [];
    const shares = files.map((url) => (this.#ready.has(url) ? 1 : (this.#shares.get(url) ?? 0)));
    return shares.length ? shares.reduce((sum, share) => sum + share, 0) / shares.length : 1;
  }

  async #work(): Promise<void> {
    if (this.#working) return;
    this.#working = true;
    for (let url = this.#missing(), failures = 0; url; url = this.#missing()) {
      try {
        await this.#fetch(url);
        failures = 0;
      } catch {
        await this.#options.wait(Math.min(LONGEST_WAIT, 500 * 2 ** failures++));
      }
    }
    this.#working = false;
  }

  async #fetch(url: string): Promise<void> {
    const bytes = await this.#options.fetch(url, (share) => {
      this.#shares.set(url, share);
      this.#announce();
    });
    this.#ready.set(url, this.#options.keep(bytes));
    this.#announce();
  }

  #missing(): string | undefined {
    return this.#wanted.find((url) => !this.#ready.has(url));
  }

  #has(files: Files): boolean {
    return files.every((url) => this.#ready.has(url));
  }

  #change(): Promise<void> {
    return new Promise((resolve) => this.#listeners.add(resolve));
  }

  #announce(): void {
    const listeners = this.#listeners;
    this.#listeners = new Set();
    for (const listener of listeners) listener();
  }
}

function objectUrl(bytes: ArrayBuffer): string {
  return URL.createObjectURL(new Blob([bytes], { type: "model/gltf-binary" }));
}

function pause(milliseconds: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}
