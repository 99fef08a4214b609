"""Fourier inter- and extrapolation of cyclic clips (Unuma, Anjyo & Takeuchi 1995).

A cycle is a Fourier series over its phase. Between a neutral walk's coefficients and a sad one's
lie walks that are sadder and sadder; beyond the sad one's, exaggerated ones; before the neutral
one's, the opposite. Series are made of direction vectors, so that they may be added.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.errors import MotionError
from motion.rotations import from_directions, make_continuous, to_directions

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class Series:
    """A cycle as a function of its phase.

    Attributes:
        coefficients: (H, C) of the harmonics 0 … H − 1 of C channels: the root's place without
            its travel, then every joint's direction vectors.
        travel: (3,) m a cycle.
        duration: s of a cycle.
    """

    coefficients: Complex
    travel: Array
    duration: float

    @classmethod
    def of(cls, clip: Clip) -> Series:
        """The series of a cyclic clip.

        Raises:
            MotionError: if the clip is not cyclic or too short.
        """
        if not clip.cyclic or clip.frames < 4:
            raise MotionError("Only a cyclic clip of at least 4 frames has a Fourier series.")
        count = clip.frames - 1
        way = np.arange(count)[:, None] / count * clip.travel
        directions = to_directions(clip.rotations[:-1]).reshape(count, -1)
        signal = np.hstack([clip.root_positions[:-1] - way, directions])
        found = np.fft.rfft(signal, axis=0) / count
        found[1:] *= 2.0
        if count % 2 == 0:
            found[-1] /= 2.0  # the highest harmonic is its own mirror
        return cls(found, clip.travel, clip.duration)

    def shifted(self, phase: float) -> Series:
        """The same cycle, begun so much (in cycles) later, in the same place."""
        turn = np.exp(2j * np.pi * phase * np.arange(len(self.coefficients)))[:, None]
        return replace(self, coefficients=self.coefficients * turn)

    def at(self, phases: Array) -> Array:
        """Channels (T, C) at phases (T,) in cycles, with the travel."""
        waves = np.exp(2j * np.pi * np.outer(phases, np.arange(len(self.coefficients))))
        channels = (waves @ self.coefficients).real
        channels[:, :3] += phases[:, None] * self.travel
        return channels


def mix_cycles(first: Clip, second: Clip, amount: float, *, align: bool = True) -> Clip:
    """The cycle at ``amount`` of the way from the first to the second; 0 is the first.

    Args:
        first: cyclic.
        second: cyclic, the same skeleton.
        amount: 0 … 1 between the two, above 1 and below 0 beyond them.
        align: move the second's phase to where its legs swing with the first's.

    Raises:
        MotionError: if the clips are not cyclic, their skeletons differ, or extrapolation makes
            the cycle vanish.
    """
    if first.skeleton.content_hash != second.skeleton.content_hash:
        raise MotionError("Cycles are mixed on one skeleton; these two clips have different ones.")
    one, other = Series.of(first), Series.of(second)
    if amount == 0.0:
        return first
    if align:
        other = other.shifted(_phase_between(first, one, other))
    rows = max(len(one.coefficients), len(other.coefficients))
    a, b = (np.pad(s.coefficients, ((0, rows - len(s.coefficients)), (0, 0))) for s in (one, other))
    duration = one.duration + amount * (other.duration - one.duration)
    frames = round(duration / first.frame_time)
    if frames < 3:
        raise MotionError(f"At an amount of {amount} the cycle would last {duration:.3g} s.")
    travel = one.travel + amount * (other.travel - one.travel)
    mixed = Series(a + amount * (b - a), travel, duration)
    return _as_clip(mixed, first, frames)


def _as_clip(series: Series, like: Clip, frames: int) -> Clip:
    channels = series.at(np.arange(frames + 1) / frames)
    directions = channels[:, 3:].reshape(frames + 1, len(like.skeleton), 6)
    rotations = make_continuous(from_directions(directions))
    rotations[-1] = rotations[0]
    root = channels[:, :3]
    root[-1] = root[0] + series.travel
    return replace(like, root_positions=root, rotations=rotations)


def _phase_between(clip: Clip, one: Series, other: Series) -> float:
    """How much later (in cycles) the other begins, by the first harmonic of both thighs."""
    roles = clip.skeleton.roles
    joints = [roles[f"{s}_thigh"] for s in ("left", "right") if f"{s}_thigh" in roles]
    columns = [3 + 6 * joint + part for joint in joints for part in range(6)]
    match = np.vdot(other.coefficients[1, columns], one.coefficients[1, columns])
    return float(np.angle(match) / (2.0 * np.pi))
