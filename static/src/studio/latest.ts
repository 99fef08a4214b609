// One request at a time; of all that was asked for meanwhile, the newest goes next and the rest never.

export class Latest<T> {
  private waiting: { value: T } | null = null;
  private running = false;

  constructor(private readonly run: (value: T) => Promise<void>) {}

  get busy(): boolean {
    return this.running;
  }

  ask(value: T): void {
    this.waiting = { value };
    if (!this.running) void this.drain();
  }

  private async drain(): Promise<void> {
    this.running = true;
    try {
      while (this.waiting) {
        const { value } = this.waiting;
        this.waiting = null;
        await this.run(value);
      }
    } finally {
      this.running = false;
    }
  }
}

/** Calls once it has been quiet for so long. */
export function debounced<T>(act: (value: T) => void, milliseconds: number): (value: T) => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  return (value) => {
    clearTimeout(timer);
    timer = setTimeout(() => act(value), milliseconds);
  };
}
