"""When a limb is fast and when it is slow: even speed and added acceleration (Förger, ch. 3.4.3).

Every limb's flow of time is stretched and squeezed; all its joints share the warp, so the way of
its end relative to the limb's root stays what it was and only the speed along it changes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.ndimage import gaussian_filter1d, maximum_filter1d

from motion.clip import Clip
from motion.editing.limbs import LIMBS, Limb, end_relative_to_hips, find_limbs, is_locomoting
from motion.kinematics import WorldPose, forward_kinematics
from motion.rotations import from_directions, to_directions

Array = NDArray[np.float64]

EVEN, ADDED = "even", "added"
SEGMENT = {EVEN: 1.5, ADDED: 1.0}  # s: a stretch that keeps its length, so that limbs stay together
_RATE = 100.0  # Hz at which limbs are looked at, as in the thesis
_CUTOFF = 12.5  # Hz: speeds above are the recording's noise
_PAUSE = 0.12  # of a segment's high speed: slower than this is a pause
_SET = 0.15  # s: an added pause lies between fast moments on both sides in this time
_LONGER = 10.0  # times: how much longer an added pause lasts
_CLEARLY = 0.25  # of the segment's high speed: what a pause's surroundings must reach
_FASTEST = 0.05  # of the mean duration: no frame gets less, or its motion would be skipped


@dataclass(frozen=True)
class Timing:
    """What happens to the speed of the limbs.

    Attributes:
        kind: ``even`` or ``added`` acceleration.
        limbs: which limbs; None for all, but not the legs of a clip that goes somewhere (the
            thesis found that walks break).
        segment: s; a stretch that keeps its length, so that limbs stay together; None for the
            thesis's, 1.5 for even speed and 1.0 for added acceleration.
        amount: 0 changes nothing, 1 is the thesis's, between and beyond by the power of durations.
    """

    kind: str
    limbs: tuple[str, ...] | None = None
    segment: float | None = None
    amount: float = 1.0


def change_timing(clip: Clip, timing: Timing) -> Clip:
    """The clip with each limb's frames in new time; length, first and last frame stay."""
    if clip.frames < 4 or timing.amount == 0.0:
        return clip
    pose = forward_kinematics(clip)
    rotations = clip.rotations.copy()
    for limb in _chosen(clip, timing):
        warp = limb_warp(clip, pose, limb, timing)
        joints = list(limb.joints)
        rotations[:, joints] = resample(clip.rotations[:, joints], warp)
    return replace(clip, rotations=rotations)


def limb_warp(clip: Clip, pose: WorldPose, limb: Limb, timing: Timing) -> Array:
    """Which frame (T,), fractional, of the clip a limb shows in each frame.

    It is worked out at one rate for all clips, so that pauses are found where they are at any.
    """
    last = clip.frames - 1
    count = max(3, round(clip.duration * _RATE))
    fine = np.linspace(0.0, last, count + 1)
    step = clip.duration / count
    speed = _speed(smooth_path(end_relative_to_hips(clip, pose, limb), fine), step)
    durations = np.empty_like(speed)
    longest = SEGMENT[timing.kind] if timing.segment is None else timing.segment
    for segment in _segments(count, step, longest):
        part = speed[segment]
        new = _even(part) if timing.kind == EVEN else _added(part, step)
        new = (new / new.mean()) ** timing.amount
        durations[segment] = new * (len(part) / new.sum())
    shown_at = np.concatenate([[0.0], np.cumsum(durations)])
    shown_at[-1] = count
    return np.interp(np.arange(clip.frames), shown_at * (last / count), fine)


def limb_speed(clip: Clip, pose: WorldPose, limb: Limb) -> Array:
    """Speed (T − 1,) of a limb's end relative to the hips, m/s, low-passed at 12.5 Hz."""
    return _speed(end_relative_to_hips(clip, pose, limb), clip.frame_time)


def _speed(path: Array, step: float) -> Array:
    # The velocity is low-passed, not its magnitude, in which noise would add up. A Gaussian, whose
    # amplitude falls to 1/√2 at the cut-off, has no overshoot.
    deviation = np.sqrt(np.log(2.0)) / (2.0 * np.pi * _CUTOFF) / step
    velocity = np.diff(path, axis=0) / step
    return np.linalg.norm(gaussian_filter1d(velocity, deviation, axis=0, mode="nearest"), axis=1)


def resample(rotations: Array, frames: Array, *, cyclic: bool = False) -> Array:
    """Local rotations (T', J, 4) at fractional frames (T',) of (T, J, 4), on a smooth path.

    Of a cycle the last frame is the first again, and the path is as smooth over the seam.
    """
    return from_directions(smooth_path(to_directions(rotations), frames, cyclic=cyclic))


def smooth_path(values: Array, frames: Array, *, cyclic: bool = False) -> Array:
    """Values (T', ...) at fractional frames (T',) of (T, ...), by a cubic spline."""
    if cyclic:
        values[-1] = values[0]
    numbers = np.arange(len(values))
    return CubicSpline(numbers, values, bc_type="periodic" if cyclic else "not-a-knot")(frames)


def _chosen(clip: Clip, timing: Timing) -> Iterable[Limb]:
    limbs = find_limbs(clip.skeleton)
    names = timing.limbs
    if names is None:
        without_legs = is_locomoting(clip)
        names = tuple(n for n in LIMBS if not (without_legs and n.endswith("_leg")))
    return [limbs[name] for name in names if name in limbs]


def _segments(count: int, frame_time: float, longest: float) -> Iterator[slice]:
    pieces = max(1, int(np.ceil(count * frame_time / longest - 1e-9)))
    edges = np.round(np.linspace(0, count, pieces + 1)).astype(int)
    return (slice(a, b) for a, b in pairwise(edges))


def _even(speed: Array) -> Array:
    """Durations proportional to speed; pauses keep what they had, in the mean of the rest."""
    pause = _PAUSE * np.quantile(speed, 0.95)
    if pause <= 0.0:
        return np.ones_like(speed)
    moving = speed > pause
    held = speed[moving].mean() if moving.any() else 1.0
    share = np.clip((speed - pause) / pause, 0.0, 1.0)  # 0 in a pause, 1 from twice its limit on
    durations = share * speed + (1.0 - share) * held
    return np.maximum(durations, _FASTEST * durations.mean())


def _added(speed: Array, step: float) -> Array:
    """Durations ten times as long around each slow moment between fast ones.

    How slow it is shows against what is reached within a set on both sides, whichever is less; so
    a stretch that stays slow for longer has no such moment. Nothing is decided by a threshold that
    a small difference could pass.
    """
    reach = max(1, round(_SET / step))
    # One-sided windows: the farther end of a window of reach + 1 frames.
    before, after = (
        maximum_filter1d(speed, reach + 1, mode="nearest", origin=side * (reach // 2))
        for side in (1, -1)
    )
    around = np.minimum(before, after)
    depth = 1.0 - speed / np.maximum(around, 1e-12)
    clearly = np.clip(around / (_CLEARLY * max(float(np.quantile(speed, 0.95)), 1e-12)) - 0.5, 0, 1)
    return 1.0 + (_LONGER - 1.0) * depth * clearly
