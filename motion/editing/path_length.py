"""Longer and shorter motion paths by multiresolution filtering (Förger, ch. 3.4.1).

The signal of every channel is split into bands by a 5-tap low-pass whose taps move apart by a
factor of two from level to level (Bruderlin and Williams 1995); the bands are scaled and summed
again. The filter is symmetric, so nothing shifts in phase, and versions can be interpolated.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.errors import MotionError
from motion.rotations import (
    from_directions,
    from_euler,
    make_continuous,
    normalise,
    to_directions,
    to_euler,
)

Array = NDArray[np.float64]

DIRECTIONS, QUATERNIONS, ANGLES = "directions", "quaternions", "angles"
_ORDER = "ZXY"  # of the angles: as most BVH files have it
_REPRESENTATIONS: Mapping[str, tuple[Callable[[Array], Array], Callable[[Array], Array]]] = {
    DIRECTIONS: (to_directions, from_directions),
    QUATERNIONS: (make_continuous, normalise),
    ANGLES: (lambda turns: to_euler(turns, _ORDER), lambda angles: from_euler(angles, _ORDER)),
}

_CENTRE, _NEAR, _FAR = 3 / 8, 1 / 4, 1 / 16  # the kernel c b a b c
_AT_ONCE = 32_000  # samples filtered at once, to stay in the processor's cache


@dataclass(frozen=True)
class PathLength:
    """How much each frequency is scaled.

    Attributes:
        gain: of the middle band; above 1 lengthens paths, below 1 shortens them, 1 changes nothing.
        low_edge: Hz; up to here the gain is 1, so that average poses and travel stay.
        full_from: Hz; from here on the gain is in force. Between the two it is interpolated over
            log frequency: a walk's stride lies at the thesis's hard edge of 1 Hz, where small
            differences in cadence would decide whether the arms follow.
        high_edge: Hz; from here on the gain falls towards ``high_gain``.
        high_full: Hz; from here on ``high_gain`` is in force.
        high_gain: of noise and jitter; an edit that changes nothing keeps them.
    """

    gain: float = 1.0
    low_edge: float = 0.35
    full_from: float = 0.6
    high_edge: float = 10.0
    high_full: float = 16.0
    high_gain: float = 0.25

    def __call__(self, frequency: Array) -> Array:
        """Gain (...) at frequencies (...) in Hz."""
        if self.gain == 1.0:
            return np.ones_like(frequency)
        octave = np.log(np.maximum(frequency, 1e-12))
        edges = np.log([self.low_edge, self.full_from, self.high_edge, self.high_full])
        return np.interp(octave, edges, [1.0, self.gain, self.gain, self.high_gain])


def change_path_length(
    clip: Clip, gains: Callable[[Array], Array], representation: str = DIRECTIONS
) -> Clip:
    """The clip with every joint's rotation filtered; the root's path is left to foot repair.

    Args:
        clip: any clip; a cyclic one is wrapped around, so that its seam stays seamless.
        gains: gain of each frequency in Hz, such as ``PathLength``.
        representation: what of a rotation is filtered: ``directions``, or, to see why not,
            ``quaternions`` or Euler ``angles``, which jump where they wrap around.

    Raises:
        MotionError: if there is no such representation.
    """
    if representation not in _REPRESENTATIONS:
        known = ", ".join(_REPRESENTATIONS)
        raise MotionError(f"Rotations cannot be filtered as “{representation}”, only as {known}.")
    forth, back = _REPRESENTATIONS[representation]
    signal = forth(clip.rotations)
    flat = signal.reshape(clip.frames, -1)
    if clip.cyclic:
        filtered = scale_bands(flat[:-1], gains, 1.0 / clip.frame_time, cyclic=True)
        filtered = np.concatenate([filtered, filtered[:1]])
    else:
        filtered = scale_bands(flat, gains, 1.0 / clip.frame_time)
    return replace(clip, rotations=back(filtered.reshape(signal.shape)))


def scale_bands(
    signal: Array, gains: Callable[[Array], Array], rate: float, *, cyclic: bool = False
) -> Array:
    """A signal (T, C) with its frequency bands scaled: G(n) + Σ gain_k·L(k).

    Args:
        signal: T samples of C channels.
        gains: gain of each band's centre frequency in Hz.
        rate: samples a second.
        cyclic: the signal repeats after T samples; otherwise it is lengthened to twice its length
            by its first and last values.
    """
    if len(signal) < 2:
        return signal.copy()
    centres = gains(band_centres(len(signal), rate))
    levels = [(float(g), s) for g, s in zip(centres, _spacings(len(signal)), strict=True)]
    while levels and levels[-1][0] == 1.0:
        levels.pop()
    channels = np.array(signal.T, order="C")
    count = max(1, _AT_ONCE // len(signal))
    for start in range(0, len(channels), count):
        part = slice(start, start + count)
        channels[part] = _scaled(channels[part], levels, cyclic)
    return np.ascontiguousarray(channels.T)


def _scaled(signal: Array, levels: list[tuple[float, int]], cyclic: bool) -> Array:
    """Channels (C, T) with each level's band scaled by its gain."""
    frames = signal.shape[1]
    before = 0 if cyclic else frames // 2
    after = 0 if cyclic else frames - before
    low = np.pad(signal, ((0, 0), (before, after)), mode="edge")
    change = np.zeros_like(low)
    for gain, spacing in levels:
        lower = _low_pass(low, spacing, cyclic=cyclic)
        if gain != 1.0:
            change += (gain - 1.0) * (low - lower)
        low = lower
    # Adding what changes, instead of summing all bands again, keeps an unchanged signal to the bit.
    return signal + change[:, before : before + frames]


def band_centres(frames: int, rate: float) -> Array:
    """Centre frequencies (n,) in Hz of the bands of a signal of that many samples: rate/2^(k+2)."""
    return np.array([rate / (4.0 * spacing) for spacing in _spacings(frames)])


def _spacings(frames: int) -> list[int]:
    """Distance of the kernel's taps on each of the n levels, where 2^n ≤ frames ≤ 2^(n+1)."""
    return [2**level for level in range(int(np.log2(frames)))]


def _low_pass(signal: Array, spacing: int, *, cyclic: bool) -> Array:
    """Channels (C, T) less what is faster than the kernel, its taps so far apart."""
    reach, frames = 2 * spacing, signal.shape[1]
    padded = np.pad(signal, ((0, 0), (reach, reach)), mode="wrap" if cyclic else "edge")

    def taps(shift: int) -> Array:
        before, after = reach - shift * spacing, reach + shift * spacing
        return padded[:, before : before + frames] + padded[:, after : after + frames]

    return _CENTRE * signal + _NEAR * taps(1) + _FAR * taps(2)
