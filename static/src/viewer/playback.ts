/** The part of a viewer that a person or a page plays with: the same words as a `<video>` has. */
import { Player } from "./player";

export abstract class PlaybackElement extends HTMLElement {
  protected readonly player = new Player();
  protected loaded = false;
  /** Poses come from outside: the own clock stands still. */
  protected isLive = false;
  protected shortestFrame = 0;

  /** Asks for a frame that shows the present state. */
  protected abstract request(): void;
  /** Poses the figures for the clock's moment. */
  protected abstract showMoment(): void;

  get currentTime(): number {
    return this.player.currentTime;
  }

  set currentTime(seconds: number) {
    this.seek(seconds);
  }

  /** Seconds; 0 until `ready`. */
  get duration(): number {
    return this.player.duration;
  }

  get paused(): boolean {
    return this.player.paused;
  }

  /** Seconds of the shortest frame among the clips shown. */
  get frameTime(): number {
    return this.shortestFrame;
  }

  get speed(): number {
    return this.player.speed;
  }

  set speed(speed: number) {
    this.player.speed = Math.min(Math.max(speed, 0.05), 8);
    this.request();
  }

  get loop(): boolean {
    return this.player.loop;
  }

  set loop(loop: boolean) {
    this.player.loop = loop;
    this.request();
  }

  play(): void {
    if (!this.loaded || this.isLive) return;
    this.player.play();
    this.request();
  }

  pause(): void {
    this.player.pause();
    this.request();
  }

  replay(): void {
    if (!this.loaded || this.isLive) return;
    this.player.replay();
    this.request();
  }

  /** Goes to a moment and shows it at once, playing or not. */
  seek(seconds: number): void {
    this.player.seek(seconds);
    this.showMoment();
    this.request();
  }
}
