"""Bodies that move as told to, so that every measure of them is known beforehand."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from motion import Clip
from motion.ik import frame_along, solve_two_bones
from motion.procedural.bodies import BODIES, build_skeleton
from motion.rotations import conjugate, from_axis_angle, multiply, rotate

BODY = BODIES["adult"]
SKELETON = build_skeleton(BODY)
X, Y, Z = np.eye(3)
SIDES = {"left": 1.0, "right": -1.0}


def turn(axis, degrees):
    """Rotations (..., 4) about an axis."""
    return from_axis_angle(axis, np.radians(np.asarray(degrees, dtype=float)))


def times(rate: float, duration: float):
    """Seconds of each frame of a clip that ends with its closing frame."""
    return np.arange(round(rate * duration) + 1) / rate


def hanging(side: str):
    """World rotation (4,) of an arm that hangs."""
    return turn(Z, -90.0 * SIDES[side])


def robot(
    t, turns: Mapping[str, np.ndarray] | None = None, root=None, *, cyclic: bool = True
) -> Clip:
    """A clip of a standing body.

    Args:
        t: (T,) seconds of each frame.
        turns: role to world rotations (4,) or (T, 4); the others go with their parents.
        root: (T, 3) added to where the hips stand, metres.
        cyclic: closes in itself.
    """
    given = {f"{side}_upper_arm": hanging(side) for side in SIDES} | dict(turns or {})
    world: list[np.ndarray] = []
    local = []
    for joint, name in enumerate(SKELETON.names):
        parent = world[SKELETON.parents[joint]] if joint else np.tile([1.0, 0, 0, 0], (len(t), 1))
        world.append(np.broadcast_to(given.get(name, parent), (len(t), 4)))
        local.append(multiply(conjugate(parent), world[-1]))
    places = np.array([0.0, BODY.leg_length, 0.0]) + (0.0 if root is None else root)
    places = np.broadcast_to(places, (len(t), 3))
    return Clip(SKELETON, places, np.stack(local, axis=1), float(t[1] - t[0]), cyclic)


def swinging_arm(rate: float = 60, *, mean: float = 10.0, swing: float = 20.0) -> Clip:
    """The straight left arm swings as a pendulum does, degrees forward of hanging."""
    t = times(rate, 1.0)
    angle = mean + swing * np.sin(2 * np.pi * t)
    return robot(t, {"left_upper_arm": multiply(turn(X, -angle), hanging("left"))})


def walker(
    rate: float = 60, *, left: float = 0.5, right: float = 0.62, width: float = 0.16
) -> Clip:
    """One stride of a body whose feet are set down so far before and beside each other, metres.

    It lasts 1.2 s; the left foot is set down at its beginning, the right one in its middle.
    """
    t = times(rate, 1.2)
    phase = t / t[-1]
    stride = left + right
    hips = np.zeros((len(t), 3))
    hips[:, 1] = -0.09 * BODY.leg_length
    hips[:, 2] = stride * phase + (right - stride) / 2
    turns = {}
    for side, sign, set_down, start in (("left", 1, 0.0, 0.0), ("right", -1, 0.5, right)):
        way, lift = _foot_path(phase - set_down)
        ankle = np.zeros((len(t), 3))
        ankle[:, 0] = sign * width / 2
        ankle[:, 1] = BODY.ankle_height + lift
        ankle[:, 2] = start + stride * way
        turns |= _leg(side, sign, hips + np.array([0.0, BODY.leg_length, 0.0]), ankle)
    return robot(t, turns, hips)


def _foot_path(phase):
    """Strides gone and lift (m) of a foot that stands in the first 60 % of its cycle."""
    swing = np.clip((phase % 1.0 - 0.6) / 0.4, 0.0, 1.0)
    return np.floor(phase) + swing - np.sin(2 * np.pi * swing) / (2 * np.pi), 0.1 * np.sin(
        np.pi * swing
    ) ** 2


def _leg(side, sign, root, ankle):
    hip = root + np.array([sign * BODY.hip_half, 0.0, 0.0])
    leg = solve_two_bones(hip, ankle, Z, (BODY.thigh, BODY.shin))
    return {
        f"{side}_thigh": frame_along(leg.middle - hip, leg.hinge, -Y),
        f"{side}_shin": frame_along(leg.end - leg.middle, leg.hinge, -Y),
        f"{side}_foot": np.array([1.0, 0.0, 0.0, 0.0]),
    }


def moved(clip: Clip, degrees: float, to=(0.0, 0.0, 0.0)) -> Clip:
    """The clip turned about the vertical, then shifted."""
    about = turn(Y, degrees)
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(about, rotations[:, 0])
    root = rotate(about, clip.root_positions) + np.array(to)
    return Clip(clip.skeleton, root, rotations, clip.frame_time, clip.cyclic)


def mirrored(clip: Clip) -> Clip:
    """The clip in a mirror: what the left did, the right does. For skeletons that are symmetric."""
    names = clip.skeleton.names
    swap = {"left": "right", "right": "left"}
    order = []
    for name in names:
        side, _, part = name.partition("_")
        order.append(names.index(f"{swap[side]}_{part}") if side in swap else names.index(name))
    rotations = clip.rotations[:, order] * np.array([1.0, 1.0, -1.0, -1.0])
    root = clip.root_positions * np.array([-1.0, 1.0, 1.0])
    return Clip(clip.skeleton, root, rotations, clip.frame_time, clip.cyclic)
