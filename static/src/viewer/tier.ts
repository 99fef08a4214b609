/** Chooses how richly to shade: a device that cannot keep up gets the plain shading for good. */
import type { Tier } from "./statistics";
import { drawsInSoftware } from "./support";

const WARM_UP = 4;
const TRIAL = 30;
/** A mean interval above this is under 40 frames a second. */
const SLOWEST_MS = 25;

/** Where the page keeps what it found out; "full" set from outside settles the matter. */
export const TIER_KEY = "manner-tier";

export class TierChooser {
  tier: Tier;
  private seen = 0;
  private sum = 0;
  private settled: boolean;

  constructor(
    private readonly store: Pick<Storage, "getItem" | "setItem"> | null,
    software = false,
  ) {
    const known = store?.getItem(TIER_KEY);
    this.tier = known === "plain" || (software && known !== "full") ? "plain" : "full";
    this.settled = this.tier === "plain" || known === "full";
  }

  /**
   * Notes the time between two drawn frames. Returns true when the tier has just changed: after
   * thirty frames, or sooner once these can no longer make up for the time already lost.
   */
  note(milliseconds: number): boolean {
    if (this.settled) return false;
    this.seen += 1;
    // The first frames compile shaders: they say nothing about the rate to come.
    if (this.seen <= WARM_UP) return false;
    this.sum += milliseconds;
    const tooSlow = this.sum > TRIAL * SLOWEST_MS;
    this.settled = tooSlow || this.seen >= WARM_UP + TRIAL;
    if (!tooSlow) return false;
    this.tier = "plain";
    this.store?.setItem(TIER_KEY, "plain");
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
  shared ??= new TierChooser(sessionStore(), drawsInSoftware());
  return shared;
}
