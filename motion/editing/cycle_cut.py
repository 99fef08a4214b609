"""One cycle cut out of a walk or run, made to go on where it began.

The seam's difference in pose and velocity is spread over the whole cycle as a polynomial in time,
so that no moment changes much; then the feet are made to stand again.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.editing.foot_plants import SIDES, Foot, find_feet
from motion.editing.foot_repair import repair_feet
from motion.errors import MotionError
from motion.graph_window import Windows, frames_of
from motion.keytimes import contact_times, find_keytimes
from motion.kinematics import WorldPose, forward_kinematics
from motion.rotations import (
    from_axis_angle,
    from_directions,
    make_continuous,
    multiply,
    rotate,
    to_directions,
)

Array = NDArray[np.float64]

_UP = np.array([0.0, 1.0, 0.0])
_LEVEL = np.array([1.0, 0.0, 1.0])
_AROUND = 0.02  # s before and after a moment within which its velocity is looked at
_SHORTEST, _LONGEST = 0.4, 4.0  # s: a stride lasts as long
_GOING = 0.2  # m a cycle: whoever goes less far has no heading but their body's
_FEWEST = 4  # frames of a cycle
_LEG = ("thigh", "shin", "foot")

_ALL = slice(None)


def cut_cycle(clip: Clip, start: float | None = None, end: float | None = None) -> Clip:
    """One cycle of a clip, from a left strike to the next, that goes on where it began.

    Of all strides the one is taken whose ends are most alike in pose and velocity. It walks along
    +z, on level ground; frames keep their rate. A clip that is cyclic already is only begun at its
    left strike.

    Args:
        clip: a walk or run of two left strikes or more; with a start and an end, any motion.
        start: s, where the cycle begins.
        end: s, where it has begun again. Both or neither.

    Raises:
        MotionError: if no stride is found, or start and end are no part of the clip.
    """
    if start is None and end is None:
        if clip.cyclic:
            return _from_left_strike(clip)
        return _along_z(_from_left_strike(_closed(clip, *_best_stride(clip))))
    return _along_z(_closed(clip, *_asked_for(clip, start, end)))


def _closed(clip: Clip, first: int, last: int) -> Clip:
    """The cycle from first to last, seamless, its feet standing where and when they stood."""
    cycle = _seamless(clip, first, last)
    if not all(f"{s}_{part}" in clip.skeleton.roles for s in SIDES for part in _LEG):
        return cycle
    left, right = (
        replace(foot, planted=foot.planted[:, first : last + 1]) for foot in find_feet(clip)
    )
    standing = repair_feet(cycle, cycle, feet=(left, right), as_straight=True)
    # Again for a foot that now seems to stand a little earlier or longer than it did.
    return repair_feet(standing, standing, as_straight=True)


def roll_cycle(clip: Clip, frame: int) -> Clip:
    """The same cycle, begun at another of its frames, where its first frame was."""
    frame %= max(clip.frames - 1, 1)
    if frame == 0:
        return clip
    root, rotations = frames_of(clip, frame, frame + clip.frames)
    back = (root[0] - clip.root_positions[0]) * _LEVEL
    return replace(clip, root_positions=root - back, rotations=make_continuous(rotations))


def _from_left_strike(clip: Clip) -> Clip:
    strike = find_keytimes(clip).get("left_strike", 0.0)
    return roll_cycle(clip, round(strike / clip.frame_time))


def _asked_for(clip: Clip, start: float | None, end: float | None) -> tuple[int, int]:
    if start is None or end is None:
        raise MotionError("Give both the start and the end of the cycle, or neither.")
    first, last = round(start / clip.frame_time), round(end / clip.frame_time)
    if first < 0 or last > clip.frames - 1:
        raise MotionError(f"A cycle must lie within the clip, from 0 to {clip.duration:.3g} s.")
    if last - first < _FEWEST:
        raise MotionError("The cycle's end must come after its start by four frames or more.")
    return first, last


def _best_stride(clip: Clip) -> tuple[int, int]:
    """First and last frame of the stride whose ends are most alike."""
    pose = forward_kinematics(clip)
    left, right = (_strikes(clip, pose, foot) for foot in find_feet(clip, pose))
    strides = [
        (one, two)
        for one, two in pairwise(left)
        if _SHORTEST <= two - one <= _LONGEST and any(one < moment < two for moment in right)
    ]
    if not strides:
        raise MotionError(
            "No stride from one left strike to the next is in this clip: "
            "give the start and the end of the cycle."
        )
    step = clip.frame_time
    near = [
        (round(one / step), round(two / step) + more) for one, two in strides for more in (-1, 0, 1)
    ]
    inside = [(first, last) for first, last in near if first >= 0 and last < clip.frames]
    return min(inside, key=lambda ends: _difference(clip, *ends))


def _strikes(clip: Clip, pose: WorldPose, foot: Foot) -> list[float]:
    return [strike for strike, _ in contact_times(clip, pose, foot)]


def _difference(clip: Clip, first: int, last: int) -> float:
    """m, between two moments' joints and their velocities, one fitted onto the other."""
    return _window(clip, first).distance(_window(clip, last), 0, 0)


def _window(clip: Clip, frame: int) -> Windows:
    around = _stretch(clip, frame, frame)
    return Windows.of(around, around.frames - 1)


def _stretch(clip: Clip, first: int, last: int) -> Clip:
    """The frames from first to last with a moment before and after; beyond the ends it goes on."""
    low, high, end = first - _apart(clip), last + _apart(clip), clip.frames - 1
    inside = slice(max(low, 0), min(high, end) + 1)
    missing = (max(-low, 0), max(high - end, 0))
    signal = np.pad(_signal(clip, inside), (missing, (0, 0)), mode="reflect", reflect_type="odd")
    return _motion(clip, signal)


def _seamless(clip: Clip, first: int, last: int) -> Clip:
    """The cycle from first to last with its turn taken out, and its seam closed.

    What is added is gap·(1/2 − s) + bend·(s − s² − 1/6), s from 0 to 1 over the cycle: of mean 0,
    it ends by the gap lower and by twice the bend less steep than it begins.
    """
    turn, _ = _window(clip, first).alignment(_window(clip, last), 0, 0)
    apart, count = _apart(clip), last - first
    signal = _signal(_turning(_stretch(clip, first, last), turn / count))
    before, after = signal[: 2 * apart + 1], signal[count:]
    gap = after[apart] - before[apart]
    gap[[0, 2]] = 0.0  # the way that it goes
    velocity = [(part[-1] - part[0]) / (2 * apart) for part in (before, after)]
    bend = (velocity[1] - velocity[0]) * count / 2.0
    s = np.linspace(0.0, 1.0, count + 1)[:, None]
    closed = signal[apart : apart + count + 1] + gap * (0.5 - s) + bend * (s - s**2 - 1.0 / 6.0)
    motion = _motion(clip, closed)
    root, rotations = motion.root_positions.copy(), motion.rotations.copy()
    root[-1, 1], rotations[-1] = root[0, 1], rotations[0]
    return replace(motion, root_positions=root, rotations=rotations, cyclic=True)


def _turning(clip: Clip, rate: float) -> Clip:
    """The clip with its way and heading turned more and more, by so many rad a frame."""
    angles = rate * np.arange(float(clip.frames))
    ways = np.diff(clip.root_positions, axis=0)
    ways = rotate(from_axis_angle(_UP, (angles[1:] + angles[:-1]) / 2.0), ways)
    root = clip.root_positions[:1] + np.concatenate([np.zeros((1, 3)), np.cumsum(ways, axis=0)])
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(from_axis_angle(_UP, angles), rotations[:, 0])
    return replace(clip, root_positions=root, rotations=rotations)


def _along_z(clip: Clip) -> Clip:
    """The clip turned to travel along +z, or to face there, from z = 0 and about x = 0."""
    ahead = clip.travel * _LEVEL
    if np.linalg.norm(ahead) < _GOING:
        ahead = _facing(clip)
    turn = from_axis_angle(_UP, -float(np.arctan2(ahead[0], ahead[2])))
    root = rotate(turn, clip.root_positions)
    root[:, 0] -= root[:-1, 0].mean()
    root[:, 2] -= root[0, 2]
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    return replace(clip, root_positions=root, rotations=rotations)


def _facing(clip: Clip) -> Array:
    """(3,) level, where the body looks in the mean; +z for one whose thighs are not known."""
    roles = clip.skeleton.roles
    if not {"left_thigh", "right_thigh"} <= roles.keys():
        return np.array([0.0, 0.0, 1.0])
    places = forward_kinematics(clip).positions
    left = (places[:, roles["left_thigh"]] - places[:, roles["right_thigh"]]).mean(axis=0)
    return np.cross(left, _UP)


def _apart(clip: Clip) -> int:
    return max(1, round(_AROUND / clip.frame_time))


def _signal(clip: Clip, frames: slice = _ALL) -> Array:
    """(T, 3 + 6·J) the root's place and every joint's direction vectors."""
    directions = to_directions(clip.rotations[frames])
    return np.hstack([clip.root_positions[frames], directions.reshape(len(directions), -1)])


def _motion(like: Clip, signal: Array) -> Clip:
    directions = signal[:, 3:].reshape(len(signal), len(like.skeleton), 6)
    rotations = make_continuous(from_directions(directions))
    return replace(like, root_positions=signal[:, :3], rotations=rotations, cyclic=False)
