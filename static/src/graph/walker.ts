// The steered character: asks for the next piece of motion in time, and shows what is due.

import { api, ApiError } from "../api";
import type { Key, Manner, Piece, Place } from "./model";
import { PoseStream, type Queued } from "./pose_stream";

/** Seconds of motion that lie ready; a little more than the server needs for the next piece. */
const AHEAD = 0.2;
/** Seconds from now at which a changed wish takes effect at the soonest. */
const SOON = 0.08;
/** Frames of a piece. */
const PIECE = 18;
/** A moment that the page was busy is made up for, but not more of it than this, in seconds. */
const LONGEST_STEP = 0.1;
/** Seconds until a failed request is tried again. */
const PATIENCE = 1;

export interface Stage {
  setPose(index: number, root: ArrayLike<number>, rotations: ArrayLike<number>): void;
}

export interface Listener {
  /** Another piece is on view. */
  moved(shown: Queued): void;
  /** The server did not give what was asked for (null: it does again). */
  failed(error: ApiError | null): void;
}

export class Walker {
  /** Seconds of motion that have been shown. */
  time = 0;
  wanted: string;
  manner: Manner;
  private stream: PoseStream;
  private pose = { root: new Float32Array(3), rotations: new Float32Array(0) };
  private shown: Queued | null = null;
  private asking = false;
  private stale = false;
  private via: Key | null = null;
  private lastNow: number | null = null;
  private request = 0;
  private waitUntil = 0;
  /** Answers to what was asked before a new beginning are not for us any more. */
  private life = 0;

  constructor(
    private readonly address: string,
    private readonly stage: Stage,
    private readonly frameTime: number,
    private place: Place,
    private readonly listener: Listener,
  ) {
    this.stream = new PoseStream(frameTime);
    this.wanted = place.clip;
    this.manner = place.manner;
  }

  start(): void {
    this.lastNow = null;
    if (!this.request) this.request = requestAnimationFrame((now) => this.onFrame(now));
  }

  stop(): void {
    cancelAnimationFrame(this.request);
    this.request = 0;
  }

  /** Walks towards a clip from now on. */
  steer(clip: string): void {
    if (clip === this.wanted && !this.via) return;
    this.wanted = clip;
    this.via = null;
    this.stale = true;
  }

  /** Moves like this from now on. */
  change(manner: Manner): void {
    this.manner = manner;
    this.stale = true;
  }

  /** Begins anew shortly before a transition, takes it and goes on in its target. */
  show(key: Key): void {
    const lead = Math.round(0.7 / this.frameTime);
    this.begin({
      clip: key.source, frame: Math.max(0, key.source_frame - lead),
      turn: 0, x: 0, z: 0, manner: this.manner,
    });
    this.wanted = key.target;
    this.via = key;
  }

  /** Begins anew somewhere: after the graph has changed, the old place may be a dead end. */
  begin(place: Place): void {
    this.life += 1;
    this.asking = false;
    this.stale = false;
    this.via = null;
    this.waitUntil = 0;
    this.place = place;
    this.stream = new PoseStream(this.frameTime);
    this.time = 0;
  }

  private onFrame(now: number): void {
    this.request = requestAnimationFrame((next) => this.onFrame(next));
    const passed = this.lastNow === null ? 0 : (now - this.lastNow) / 1000;
    this.lastNow = now;
    this.time = Math.min(this.time + Math.min(passed, LONGEST_STEP), this.stream.end);
    this.askInTime(now / 1000);
    this.showMoment();
  }

  private showMoment(): void {
    const { stream, pose, time } = this;
    const shown = stream.at(time);
    if (!shown) return;
    if (pose.rotations.length !== 4 * shown.piece.joints) {
      pose.rotations = new Float32Array(4 * shown.piece.joints);
    }
    if (stream.sample(time, pose)) this.stage.setPose(0, pose.root, pose.rotations);
    if (shown !== this.shown) {
      this.shown = shown;
      this.listener.moved(shown);
    }
    stream.forgetBefore(time);
  }

  private askInTime(now: number): void {
    if (this.asking || now < this.waitUntil) return;
    if (this.stale) this.stream.cutAfter(this.time + SOON);
    if (this.stale || this.stream.end - this.time < AHEAD) {
      this.stale = false;
      void this.ask(this.life);
    }
  }

  private async ask(life: number): Promise<void> {
    this.asking = true;
    const place = this.stream.place ?? this.place;
    const { wanted: target, manner, via } = this;
    const body = { place, target, manner, frames: PIECE, ...(via ? { via } : {}) };
    try {
      const piece = await api.post<Piece>(this.address, body);
      if (life !== this.life) return;
      this.stream.append(piece, place);
      if (piece.taken && via && this.via === via) this.via = null;
      this.listener.failed(null);
    } catch (error) {
      if (life !== this.life) return;
      if (!(error instanceof ApiError)) throw error;
      this.listener.failed(error);
      this.waitUntil = performance.now() / 1000 + PATIENCE; // also where the listener begins anew
    } finally {
      if (life === this.life) this.asking = false;
    }
  }
}
