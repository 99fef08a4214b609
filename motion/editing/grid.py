"""Nine motions from one, and every motion between them (Förger, ch. 3.6, figures 27 and 28)."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass, field, replace
from threading import Lock

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.editing.foot_repair import repair_feet
from motion.editing.path_length import PathLength, change_path_length
from motion.editing.timing import ADDED, EVEN, Timing, change_timing
from motion.errors import MotionError
from motion.rotations import weighted_mean

Array = NDArray[np.float64]

SHORTER, LONGER = 0.4, 1.6  # gains at the ends of the path axis
_GAINS = (SHORTER, None, LONGER)
_TIMINGS = (EVEN, None, ADDED)
_BLOCK = 512  # frames mixed at once, so that they stay in the processor's cache
_MOST = 500_000  # frames times joints of all remembered clips' grids; about 150 MB
_CACHE: OrderedDict[tuple[str, tuple[str, ...] | None], NineMotions] = OrderedDict()
_LOCK = Lock()


@dataclass(frozen=True, eq=False)
class NineMotions:
    """(shorter, as is, longer paths) × (even speed, as is, added acceleration).

    Attributes:
        clip: the original, in the middle.
        limbs: which limbs' timing changes; None as ``Timing`` chooses.
    """

    clip: Clip
    limbs: tuple[str, ...] | None = None
    _made: dict[tuple[int, int], Clip] = field(default_factory=dict, repr=False)

    @property
    def motions(self) -> tuple[tuple[Clip, ...], ...]:
        """Three rows by path, each of three clips by timing."""
        return tuple(tuple(self.motion(path, timing) for timing in range(3)) for path in range(3))

    def motion(self, path: int, timing: int) -> Clip:
        """One of the nine; it is made when it is first asked for, and kept."""
        place = (path, timing)
        if place not in self._made:
            self._made[place] = self._make(path, timing)
        return self._made[place]

    def _make(self, path: int, timing: int) -> Clip:
        kind, gain = _TIMINGS[timing], _GAINS[path]
        if kind is not None:
            return change_timing(self.motion(path, 1), Timing(kind, self.limbs))
        if gain is not None:
            return repair_feet(self.clip, change_path_length(self.clip, PathLength(gain)))
        return self.clip

    def at(self, path: float, timing: float) -> Clip:
        """The weighted mean of the four motions around a point.

        Args:
            path: 0 shorter, 1 as is, 2 longer.
            timing: 0 even speed, 1 as is, 2 added acceleration.

        Raises:
            MotionError: if a coordinate lies outside [0, 2].
        """
        weights = np.outer(_hat(path, "path"), _hat(timing, "timing"))
        corners = [(weights[i, j], self.motion(i, j)) for i, j in np.argwhere(weights > 0).tolist()]
        if len(corners) == 1:
            return corners[0][1]
        rotations = np.empty_like(self.clip.rotations)
        for start in range(0, self.clip.frames, _BLOCK):
            part = slice(start, start + _BLOCK)
            rotations[part] = weighted_mean([(w, clip.rotations[part]) for w, clip in corners])
        roots = sum(weight * clip.root_positions for weight, clip in corners)
        return replace(self.clip, rotations=rotations, root_positions=np.asarray(roots))


def nine_motions(clip: Clip, limbs: tuple[str, ...] | None = None) -> NineMotions:
    """The grid of a clip: path length first, feet repaired on the two new paths, then timing."""
    return NineMotions(clip, limbs)


def cached_nine_motions(clip: Clip, limbs: tuple[str, ...] | None = None) -> NineMotions:
    """``nine_motions``, remembered for the clips used last in this process."""
    key = (clip.content_hash, limbs)
    with _LOCK:
        if key in _CACHE:
            _CACHE.move_to_end(key)
            return _CACHE[key]
        made = _CACHE[key] = nine_motions(clip, limbs)
        while len(_CACHE) > 1 and sum(n.clip.rotations.size // 4 for n in _CACHE.values()) > _MOST:
            _CACHE.popitem(last=False)
        return made


def _hat(position: float, name: str) -> Array:
    """(3,) linear weights of the grid lines 0, 1 and 2."""
    if not 0.0 <= position <= 2.0:
        raise MotionError(f"“{name}” is {position}: the grid reaches from 0 to 2.")
    return np.maximum(0.0, 1.0 - np.abs(np.arange(3) - position))
