"""Standing differently: offsets from captured poses, added to every frame (Förger, ch. 3.4.2).

A pose is known by body roles and in canonical axes (x to the left, y up, z forward in upright
standing, the same for every skeleton), so that an offset carries over to any character unchanged.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.editing.limbs import Limb, find_limbs
from motion.kinematics import WorldPose, forward_kinematics, pose_to_world
from motion.rotations import conjugate, from_directions, rotate, to_directions
from motion.standing import Standing

Array = NDArray[np.float64]
Joints = NDArray[np.intp]

FADE_FROM, FADE_TO = 0.5, 0.9  # of a limb's length: how far its end strays until the offset is gone
Pose = Mapping[str, Array]  # body role to local rotation (4,) in canonical axes


@dataclass(frozen=True, eq=False)
class PostureOffset:
    """A changed standing pose less the neutral one.

    Attributes:
        directions: body role to the difference (6,) of that joint's direction vectors.
    """

    directions: Mapping[str, Array]

    @classmethod
    def between(cls, neutral: Pose, changed: Pose) -> PostureOffset:
        """The offset of the roles that both poses know."""
        roles = [role for role in neutral if role in changed]
        return cls({r: to_directions(changed[r]) - to_directions(neutral[r]) for r in roles})


def capture_pose(clip: Clip, frame: int) -> Pose:
    """The pose of one frame, from which offsets can be made for any skeleton.

    Raises:
        IndexError: if the clip has no such frame.
    """
    canonical = Standing.of(clip).canonical(clip.rotations[frame])
    return {role: canonical[joint] for role, joint in clip.skeleton.roles.items()}


def add_posture(
    clip: Clip, offsets: Sequence[tuple[PostureOffset, float]], standing: Standing | None = None
) -> Clip:
    """The clip with each offset added, times its amount.

    Offsets add before the vectors are made orthonormal again, so their order does not matter.
    Where a limb's end strays from where it hangs in standing, the offset of that limb fades out.

    Args:
        clip: a clip whose skeleton has body roles.
        offsets: pairs of offset and amount; 0 changes nothing, 1 is as captured.
        standing: of the motion before other edits, where it is known; None finds it in the clip.
    """
    roles = clip.skeleton.roles
    total = {roles[role]: way for role, way in _sum(offsets).items() if role in roles}
    if not total:
        return clip
    standing = standing or Standing.of(clip)
    joints = np.array(list(total))
    shares = _fades(clip, standing, joints)[..., None] * np.array(list(total.values()))
    moved = to_directions(standing.canonical(clip.rotations[:, joints], joints)) + shares
    rotations = clip.rotations.copy()
    rotations[:, joints] = standing.from_canonical(from_directions(moved), joints)
    return replace(clip, rotations=rotations)


def _sum(offsets: Sequence[tuple[PostureOffset, float]]) -> dict[str, Array]:
    total: dict[str, Array] = {}
    for offset, amount in offsets:
        for role, directions in offset.directions.items():
            if amount != 0.0 and np.any(directions):
                total[role] = total.get(role, np.zeros(6)) + amount * directions
    return total


def _fades(clip: Clip, standing: Standing, joints: Joints) -> Array:
    """(T, K) share of an offset that each of K joints takes in each frame.

    It falls as the end of the joint's limb leaves where it hangs, seen from the hips.
    """
    fades = np.ones((clip.frames, len(joints)))
    limbs = [
        (limb, np.isin(joints, limb.joints))
        for limb in find_limbs(clip.skeleton).values()
        if limb.name != "head" and not set(limb.joints).isdisjoint(joints.tolist())
    ]
    if not limbs:
        return fades
    ends = [limb.end for limb, _ in limbs]
    upright = pose_to_world(clip.skeleton, np.zeros((1, 3)), standing.local[None])
    strayed = _seen_from_hips(clip, forward_kinematics(clip), ends)
    strayed = np.linalg.norm(strayed - _seen_from_hips(clip, upright, ends), axis=-1)
    for (limb, inside), way in zip(limbs, strayed.T, strict=True):
        share = way / max(_length(clip, limb), 1e-9)
        fade = np.clip((FADE_TO - share) / (FADE_TO - FADE_FROM), 0.0, 1.0)
        fades[:, inside] = fade[:, None]
    return fades


def _length(clip: Clip, limb: Limb) -> float:
    """Metres from a limb's root to its end, along the bones."""
    bones = clip.skeleton.offsets[[j for j in limb.joints if limb.root < j <= limb.end]]
    return float(np.linalg.norm(bones, axis=1).sum())


def _seen_from_hips(clip: Clip, pose: WorldPose, joints: list[int]) -> Array:
    """Positions (T, K, 3) of joints in the hips' own frame, metres."""
    hips = clip.skeleton.roles.get("hips", 0)
    way = pose.positions[:, joints] - pose.positions[:, [hips]]
    return rotate(conjugate(pose.rotations[:, [hips]]), way)
