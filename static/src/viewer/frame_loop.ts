/** Draws frame after frame while there is something new to see and somebody can see it. */
import { Visibility } from "./visibility";

export class FrameLoop {
  private readonly visibility: Visibility;
  private request = 0;
  private last: number | null = null;

  /** @param draw draws; `passed`: ms since the frame before, 0 for the first of a run. Returns whether to go on. */
  constructor(
    element: Element,
    private readonly draw: (now: number, passed: number) => boolean,
  ) {
    this.visibility = new Visibility(element, () => this.ask());
  }

  start(): void {
    this.visibility.start();
  }

  stop(): void {
    cancelAnimationFrame(this.request);
    this.request = 0;
    this.visibility.stop();
  }

  /** The next frame is the first of a run: the time until then does not count. */
  restart(): void {
    this.last = null;
  }

  /** Asks for one more frame, unless nobody could see it. */
  ask(): void {
    if (!this.visibility.visible) this.last = null;
    else if (this.request === 0) this.request = requestAnimationFrame((now) => this.onFrame(now));
  }

  private onFrame(now: number): void {
    this.request = 0;
    if (!this.visibility.visible) return this.restart();
    const passed = this.last === null ? 0 : now - this.last;
    const going = this.draw(now, passed);
    this.last = going ? now : null;
    if (going) this.ask();
  }
}
