"""The whole body faster or slower, at another frame rate, or a part of the clip."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.editing.timing import resample, smooth_path
from motion.errors import MotionError

Array = NDArray[np.float64]

_WHOLE = 0.05  # of a frame: files round their frame time, and nobody misses that much


def change_tempo(clip: Clip, factor: float) -> Clip:
    """The clip in 1/factor of its time, at the same frame rate.

    What is left of it after its last whole frame falls away; a cycle is kept whole, to which end
    it becomes longer or shorter by at most half a frame.

    Args:
        clip: any clip; a cyclic one stays cyclic.
        factor: above 1 is faster, below 1 slower, 1 changes nothing.

    Raises:
        MotionError: if the factor is not above 0.
    """
    if not (np.isfinite(factor) and factor > 0.0):
        raise MotionError(f"A tempo of {factor:g} is not possible: it must be above 0.")
    if factor == 1.0 or clip.frames < 2:
        return clip
    return at_frames(clip, _every(clip, factor))


def resample_rate(clip: Clip, rate: float) -> Clip:
    """The same motion with so many frames a second.

    What is left of it after its last whole frame falls away; a cycle is kept whole, to which end
    it becomes longer or shorter by at most half a frame.

    Args:
        clip: any clip; a cyclic one stays cyclic.
        rate: frames a second.

    Raises:
        MotionError: if the rate is not above 0.
    """
    if not (np.isfinite(rate) and rate > 0.0):
        raise MotionError(f"A frame rate of {rate:g} is not possible: it must be above 0.")
    wanted = 1.0 / rate
    if clip.frames < 2 or np.isclose(wanted, clip.frame_time, rtol=1e-9):
        return replace(clip, frame_time=wanted)
    return replace(at_frames(clip, _every(clip, wanted / clip.frame_time)), frame_time=wanted)


def _every(clip: Clip, step: float) -> Array:
    """Fractional frames so far apart; a cycle's from end to end, as near to that as they can."""
    last = clip.frames - 1
    if clip.cyclic:
        return np.linspace(0.0, last, max(1, round(last / step)) + 1)
    return np.minimum(np.arange(int(last / step + _WHOLE) + 1) * step, last)


def cut(clip: Clip, start: float, end: float) -> Clip:
    """The frames from ``start`` to ``end``, both included; a part of a cycle is no cycle.

    Args:
        clip: any clip.
        start: s from the clip's beginning.
        end: s from the clip's beginning.

    Raises:
        MotionError: if the two lie outside the clip or less than a frame apart.
    """
    if not 0.0 <= start < end <= clip.duration + clip.frame_time / 2.0:
        raise MotionError(
            f"From {start:g} s to {end:g} s there is nothing to cut out: the clip lasts "
            f"{clip.duration:.3g} s, and the end must come after the start."
        )
    first, last = round(start / clip.frame_time), round(end / clip.frame_time)
    if first == last:
        raise MotionError(f"Between {start:g} s and {end:g} s lies less than one frame.")
    part = slice(first, last + 1)
    whole = first == 0 and last == clip.frames - 1
    return replace(
        clip,
        root_positions=clip.root_positions[part],
        rotations=clip.rotations[part],
        cyclic=clip.cyclic and whole,
    )


def at_frames(clip: Clip, frames: Array) -> Clip:
    """The clip as it is at fractional frames (T',), on a smooth path; each becomes one frame.

    Args:
        clip: T ≥ 2 frames. A cyclic one must be shown from its first frame to its last.
        frames: in [0, T − 1].
    """
    rotations = resample(clip.rotations, frames, cyclic=clip.cyclic)
    # Less its travel, a cycle's path closes too.
    travel = clip.travel if clip.cyclic else np.zeros(3)
    per_frame = travel / (clip.frames - 1)
    level = clip.root_positions - np.arange(clip.frames)[:, None] * per_frame
    root = smooth_path(level, frames, cyclic=clip.cyclic) + frames[:, None] * per_frame
    return replace(clip, root_positions=root, rotations=rotations)
