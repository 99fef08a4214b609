// Every kind of trial, by the name that a study file gives it.

import { ab } from "./ab";
import { abx } from "./abx";
import { analogue } from "./analogue";
import { choose } from "./choose";
import { freeText } from "./free_text";
import type { Kind } from "./kind";
import { likert } from "./likert";
import { match } from "./match";
import { parallel } from "./parallel";
import { ranking } from "./ranking";
import { semanticDifferential } from "./semantic_differential";
import { unipolar } from "./unipolar";

/** Each kind reads the parameters of its own part of a study; the registry cannot know them. */
export type AnyKind = Kind<any>;

export const trials: Readonly<Record<string, AnyKind>> = {
  semantic_differential: semanticDifferential,
  unipolar,
  likert,
  analogue,
  choose,
  ab,
  abx,
  parallel,
  ranking,
  free_text: freeText,
  match,
};

/** What is stored beside the answers of every step, with its unit. */
export const common = {
  comment: "text",
  touched: "ids of what was set by hand, rather than left as it was shown",
  rt_ms: "ms from the figures' first picture, or the page's, to the answer, by the page's monotonic clock",
  time_elapsed_ms: "ms from the session's first page on this device to the answer",
  "record.plays": "count of plays begun",
  "record.viewing_ms": "ms during which the figures were moving in view",
  "record.figure_ms": "of several figures, ms during which each was in view and moving",
  "record.camera_moves": "count of turns of the camera",
  "record.camera": "how the view was turned: ms since the figures came, azimuth and elevation in degrees, zoom",
  "record.hidden_ms": "ms during which the page was hidden",
  "record.blur_count": "count of times that the window lost the focus",
  "record.dropped_frames": "count of display frames that came late",
  "record.tier": "quality at which the figures were drawn",
  "record.viewport": "CSS px, and device px per CSS px",
} as const;
