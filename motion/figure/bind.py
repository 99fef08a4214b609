"""How the body stands when it is grown: torso upright, legs and arms out, feet level."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.errors import MotionError
from motion.figure import profile
from motion.figure.reference import SIDES, Reference
from motion.rotations import conjugate, from_matrix, multiply, normalise, to_matrix
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

_REQUIRED = (
    "hips",
    "head",
    *(f"{s}_{p}" for s in SIDES for p in ("upper_arm", "forearm", "thigh", "shin", "foot")),
)


@dataclass(frozen=True, eq=False)
class BindPose:
    """A skeleton standing as the body is grown around it, origin at the root joint.

    Attributes:
        skeleton: the J joints.
        positions: (J, 3) metres.
        rotations: (J, 4) world rotations, wxyz.
        local: (J, 4) the same, each relative to its parent.
        roles: body role to joint index.
        ankle_height: of each ankle joint above its sole, metres.
        scale: the body's stature over the profile's.
    """

    skeleton: Skeleton
    positions: Array
    rotations: Array
    local: Array
    roles: Mapping[str, int]
    ankle_height: Mapping[str, float]
    scale: float

    def place(self, role: str) -> Array:
        """(3,) position of a role's joint, metres."""
        return self.positions[self.roles[role]]

    def carrier(self, *roles: str) -> int:
        """Joint of the first of ``roles`` that the skeleton has."""
        return next(self.roles[role] for role in roles if role in self.roles)


def bind_pose(clip: Clip) -> BindPose:
    """The bind pose of a clip's skeleton, its joint axes known from the clip.

    Raises:
        MotionError: if the clip is empty or a role that a body cannot do without is missing.
    """
    skeleton = clip.skeleton
    missing = [role for role in _REQUIRED if role not in skeleton.roles]
    if missing:
        raise MotionError(
            f"A body needs to know which joint is {', '.join(missing)}; name them in the roles."
        )
    if clip.frames == 0:
        raise MotionError("A body needs at least one frame to know its joints' axes by.")
    reference = Reference(clip)
    axes = reference.axes()
    turns = _bind_turns(skeleton)
    world = _world_rotations(skeleton, axes, turns, reference.resting_local)
    rotations = from_matrix(world)
    positions = np.zeros((len(skeleton), 3))
    for joint in range(1, len(skeleton)):
        parent = skeleton.parents[joint]
        positions[joint] = positions[parent] + world[parent] @ skeleton.offsets[joint]
    parents = skeleton.parents[1:]
    local = np.concatenate([rotations[:1], multiply(conjugate(rotations[parents]), rotations[1:])])
    scale = _scale(skeleton, positions)
    ankles = reference.ankle_heights(scale)
    return BindPose(skeleton, positions, rotations, local, skeleton.roles, ankles, scale)


def _bind_turns(skeleton: Skeleton) -> dict[int, Array]:
    """Joint index to the turn (3, 3) of its canonical axes in the bind pose."""
    outs = {
        "thigh": profile.LEGS_OUT,
        "shin": profile.LEGS_OUT,
        "upper_arm": profile.ARMS_OUT,
        "forearm": profile.ARMS_OUT,
        "hand": profile.ARMS_OUT,
    }
    turns = {}
    for role, joint in skeleton.roles.items():
        side, _, part = role.partition("_")
        sign = {"left": 1.0, "right": -1.0}.get(side, 0.0)
        angle = sign * np.radians(outs.get(part, 0.0))
        c, s = np.cos(angle), np.sin(angle)
        turns[joint] = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return turns


def _world_rotations(
    skeleton: Skeleton, axes: Mapping[int, Array], turns: Mapping[int, Array], resting: Array
) -> Array:
    local = to_matrix(normalise(resting))
    world = np.empty((len(skeleton), 3, 3))
    for joint in range(len(skeleton)):
        parent = skeleton.parents[joint]
        if joint in axes:
            world[joint] = turns[joint] @ axes[joint].T
        elif parent < 0:
            world[joint] = local[joint]
        else:
            world[joint] = world[parent] @ local[joint]
    return world


def _scale(skeleton: Skeleton, positions: Array) -> float:
    """Stature over the profile's, from the chain of bones that carries it."""
    roles = skeleton.roles

    def length(first: str, second: str) -> float:
        return float(np.linalg.norm(positions[roles[second]] - positions[roles[first]]))

    legs = sum(
        length(f"{side}_thigh", f"{side}_shin") + length(f"{side}_shin", f"{side}_foot")
        for side in SIDES
    )
    hips = (positions[roles["left_thigh"]] + positions[roles["right_thigh"]]) / 2
    trunk = float(positions[roles["head"]][1] - hips[1])
    drawn = profile.THIGH_LENGTH + profile.SHIN_LENGTH + profile.HEAD_HEIGHT - profile.HIP_HEIGHT
    return (legs / 2 + trunk) / drawn
