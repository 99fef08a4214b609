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
        lasting = np.exp(-rhythm * _PACE * (pace[1:] + pace[:-1]) / 2.0)
        shown_at = np.concatenate([[0.0], np.cumsum(lasting)]) * (clip.frames - 1) / lasting.sum()
        frames = np.arange(clip.frames)
        clip = at_frames(clip, np.interp(frames, shown_at / shown_at[-1] * frames[-1], frames))
    if path == 0.0:
        return clip
    # Filtering is linear in the gain, so one filtered clip serves every gain in between.
    twice = change_path_length(clip, PathLength(2.0, high_gain=1.0))
    before = to_directions(clip.rotations)
    change = to_directions(twice.rotations) - before
    varied = from_directions(before + path * gain[:, None, None] * change)
    return repair_feet(clip, replace(clip, rotations=varied))


def _random_curves(clip: Clip, rng: Generator) -> tuple[Array, Array]:
    """Two smooth curves (T,) in [−1, 1]: cubic B-splines over draws that lie evenly in time."""
    pieces = max(1, round(clip.duration / _STEP))
    step = clip.duration / pieces if clip.cyclic else _STEP
    if not clip.cyclic:
        pieces = int(np.ceil(clip.duration / step + 0.5))
    draws = rng.uniform(-1.0, 1.0, (pieces + 3, 2))
    if clip.cyclic:
        draws = draws[np.arange(pieces + 3) % pieces]
    knots = step * np.arange(-3, pieces + 4)
    curves = BSpline(knots, draws, 3)(np.arange(clip.frames) * clip.frame_time)
    return curves[:, 0], curves[:, 1]
