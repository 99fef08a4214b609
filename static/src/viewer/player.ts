/** The clock of a performance. It runs by time, so a slow display skips frames but never slows. */

export interface Part {
  duration: number;
  cyclic: boolean;
}

/** A stall longer than this (a sleeping computer) pauses the performance instead of skipping it. */
const LONGEST_STEP = 1;

export class Player {
  speed = 1;
  loop = false;
  paused = true;
  /** Seconds since the very start; goes on counting through the cycles of a cyclic loop. */
  elapsed = 0;
  private parts: Part[] = [];

  /** Called at the natural end of a performance that does not loop. */
  onEnd: () => void = () => {};
  /** Called when the performance begins (again) from its first frame. */
  onStart: () => void = () => {};

  /** Sets the clips that play in step. They share this one clock. */
  load(parts: Part[]): void {
    this.parts = parts;
    this.elapsed = 0;
    this.paused = true;
  }

  /** Puts other clips in the place of those that play: same moment, playing on or paused. */
  swap(parts: Part[]): void {
    const { currentTime, duration } = this;
    this.parts = parts;
    // The count of cycles means nothing for cycles of another length.
    if (this.duration !== duration || !this.endless) this.seek(currentTime);
  }

  /** Seconds of the longest part. */
  get duration(): number {
    return this.parts.reduce((longest, part) => Math.max(longest, part.duration), 0);
  }

  /** All parts are cycles: a loop can go on without a cut. */
  get endless(): boolean {
    return this.parts.length > 0 && this.parts.every((part) => part.cyclic);
  }

  /** Seconds within the performance, as a scrubber shows them. */
  get currentTime(): number {
    const { duration } = this;
    if (this.elapsed <= duration || duration === 0) return this.elapsed;
    return this.elapsed % duration;
  }

  play(): void {
    if (!this.paused || this.parts.length === 0) return;
    if (this.elapsed >= this.duration && !(this.loop && this.endless)) this.elapsed = 0;
    this.paused = false;
    if (this.elapsed === 0) this.onStart();
  }

  pause(): void {
    this.paused = true;
  }

  /** Goes to a moment, first to last frame. */
  seek(seconds: number): void {
    const wanted = Number.isFinite(seconds) ? seconds : 0;
    this.elapsed = Math.min(Math.max(wanted, 0), this.duration);
  }

  replay(): void {
    this.seek(0);
    this.paused = true;
    this.play();
  }

  /** Lets real time pass. */
  advance(seconds: number): void {
    if (this.paused || this.duration === 0) return;
    const before = this.elapsed;
    this.elapsed += Math.min(Math.max(seconds, 0), LONGEST_STEP) * this.speed;
    if (this.elapsed < this.duration) return;
    if (!this.loop) this.finish();
    else if (!this.endless) this.wrap();
    else if (this.cycle(before) !== this.cycle(this.elapsed)) this.onStart();
  }

  private cycle(elapsed: number): number {
    return Math.floor(elapsed / this.duration);
  }

  private wrap(): void {
    this.elapsed %= this.duration;
    this.onStart();
  }

  private finish(): void {
    this.elapsed = this.duration;
    this.paused = true;
    this.onEnd();
  }
}
