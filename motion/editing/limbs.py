"""Arms, legs and head: the parts that have a timing of their own."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.kinematics import WorldPose
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

_ROOTS = {"arm": ("clavicle", "upper_arm"), "leg": ("thigh",)}
_ENDS = {"arm": ("hand", "forearm"), "leg": ("foot",)}
LIMBS = ("left_arm", "right_arm", "left_leg", "right_leg", "head")


@dataclass(frozen=True)
class Limb:
    """One limb.

    Attributes:
        name: one of LIMBS.
        joints: its joints, the root first; everything that hangs from the root belongs to it.
        end: the joint whose path counts.
    """

    name: str
    joints: tuple[int, ...]
    end: int

    @property
    def root(self) -> int:
        """The joint that the limb hangs from the trunk by."""
        return self.joints[0]


def find_limbs(skeleton: Skeleton) -> dict[str, Limb]:
    """The limbs whose body roles are known."""
    found = {}
    for name in LIMBS:
        side, _, kind = name.rpartition("_")
        roots = [f"{side}_{role}" for role in _ROOTS.get(kind, ())] or ["neck", "head"]
        ends = [f"{side}_{role}" for role in _ENDS.get(kind, ())] or ["head"]
        root = next((skeleton.roles[role] for role in roots if role in skeleton.roles), None)
        end = next((skeleton.roles[role] for role in ends if role in skeleton.roles), None)
        if root is not None and end is not None:
            found[name] = Limb(name, _descendants(skeleton, root), end)
    return found


def is_locomoting(clip: Clip) -> bool:
    """Whether the body goes somewhere: its way on the floor is longer than half a leg."""
    roles = clip.skeleton.roles
    leg = sum(
        float(np.linalg.norm(clip.skeleton.offsets[roles[role]]))
        for role in ("left_shin", "left_foot")
        if role in roles
    )
    way = np.ptp(clip.root_positions[:, [0, 2]], axis=0)
    return bool(np.hypot(*way) > 0.5 * (leg or 0.8))


def end_relative_to_hips(clip: Clip, pose: WorldPose, limb: Limb) -> Array:
    """Path (T, 3) of a limb's end relative to the hips, in world directions, metres."""
    hips = clip.skeleton.roles.get("hips", 0)
    return pose.positions[:, limb.end] - pose.positions[:, hips]


def _descendants(skeleton: Skeleton, root: int) -> tuple[int, ...]:
    inside = {root}
    for joint in range(root + 1, len(skeleton)):
        if int(skeleton.parents[joint]) in inside:
            inside.add(joint)
    return tuple(sorted(inside))
