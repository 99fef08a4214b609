"""Nervous: how far and how fast one moves changes all the time (proposed by Förger, ch. 6)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray
from scipy.interpolate import BSpline

from motion.clip import Clip
from motion.editing.foot_repair import repair_feet
from motion.editing.path_length import PathLength, change_path_length
from motion.editing.tempo import at_frames
from motion.rotations import from_directions, to_directions

Array = NDArray[np.float64]

_STEP = 0.4  # s between two drawn values; what lies between goes over smoothly
_RATE = 200.0  # Hz at which the rhythm is worked out, whatever the clip's own rate
_PACE = np.log(2.5)  # of the pace, at full rhythm and the most extreme draw


def vary(clip: Clip, path: float, rhythm: float, rng: Generator) -> Clip:
    """The clip with its path length and its rhythm changing at random; length in time stays.

    The same draws give the same motion at any frame rate.

    Args:
        clip: any clip; a cyclic one stays cyclic.
        path: how far the gain of the path length strays from 1; 0 leaves it, 1 reaches 0 and 2.
        rhythm: how far the pace strays; 0 leaves it, 1 reaches 2.5 times faster and slower.
        rng: where the draws come from.
    """
    if (path == 0.0 and rhythm == 0.0) or clip.frames < 4:
        return clip
    gain, pace = _random_curves(clip, rng)
    if rhythm != 0.0:
        clip = at_frames(clip, _in_rhythm(clip, rhythm, pace))
    if path == 0.0:
        return clip
    # Filtering is linear in the gain, so one filtered clip serves every gain in between.
    twice = change_path_length(clip, PathLength(2.0, high_gain=1.0))
    before = to_directions(clip.rotations)
    change = to_directions(twice.rotations) - before
    gains = gain(np.arange(clip.frames) * clip.frame_time)
    varied = from_directions(before + path * gains[:, None, None] * change)
    return repair_feet(clip, replace(clip, rotations=varied))


def _in_rhythm(clip: Clip, rhythm: float, pace: BSpline) -> Array:
    """Which frame (T,), fractional, is shown when."""
    count = max(2, round(clip.duration * _RATE))
    middles = (np.arange(count) + 0.5) * (clip.duration / count)
    shown_at = np.concatenate([[0.0], np.cumsum(np.exp(-rhythm * _PACE * pace(middles)))])
    last = clip.frames - 1
    frames = np.linspace(0.0, last, count + 1)
    return np.interp(np.arange(clip.frames), shown_at * (last / shown_at[-1]), frames)


def _random_curves(clip: Clip, rng: Generator) -> tuple[BSpline, BSpline]:
    """Two smooth curves over seconds in [−1, 1]: cubic B-splines over evenly timed draws."""
    pieces = int(np.ceil(clip.duration / _STEP + 0.5))
    step = _STEP
    if clip.cyclic:
        pieces = max(1, round(clip.duration / _STEP))
        step = clip.duration / pieces
    draws = rng.uniform(-1.0, 1.0, (pieces + 3, 2))
    if clip.cyclic:
        draws = draws[np.arange(pieces + 3) % pieces]
    knots = step * np.arange(-3, pieces + 4)
    return BSpline(knots, draws[:, 0], 3), BSpline(knots, draws[:, 1], 3)
