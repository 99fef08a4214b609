"""When the feet of a cyclic walk or run strike the floor and leave it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_propagation

from motion.clip import Clip
from motion.editing.cycles import three_cycles
from motion.editing.foot_plants import (
    LOW,
    STRICT,
    ContactPoint,
    Foot,
    find_feet,
    leg_length,
    motion_level,
    resting_frames,
    runs,
    steady_speed,
)
from motion.errors import MotionError
from motion.kinematics import WorldPose, forward_kinematics
from motion.rotations import conjugate, rotate

Array = NDArray[np.float64]

Keytimes = Mapping[str, float]
"""Event name to seconds from the clip's first frame, from 0 up to, not including, its duration."""

EVENTS = ("left_strike", "left_off", "right_strike", "right_off")
"""A foot's heel strikes when it comes to stand; its toes are off when it stands no more."""

# A foot strikes with its heel and leaves with its toes' tip, which both lie beyond the joints. How
# far, in lengths from ankle to floor and from ankle to ball; the moments hardly depend on it.
_HEEL, _TIP = 0.7, 0.6
# Shares of its fastest below which the heel has struck and the tip is not yet off: a heel comes to
# rest at once, while toes roll on before they leave.
_STRUCK, _ROLLING = 0.08, 0.12


def find_keytimes(clip: Clip) -> dict[str, float]:
    """Seconds of each of the ``EVENTS`` in a cyclic clip; none where its feet do not step.

    Of each foot's plants the longest counts. Moments lie between frames where they belong, and a
    cycle that begins elsewhere has the same ones, shifted.

    Returns:
        Event to seconds from the first frame, in [0, duration). Empty for a clip that is not
        cyclic, for a skeleton without legs, and if a foot never or always stands.
    """
    if not clip.cyclic or clip.frames < 4:
        return {}
    three = three_cycles(clip)
    pose = forward_kinematics(three)
    try:
        feet = find_feet(three, pose)
    except MotionError:
        return {}
    found: dict[str, float] = {}
    for foot in feet:
        plant = _longest(contact_times(three, pose, foot), clip.duration)
        if plant is None:
            return {}
        for event, moment in zip(("strike", "off"), plant, strict=True):
            found[f"{foot.side}_{event}"] = _within(moment, clip.duration)
    return found


def contact_times(clip: Clip, pose: WorldPose, foot: Foot) -> list[tuple[float, float]]:
    """When a foot strikes and when it is off, in seconds, for each time that it stands.

    A plant that the clip's first or last frame cuts short is left out.
    """
    whole = ((a, b) for a, b in _edges(clip, pose, foot) if a > 0.0 and b < clip.frames - 1.0)
    return [(a * clip.frame_time, b * clip.frame_time) for a, b in whole]


def standing_times(clip: Clip) -> dict[str, list[tuple[float, float]]]:
    """Foot's side to when it is on the floor, from strike to off, in seconds of the clip.

    By the same edges as ``find_keytimes``. What goes on over a cycle's end is told as two.

    Raises:
        MotionError: if a leg's roles are missing.
    """
    shown = three_cycles(clip) if clip.cyclic else clip
    before = clip.duration if clip.cyclic else 0.0
    pose = forward_kinematics(shown)
    return {
        foot.side: _inside(_edges(shown, pose, foot), before, clip)
        for foot in find_feet(shown, pose)
    }


def _inside(
    edges: list[tuple[float, float]], before: float, clip: Clip
) -> list[tuple[float, float]]:
    """Frames as seconds from a moment on; of what is cut off, no less than a frame is kept."""
    seconds = (np.array(edge) * clip.frame_time - before for edge in edges)
    kept = (np.clip(edge, 0.0, clip.duration).tolist() for edge in seconds)
    return [(start, stop) for start, stop in kept if stop - start >= clip.frame_time]


def _edges(clip: Clip, pose: WorldPose, foot: Foot) -> list[tuple[float, float]]:
    """Frames, fractional, between which a foot stands; the first and last where it is cut short."""
    ends = _ends(clip, pose, foot)
    levels = [motion_level(p.positions(pose), clip, foot.side) for p in (*foot.points, *ends)]
    level = early = late = np.min(levels, axis=0)
    if ends:
        low = LOW * leg_length(clip, foot.side)
        heel, tip = (point.positions(pose) for point in ends)
        early = np.minimum(level, _end_level(heel, clip.frame_time, _STRUCK, low))
        late = np.minimum(level, _end_level(tip, clip.frame_time, _ROLLING, low))
    stands = np.asarray(binary_propagation(level < STRICT, mask=level < 1.0))
    return _joined(
        [(_edge(early, plant.start, -1), _edge(late, plant.stop - 1, 1)) for plant in runs(stands)]
    )


def _joined(stretches: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Stretches in order, those that overlap as one."""
    found: list[tuple[float, float]] = []
    for start, stop in stretches:
        if found and start <= found[-1][1]:
            found[-1] = (found[-1][0], max(stop, found[-1][1]))
        else:
            found.append((start, stop))
    return found


def _end_level(places: Array, frame_time: float, share: float, low: float) -> Array:
    """How far (T,) the heel or the tip is from standing, by a share of its greatest speed."""
    speed = steady_speed(places, frame_time)
    return np.maximum(speed / (share * max(float(speed.max()), 1e-9)), places[:, 1] / low)


def _ends(clip: Clip, pose: WorldPose, foot: Foot) -> list[ContactPoint]:
    """The heel and the toes' tip on the floor; none for a foot without toes."""
    if len(foot.points) < 2:
        return []
    sole, ball = foot.points
    resting = resting_frames(pose, [sole.joint, ball.joint], clip.frame_time)
    places = pose.positions[resting]
    ahead = (places[:, ball.joint] - places[:, sole.joint]) * np.array([1.0, 0.0, 1.0])
    found = []
    for point, share in ((sole, -_HEEL * float(np.linalg.norm(sole.offset))), (ball, _TIP)):
        local = rotate(conjugate(pose.rotations[resting, point.joint]), ahead).mean(axis=0)
        way = local if point is ball else local / np.linalg.norm(local)
        found.append(ContactPoint(point.joint, point.offset + share * way))
    return found


def _edge(level: Array, frame: int, way: int) -> float:
    """Frame, fractional, at which a level comes to 1 on the way from a frame where it is below.

    The first or last frame if it never does.
    """
    beyond = np.flatnonzero(level[frame::way] >= 1.0)
    if len(beyond) == 0:
        return 0.0 if way < 0 else len(level) - 1.0
    there = frame + way * int(beyond[0])
    here = there - way
    return here + way * float((1.0 - level[here]) / (level[there] - level[here]))


def _longest(plants: list[tuple[float, float]], duration: float) -> tuple[float, float] | None:
    """The longest of the plants that begin in the middle one of three cycles."""
    # A thousandth of a cycle more: one that begins right at the seam is in at one of its ends.
    slack = 1e-3 * duration
    middle = [p for p in plants if duration - slack <= p[0] < 2.0 * duration + slack]
    return max(middle, key=lambda plant: round((plant[1] - plant[0]) / slack), default=None)


def _within(moment: float, duration: float) -> float:
    inside = moment % duration
    return 0.0 if np.isclose(inside, duration, rtol=1e-12) else inside
