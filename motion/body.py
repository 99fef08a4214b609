"""Which joint is the left forearm: body roles of foreign skeletons."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from motion.body_names import roles_by_name
from motion.body_shape import is_left, roles_by_shape
from motion.kinematics import WorldPose
from motion.skeleton import Skeleton

SIDES = ("left", "right")
_CENTRE = ("hips", "spine", "chest", "neck", "head")
_PAIRED = ("clavicle", "upper_arm", "forearm", "hand", "thigh", "shin", "foot", "toes")
ROLES = _CENTRE + tuple(f"{side}_{part}" for side in SIDES for part in _PAIRED)
"""Every body role; a role names a body segment and belongs to the joint at its near end."""

BALL_HEIGHT, ANKLE_HEIGHT = 0.016, 0.039  # above the sole, of the stature

_NEEDED_PARTS = ("upper_arm", "forearm", "thigh", "shin", "foot")
REQUIRED = ("hips", "head", *(f"{side}_{part}" for side in SIDES for part in _NEEDED_PARTS))
"""Roles without which a figure cannot be drawn."""


@dataclass(frozen=True)
class RoleGuess:
    """Roles found (role to joint index) and what was unsure about them."""

    roles: Mapping[str, int]
    notes: tuple[str, ...]

    @property
    def missing(self) -> tuple[str, ...]:
        """Roles that no joint has, the required ones first."""
        order = REQUIRED + tuple(role for role in ROLES if role not in REQUIRED)
        return tuple(role for role in order if role not in self.roles)


def detect_roles(skeleton: Skeleton, pose: WorldPose) -> RoleGuess:
    """Guess body roles from the joints' names, and from the body's shape where names say nothing.

    Args:
        skeleton: J joints; any unit, any axes.
        pose: their world pose in T ≥ 1 frames, used for up, forward and which joints turn.
    """
    shape = roles_by_shape(skeleton, pose)
    roles = _fitting(skeleton, roles_by_name(skeleton))
    notes = []
    named = sum(role in roles for role in REQUIRED)
    if 2 * named < len(REQUIRED) and all(role in shape for role in REQUIRED):
        roles = shape
        notes.append("Names did not tell the body's parts apart; its shape did")
    added = _added(roles, shape)
    if required := [role.replace("_", " ") for role in added if role in REQUIRED]:
        parts = ", ".join(required)
        notes.append(f"Names did not tell which joints are {parts}; the body's shape did")
    roles |= added
    if is_left(pose, roles) is False:
        notes.append("What the names call left lies on the body's right")
    return RoleGuess({role: roles[role] for role in ROLES if role in roles}, tuple(notes))


def _added(roles: Mapping[str, int], shape: Mapping[str, int]) -> dict[str, int]:
    """Roles that only the shape tells, of joints that have no role yet."""
    taken = set(roles.values())
    return {
        role: joint for role, joint in shape.items() if role not in roles and joint not in taken
    }


def _fitting(skeleton: Skeleton, names: Mapping[str, int]) -> dict[str, int]:
    """Named roles, without those whose limb does not hang together."""
    roles = dict(names)
    for side in SIDES:
        for limb in (("upper_arm", "forearm", "hand"), ("thigh", "shin", "foot", "toes")):
            present = [f"{side}_{part}" for part in limb if f"{side}_{part}" in roles]
            for near, far in pairwise(present):
                if not {near, far} <= roles.keys():
                    continue
                if not skeleton.hangs_from(roles[far], roles[near]):
                    roles.pop(near)
                    roles.pop(far)
    return roles


def sole_heights(pose: WorldPose, skeleton: Skeleton, stature: float) -> NDArray[np.float64]:
    """Height (T,) of the lowest point of both soles, for a pose with y up; inf without feet.

    No skeleton has a point on its soles. The joint at the ball of the foot lies about 1.6 % of the
    stature above them; without one, the ankle does, by 3.9 % (Drillis & Contini 1966).
    """
    heights = [np.full(len(pose.positions), np.inf)]
    for side in SIDES:
        toes, foot = skeleton.roles.get(f"{side}_toes"), skeleton.roles.get(f"{side}_foot")
        if toes is not None:
            heights.append(pose.positions[:, toes, 1] - BALL_HEIGHT * stature)
        elif foot is not None:
            heights.append(pose.positions[:, foot, 1] - ANKLE_HEIGHT * stature)
    return np.min(heights, axis=0)
