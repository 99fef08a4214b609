"""A clip as its features see it: world poses from which headings and cycles are taken out."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.signal import butter, sosfiltfilt

from motion.clip import Clip
from motion.editing.cycles import three_cycles
from motion.kinematics import WorldPose, forward_kinematics
from motion.units import heading, overall_heading

Array = NDArray[np.float64]

_CUTOFF = 8.0  # Hz: what a body's parts do faster is noise, or more than 30 frames a second tell
_PADDING = 15  # frames that the filter is given beyond either end


@dataclass(frozen=True, eq=False)
class View:
    """A clip's frames with what comes before and after them.

    Attributes:
        clip: as it was given.
        longer: of a cyclic clip also the cycle before and the one after; else the clip itself.
        part: the clip's own frames among the longer one's.
    """

    clip: Clip
    longer: Clip
    part: slice

    @classmethod
    def of(cls, clip: Clip) -> View:
        """The view of any clip; one of a single frame has nothing before or after."""
        if not clip.cyclic or clip.frames < 2:
            return cls(clip, clip, slice(0, clip.frames))
        last = clip.frames - 1
        return cls(clip, three_cycles(clip), slice(last, 2 * last + 1))

    @property
    def once(self) -> slice:
        """The clip's own frames among the longer one's, without the closing one of a cycle."""
        return slice(self.part.start, self.part.stop - (self.longer is not self.clip))

    @cached_property
    def pose(self) -> WorldPose:
        """World pose of the longer clip's frames."""
        return forward_kinematics(self.longer)

    @cached_property
    def weights(self) -> Array:
        """(T,) share of the time that each of the clip's frames stands for; they sum to 1.

        The first and the last count half, so the closing frame of a cycle is not counted twice and
        the frame rate does not matter.
        """
        weights = np.ones(self.clip.frames)
        if len(weights) > 1:
            weights[[0, -1]] = 0.5
        return weights / weights.sum()

    @cached_property
    def axes(self) -> Array:
        """(3, 3) rows: to the left of the clip's heading, up, along the heading.

        The heading is where hips and shoulders face on average; for a clip that turns, where they
        face in its first half second.
        """
        facing = heading(self.pose, self.clip.skeleton.roles)[self.once]
        angle, _ = overall_heading(facing, self.clip.frame_time)
        sin, cos = np.sin(angle), np.cos(angle)
        return np.array([[cos, 0.0, -sin], [0.0, 1.0, 0.0], [sin, 0.0, cos]])

    def turned(self, vectors: Array) -> Array:
        """Vectors (..., 3) as left, up and forward."""
        return vectors @ self.axes.T

    def mean(self, values: Array) -> Array:
        """Mean over time of values (T, ...) of the clip's frames."""
        return np.tensordot(self.weights, values, axes=1)

    def spread(self, values: Array) -> Array:
        """Standard deviation over time, of the whole population, of values (T, ...)."""
        return np.sqrt(self.mean((values - self.mean(values)) ** 2))

    def velocity(self, places: Array) -> Array:
        """(T', 3) m/s of places (T', 3) in the longer clip's frames, along a cubic spline.

        Differences of frames lose what is fast at low frame rates, and only high rates have what
        is faster yet. So the path is freed of that by a zero-lag Butterworth filter, as is usual in
        gait analysis (Winter, Biomechanics and Motor Control of Human Movement, ch. 3).
        """
        if len(places) < 2:
            return np.zeros_like(places)
        cutoff = 2.0 * _CUTOFF * self.clip.frame_time
        if cutoff < 0.9 and len(places) > _PADDING:
            places = sosfiltfilt(_low_pass(cutoff), places, axis=0, padlen=_PADDING)
        times = np.arange(len(places)) * self.clip.frame_time
        return np.asarray(CubicSpline(times, places)(times, 1))


@cache
def _low_pass(cutoff: float) -> Array:
    """Butterworth filter of order 4; the cutoff is a share of half the frame rate."""
    return np.asarray(butter(4, cutoff, output="sos"))
