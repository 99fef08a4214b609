"""Hands, feet and head that jerk more than they did."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d, uniform_filter1d

from motion.kinematics import WorldPose
from motion.quality.pair import Pair
from motion.quality.report import Measure, in_words

Array = NDArray[np.float64]

# Times the original's strongest jerk. A path 1.6 times as long has 1.6 times the jerk, at the same
# pace; the same path at 1.4 times the pace has 2.7 times.
TIMES = 3.0
LEAST = 200.0  # m/s³, about that of a quick reach: half a metre there in half a second
_PARTS = ("left_hand", "right_hand", "left_foot", "right_foot", "head")
_WINDOW = 0.1  # s over which it is averaged
_SMOOTH = 0.02  # s, standard deviation: noise of single frames is not motion


def jerks(pair: Pair) -> Iterator[Measure]:
    """The jerk of each part relative to the hips, as a mean over a tenth of a second."""
    if pair.original.frames < 5:
        return
    for role in _PARTS:
        if role in pair.roles:
            before, after = (jerk(pair, pose, role) for pose in (pair.before, pair.after))
            limit = TIMES * max(float(before.max()), LEAST)
            yield Measure("jerk", in_words(role), "m/s³", after, limit)


def jerk(pair: Pair, pose: WorldPose, role: str) -> Array:
    """Root of the mean squared third derivative (T,), m/s³."""
    step = pair.original.frame_time
    path = pose.positions[:, pair.roles[role]] - pose.positions[:, pair.roles["hips"]]
    smooth = gaussian_filter1d(path, _SMOOTH / step, axis=0, mode="nearest")
    third = np.diff(smooth, 3, axis=0) / step**3
    squared = np.pad(np.sum(third**2, axis=1), (2, 1), mode="edge")
    width = max(1, round(_WINDOW / step))
    return np.sqrt(np.maximum(uniform_filter1d(squared, width, mode="nearest"), 0.0))
