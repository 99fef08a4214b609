/** What happened in front of the viewer since its clips were loaded: it is sent with an answer. */

export type Tier = "full" | "plain";

/** Milliseconds since the clips were loaded, azimuth and elevation in degrees, zoom. */
export type Sight = [number, number, number, number];

export interface ViewingStatistics {
  /** Times that the motion began from its first frame, loops included. */
  plays: number;
  /** Time that it moved while it could be seen, in milliseconds. */
  viewingMs: number;
  /** Times that the view was turned: one a drag or key press. */
  cameraMoves: number;
  /** How the view went, if it was turned at all: enough points to turn it so again. */
  camera: readonly Sight[];
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
/** More points than these, and every other one is let go. */
const MOST_SIGHTS = 200;
const SIGHT_MS = 50;

export class Statistics {
  private plays = 0;
  private viewingMs = 0;
  private cameraMoves = 0;
  private droppedFrames = 0;
  private frames = 0;
  private worked = 0;
  private busyMs = 0;
  private sights: Sight[] = [];
  private spacing = SIGHT_MS;
  private began = 0;

  reset(now = performance.now()): void {
    this.sights = [];
    this.spacing = SIGHT_MS;
    this.began = now;
    this.plays = this.viewingMs = this.cameraMoves = 0;
    this.droppedFrames = this.frames = this.worked = this.busyMs = 0;
  }

  countPlay(): void {
    this.plays += 1;
  }

  countCameraMove(): void {
    this.cameraMoves += 1;
  }

  /** Notes the view of a frame; what does not change is noted once. */
  countSight(azimuth: number, elevation: number, zoom: number, now = performance.now()): void {
    const sight: Sight = [Math.round(now - this.began), tenth(azimuth), tenth(elevation), Math.round(zoom * 100) / 100];
    const last = this.sights.at(-1);
    if (last && last.slice(1).every((value, index) => value === sight[index + 1])) {
      return;
    }
    // It stood still until just now: else the way there would seem to have taken all that time.
    if (last && sight[0] - last[0] > 2 * this.spacing) {
      this.sights.push([sight[0] - this.spacing, last[1], last[2], last[3]]);
    }
    const before = this.sights.at(-2);
    // The newest point moves on until it is far enough from the one before it.
    const newest = this.sights.at(-1);
    if (newest && before && newest[0] - before[0] < this.spacing) this.sights.pop();
    this.sights.push(sight);
    if (this.sights.length > MOST_SIGHTS) {
      this.sights = this.sights.filter((_, index) => index % 2 === 0);
      this.spacing *= 2;
    }
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
      camera: this.sights.length > 1 ? this.sights : [],
      droppedFrames: this.droppedFrames,
      frames: this.frames,
      tier,
      mainThreadMs: this.worked ? Math.round((1000 * this.busyMs) / this.worked) / 1000 : 0,
    };
  }
}

function tenth(degrees: number): number {
  return Math.round(degrees * 10) / 10;
}
