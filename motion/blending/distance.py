"""How far a created motion is from the target it shall match."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motion.body import ROLES
from motion.clip import Clip
from motion.errors import MotionError
from motion.kinematics import forward_kinematics
from motion.rotations import from_axis_angle, rotate
from motion.units import heading, overall_heading

Array = NDArray[np.float64]

TIMES = 10  # steps from the first compared moment to the last
JOINTS = tuple(role for role in ROLES if role != "spine")
"""The 20 joints that are compared, by role: all but the spine's, which some skeletons repeat."""

_LEVEL = np.array([1.0, 0.0, 1.0])
_GOING = 0.2  # m: whoever goes less far has no heading but their body's


def matching_distance(target: Clip, created: Clip) -> float:
    """Mean distance D of the joints of two clips at the same shares of their time, metres.

    D = mean over t = 0 … T and j = 1 … J of ‖x_target(t, j) − x_created(t, j)‖ with T = 10 even
    steps through each clip and J = 20 (Oshita et al., section 6.1, whose formula prints a sum; the
    threshold of 0.06 m is one of a mean). Both are turned to the same heading; the hips' mean way
    over the floor is taken out, and their mean place lies over the origin. Cycles of one space
    begin at their left strike, so t = 0 and t = T are a keytime of both.

    Roles that one of the skeletons lacks are left out.

    Raises:
        MotionError: if the skeletons share no role, or one has no hips.
    """
    if any("hips" not in clip.skeleton.roles for clip in (target, created)):
        raise MotionError("No joint is the hips: set that body role first.")
    shared = [
        role for role in JOINTS if role in target.skeleton.roles and role in created.skeleton.roles
    ]
    apart = _places(target, shared) - _places(created, shared)
    return float(np.linalg.norm(apart, axis=-1).mean())


def _places(clip: Clip, roles: list[str]) -> Array:
    """(T + 1, J, 3) places of joints, seen from the hips' mean way, heading for +z."""
    pose = forward_kinematics(clip)
    hips = pose.positions[:, clip.skeleton.roles["hips"]]
    share = np.linspace(0.0, 1.0, clip.frames)[:, None]
    way = (hips[-1] - hips[0]) * _LEVEL
    if np.linalg.norm(way) >= _GOING:
        angle = float(np.arctan2(way[0], way[2]))
    else:
        angle, _ = overall_heading(heading(pose, clip.skeleton.roles), clip.frame_time)
    even = hips - share * way
    # The closing frame of a cycle is its first again.
    middle = even[: -1 if clip.cyclic else None].mean(axis=0) * _LEVEL
    joints = pose.positions[:, [clip.skeleton.roles[role] for role in roles]]
    seen = rotate(
        from_axis_angle(np.array([0.0, 1.0, 0.0]), -angle), joints - _at(share, way, middle)
    )
    return _sampled(seen)


def _at(share: Array, way: Array, middle: Array) -> Array:
    """(T, 1, 3) where the hips' mean way is."""
    return (share * way + middle)[:, None]


def _sampled(places: Array) -> Array:
    """The places (F, J, 3) at even shares of the time, straight between frames."""
    at = np.linspace(0.0, len(places) - 1.0, TIMES + 1)
    low = np.minimum(at.astype(int), max(len(places) - 2, 0))
    high = np.minimum(low + 1, len(places) - 1)
    part = (at - low)[:, None, None]
    return np.asarray(places[low] + part * (places[high] - places[low]))
