"""Motion warping (Witkin & Popović 1995): a pose is put right, what is around it follows.

A keyframe says how some joints shall be turned at one frame. What that changes there is spread
smoothly over the time around it and added to the motion, whose details stay. Moments may be moved
in time as well.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline, PchipInterpolator
from scipy.spatial.transform import Rotation

from motion.clip import Clip
from motion.editing.timing import resample
from motion.errors import MotionError
from motion.rotations import conjugate, multiply

Array = NDArray[np.float64]

_XYZW, _WXYZ = [1, 2, 3, 0], [3, 0, 1, 2]
CLOSEST = 1e-3  # s between moments: nearer ones would ask for speeds beyond all numbers


@dataclass(frozen=True, eq=False)
class Keyframe:
    """What shall be at one frame; everything not named stays.

    Attributes:
        frame: number in the clip.
        rotations: joint to local rotation (4,).
        root: (3,) metres; None leaves the root where it is.
    """

    frame: int
    rotations: Mapping[int, Array] = field(default_factory=dict)
    root: Array | None = None


def warp_poses(
    clip: Clip, keyframes: Sequence[Keyframe], amount: float = 1.0, *, reach: float = 0.5
) -> Clip:
    """The clip bent so that it passes through keyframes.

    Args:
        clip: any clip.
        keyframes: in any order, each frame at most once.
        amount: 0 leaves the clip, 1 meets the keyframes.
        reach: s before the first and after the last keyframe of a joint, beyond which nothing
            changes.

    Raises:
        MotionError: if a keyframe is outside the clip or given twice.
    """
    ordered = _checked(clip, keyframes)
    if amount == 0.0 or not ordered:
        return clip
    spread = max(1.0, reach / clip.frame_time)
    rotations, root = clip.rotations.copy(), clip.root_positions.copy()
    for joint in {joint for key in ordered for joint in key.rotations}:
        keys = [key for key in ordered if joint in key.rotations]
        frames = [key.frame for key in keys]
        here = clip.rotations[frames, joint]
        there = np.array([key.rotations[joint] for key in keys])
        bent = _spread(clip.frames, frames, _logarithm(multiply(conjugate(here), there)), spread)
        rotations[:, joint] = multiply(clip.rotations[:, joint], _exponential(amount * bent))
    held = [(key.frame, key.root) for key in ordered if key.root is not None]
    if held:
        frames = [frame for frame, _ in held]
        ways = np.array([place - root[frame] for frame, place in held])
        root += amount * _spread(clip.frames, frames, ways, spread)
    return replace(clip, rotations=rotations, root_positions=root)


def warp_time(clip: Clip, moments: Sequence[tuple[float, float]], amount: float = 1.0) -> Clip:
    """The clip in another timing; length, first and last frame stay.

    Args:
        clip: any clip.
        moments: (s, s) when something happens and when it shall happen.
        amount: 0 leaves the clip, 1 moves the moments all the way.

    Raises:
        MotionError: if moments touch or overtake each other, or leave the clip.
    """
    if amount == 0.0 or not moments:
        return clip
    was, wanted = np.array(sorted([(0.0, 0.0), *moments, (clip.duration, clip.duration)])).T
    shown = was + amount * (wanted - was)
    if min(np.diff(was).min(), np.diff(shown).min()) < CLOSEST:
        raise MotionError(
            f"Moments {list(moments)} must lie {CLOSEST * 1000:g} ms apart or more, also from the "
            f"ends, in the same order before and after, within the {clip.duration:.3g} s of the "
            "clip."
        )
    frames = np.arange(clip.frames)
    source = PchipInterpolator(shown, was)(frames * clip.frame_time) / clip.frame_time
    path = CubicSpline(frames, clip.root_positions)
    rotations = resample(clip.rotations, source)
    return replace(clip, rotations=rotations, root_positions=path(source))


def _checked(clip: Clip, keyframes: Sequence[Keyframe]) -> list[Keyframe]:
    ordered = sorted(keyframes, key=lambda key: key.frame)
    frames = [key.frame for key in ordered]
    if len(set(frames)) != len(frames):
        raise MotionError(f"Keyframes {frames}: each frame can be set once.")
    if any(not 0 <= frame < clip.frames for frame in frames):
        raise MotionError(f"Keyframes {frames} must lie within frames 0 to {clip.frames - 1}.")
    return ordered


def _spread(count: int, frames: Sequence[int], values: Array, reach: float) -> Array:
    """Values (count, 3) through the given ones (K, 3), monotone between them, 0 beyond reach."""
    zero = np.zeros((1, values.shape[1]))
    at = np.concatenate([[frames[0] - reach], frames, [frames[-1] + reach]])
    curve = PchipInterpolator(at, np.concatenate([zero, values, zero]))
    return curve(np.clip(np.arange(count), at[0], at[-1]))


def _logarithm(rotations: Array) -> Array:
    return Rotation.from_quat(rotations[:, _XYZW]).as_rotvec()


def _exponential(vectors: Array) -> Array:
    return Rotation.from_rotvec(vectors).as_quat()[:, _WXYZ]
