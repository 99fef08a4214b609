"""Nine motions from one, and every motion between them (Förger, ch. 3.6, figures 27 and 28)."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass, replace
from functools import cached_property
from threading import Lock

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.editing.foot_repair import repair_feet
from motion.editing.path_length import PathLength, change_path_length
from motion.editing.timing import ADDED, EVEN, Timing, change_timing
from motion.errors import MotionError
from motion.rotations import from_directions, to_directions

Array = NDArray[np.float64]

SHORTER, LONGER = 0.4, 1.6  # gains at the ends of the path axis
_TIMINGS = (EVEN, None, ADDED)
_MOST = 400_000  # frames times joints of all remembered grids; about a quarter of a gigabyte
_CACHE: OrderedDict[tuple[str, tuple[str, ...] | None], NineMotions] = OrderedDict()
_LOCK = Lock()


@dataclass(frozen=True, eq=False)
class NineMotions:
    """(shorter, as is, longer paths) × (even speed, as is, added acceleration).

    Attributes:
        motions: three rows by path, each of three clips by timing; the middle one is the original.
    """

    motions: tuple[tuple[Clip, Clip, Clip], ...]

    @property
    def size(self) -> int:
        """Frames times joints of one of the nine."""
        return int(self.motions[1][1].rotations.size // 4)

    @cached_property
    def _directions(self) -> Array:
        return np.array([[to_directions(clip.rotations) for clip in row] for row in self.motions])

    @cached_property
    def _roots(self) -> Array:
        return np.array([[clip.root_positions for clip in row] for row in self.motions])

    def at(self, path: float, timing: float) -> Clip:
        """The weighted mean of the four motions around a point.

        Args:
            path: 0 shorter, 1 as is, 2 longer.
            timing: 0 even speed, 1 as is, 2 added acceleration.

        Raises:
            MotionError: if a coordinate lies outside [0, 2].
        """
        weights = np.outer(_hat(path, "path"), _hat(timing, "timing"))
        corners = np.argwhere(weights > 0)
        if len(corners) == 1:
            return self.motions[corners[0][0]][corners[0][1]]
        directions = sum(weights[i, j] * self._directions[i, j] for i, j in corners)
        roots = sum(weights[i, j] * self._roots[i, j] for i, j in corners)
        original = self.motions[1][1]
        rotations = from_directions(np.asarray(directions))
        return replace(original, rotations=rotations, root_positions=np.asarray(roots))


def nine_motions(clip: Clip, limbs: tuple[str, ...] | None = None) -> NineMotions:
    """The grid of a clip: path length first, feet repaired on the two new paths, then timing."""
    paths = [
        clip if gain is None else repair_feet(clip, change_path_length(clip, PathLength(gain)))
        for gain in (SHORTER, None, LONGER)
    ]
    rows = []
    for path in paths:
        even, as_is, added = (
            path if kind is None else change_timing(path, Timing(kind, limbs)) for kind in _TIMINGS
        )
        rows.append((even, as_is, added))
    return NineMotions(tuple(rows))


def cached_nine_motions(clip: Clip, limbs: tuple[str, ...] | None = None) -> NineMotions:
    """``nine_motions``, remembered for the clips used last in this process."""
    key = (clip.content_hash, limbs)
    with _LOCK:
        if key in _CACHE:
            _CACHE.move_to_end(key)
            return _CACHE[key]
    made = nine_motions(clip, limbs)
    with _LOCK:
        _CACHE[key] = made
        while len(_CACHE) > 1 and sum(nine.size for nine in _CACHE.values()) > _MOST:
            _CACHE.popitem(last=False)
    return made


def _hat(position: float, name: str) -> Array:
    """(3,) linear weights of the grid lines 0, 1 and 2."""
    if not 0.0 <= position <= 2.0:
        raise MotionError(f"“{name}” is {position}: the grid reaches from 0 to 2.")
    return np.maximum(0.0, 1.0 - np.abs(np.arange(3) - position))
