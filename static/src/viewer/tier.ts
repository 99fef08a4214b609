/** Chooses how richly to shade: a device that cannot keep up gets the plain shading for good. */
import type { Tier } from "./statistics";

const WARM_UP = 4;
const TRIAL = 30;
/** A mean interval above this is under 40 frames a second. */
const SLOWEST_MS = 25;
const KEY = "manner-tier";

export class TierChooser {
  private seen = 0;
  private sum = 0;
  tier: Tier;

  constructor(private readonly store: Pick<Storage, "getItem" | "setItem"> | null) {
    this.tier = store?.getItem(KEY) === "plain" ? "plain" : "full";
  }

  /** Notes the time between two drawn frames. Returns true when the tier has just changed. */
  note(milliseconds: number): boolean {
    if (this.tier === "plain" || this.seen >= WARM_UP + TRIAL) return false;
    this.seen += 1;
    // The first frames compile shaders: they say nothing about the rate to come.
    if (this.seen > WARM_UP) this.sum += milliseconds;
    if (this.seen < WARM_UP + TRIAL || this.sum / TRIAL <= SLOWEST_MS) return false;
    this.tier = "plain";
    this.store?.setItem(KEY, "plain");
    return true;
  }
}

function sessionStore(): Storage | null {
  try {
    return window.sessionStorage;
  } catch {
    return null; // storage is forbidden: the choice then lasts as long as the page
  }
}

let shared: TierChooser | undefined;

/** The one chooser of the page: what one clip found out holds for the next. */
export function tierChooser(): TierChooser {
  shared ??= new TierChooser(sessionStore());
  return shared;
}
