/** What happened in front of the viewer since its clips were loaded: it is sent with an answer. */

export type Tier = "full" | "plain";

export interface ViewingStatistics {
  /** Times that the motion began from its first frame, loops included. */
  plays: number;
  /** Time that it moved while it could be seen, in milliseconds. */
  viewingMs: number;
  /** Times that the view was turned: one a drag or key press. */
  cameraMoves: number;
  /** Frames of sixty a second that were due but not drawn. */
  droppedFrames: number;
  /** Frames drawn. */
  frames: number;
  /** How the figure was shaded. */
  tier: Tier;
  /** Mean main-thread time to pose and draw one frame, in milliseconds. */
  mainThreadMs: number;
}

const FRAME_MS = 1000 / 60;

export class Statistics {
  private plays = 0;
  private viewingMs = 0;
  private cameraMoves = 0;
  private droppedFrames = 0;
  private frames = 0;
  private worked = 0;
  private busyMs = 0;

  reset(): void {
    this.plays = this.viewingMs = this.cameraMoves = 0;
    this.droppedFrames = this.frames = this.worked = this.busyMs = 0;
  }

  countPlay(): void {
    this.plays += 1;
  }

  countCameraMove(): void {
    this.cameraMoves += 1;
  }

  /** Notes a moving frame: the time since the frame before it, if that moved too. */
  countInterval(milliseconds: number): void {
    this.viewingMs += milliseconds;
    this.droppedFrames += Math.max(0, Math.round(milliseconds / FRAME_MS) - 1);
  }

  countFrame(): void {
    this.frames += 1;
  }

  countWork(mainThreadMs: number): void {
    this.worked += 1;
    this.busyMs += mainThreadMs;
  }

  report(tier: Tier): ViewingStatistics {
    return {
      plays: this.plays,
      viewingMs: Math.round(this.viewingMs),
      cameraMoves: this.cameraMoves,
      droppedFrames: this.droppedFrames,
      frames: this.frames,
      tier,
      mainThreadMs: this.worked ? Math.round((1000 * this.busyMs) / this.worked) / 1000 : 0,
    };
  }
}
