"""What the frames of a clip tell about its joints' axes.

A skeleton says where its joints are, not which way a knee bends or a face looks. Over a clip's
frames, each joint's axes are compared with the way that the character faces, a planted sole is
taken to be level, and an estimate near an axis of the joint snaps to that axis, so that a clip
performed with the head bowed still yields a level gaze.

Canonical axes of a body segment, as matrix columns: x to the character's left, y up, z forward,
standing upright with hanging arms.
"""

from __future__ import annotations

from functools import cached_property
from itertools import permutations, product

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.figure import profile
from motion.kinematics import WorldPose, forward_kinematics
from motion.rotations import between, from_matrix, to_matrix
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

SIDES = ("left", "right")

_TRUNK = ("hips", "spine", "chest", "neck", "head")
_FRAMES = 400  # enough to know a joint's axes by
_CLEAR_BEND = np.sin(np.radians(15.0))  # of a limb, before it tells where the limb bends to
_STRAIGHT = 0.7  # cosine between bones that count as one line in the skeleton's zero pose
_SNAP = np.radians(45.0)
_SNAP_SOLE = np.radians(6.0)
# Every right-handed frame whose axes lie along the joint's own.
_AXIS_FRAMES = np.array(
    [
        frame
        for order in permutations(range(3))
        for signs in product((1.0, -1.0), repeat=3)
        if np.linalg.det(frame := np.eye(3)[list(order)] * np.array(signs)) > 0
    ]
)


class Reference:
    """What the frames of a clip tell about its joints' axes."""

    def __init__(self, clip: Clip) -> None:
        step = max(1, clip.frames // _FRAMES)
        part = Clip(
            clip.skeleton,
            clip.root_positions[::step],
            clip.rotations[::step],
            clip.frame_time * step,
        )
        self.clip = part
        self.skeleton = clip.skeleton
        self.roles = clip.skeleton.roles
        self.pose: WorldPose = forward_kinematics(part)
        self.heading = self._heading()

    def _heading(self) -> Array:
        """(T, 3, 3) level frames facing where the character faces."""
        places = self.pose.positions
        across = np.zeros((len(places), 3))
        for part in ("thigh", "upper_arm"):
            across += places[:, self.roles[f"left_{part}"]] - places[:, self.roles[f"right_{part}"]]
        across[:, 1] = 0.0
        length = np.linalg.norm(across, axis=1, keepdims=True)
        left = np.where(length > 1e-6, across / np.maximum(length, 1e-6), [1.0, 0.0, 0.0])
        up = np.broadcast_to([0.0, 1.0, 0.0], left.shape)
        return np.stack([left, up, np.cross(left, up)], axis=-1)

    def axes(self) -> dict[int, Array]:
        """Joint index to its canonical axes (3, 3) in the joint's own frame."""
        found: dict[int, Array] = {}
        for role, joint in self.roles.items():
            if role in _TRUNK or role.endswith("_clavicle"):
                found[joint] = snapped(self._mean_axes(joint, self.heading))
        for side in SIDES:
            found |= self._chain_axes(side, ("upper_arm", "forearm", "hand"), 1.0)
            found |= self._chain_axes(side, ("thigh", "shin"), -1.0)
            found |= self._foot_axes(side)
        return found

    def _chain_axes(self, side: str, parts: tuple[str, ...], flexes: float) -> dict[int, Array]:
        """Axes along a limb whose middle joint bends to the front (``flexes`` 1) or back (−1).

        The first bone's front is where the next one bends to. The next joints take over that
        front: a skeleton's zero pose holds a limb straight and untwisted. Where it does not, or
        where the clip never bends the limb, the way that the character faces must do.
        """
        found: dict[int, Array] = {}
        front, before = None, None
        for part in parts:
            role = f"{side}_{part}"
            if role not in self.roles:
                continue
            joint = self.roles[role]
            bone = self._bone(joint, role)
            if before is None and bone is not None:
                follower = self.roles[f"{side}_{parts[1]}"]
                bent = self._bends_to(joint, follower, bone, f"{side}_{parts[1]}")
                front = None if bent is None else flexes * bent
            if bone is None:
                axes = snapped(self._mean_axes(joint, self.heading))
            elif front is None or (before is not None and bone @ before < _STRAIGHT):
                axes = self._limb_axes(joint, bone)
            else:
                axes = about(-bone, snapped(about(-bone, front))[:, 2])
            found[joint] = axes
            front, before = axes[:, 2], bone if bone is not None else before
        return found

    def _bends_to(self, near: int, far: int, bone: Array, far_role: str) -> Array | None:
        """(3,) way in which the far bone leaves the near one's line, in the near joint's frame."""
        far_bone = self._bone(far, far_role)
        if far_bone is None:
            return None
        near_turns, far_turns = (to_matrix(self.pose.rotations[:, joint]) for joint in (near, far))
        ways = np.einsum("tji,tj->ti", near_turns, far_turns @ far_bone)
        aside = ways - (ways @ bone)[:, None] * bone
        bend = np.linalg.norm(aside, axis=1)
        clear = bend > _CLEAR_BEND
        if not clear.any():
            return None
        mean = aside[clear].sum(axis=0) / bend[clear].sum()
        return _unit(mean) if np.linalg.norm(mean) > 0.5 else None

    def _bone(self, joint: int, role: str) -> Array | None:
        """(3,) unit way from a limb's joint to the next role's, in its own resting frame."""
        follow = {"upper_arm": "forearm", "forearm": "hand", "thigh": "shin", "shin": "foot"}
        side, _, _ = role.partition("_")
        part = role.removeprefix(f"{side}_")
        target = self.roles.get(f"{side}_{follow[part]}") if part in follow else None
        if part == "hand" or (part == "forearm" and target is None):
            target = _far_child(self.skeleton, joint)
        if target is None:
            return self._beyond(joint, side) if part in ("forearm", "hand") else None
        turns = to_matrix(self.resting_local)
        way = np.zeros(3)
        while target != joint:
            parent = int(self.skeleton.parents[target])
            way = self.skeleton.offsets[target] + turns[target] @ way
            if parent < 0:
                return None
            target = parent
        length = float(np.linalg.norm(way))
        return way / length if length > 1e-4 else None

    def _beyond(self, joint: int, side: str) -> Array | None:
        """(3,) unit way of a limb's last segment: to its tip, or else on along the bone before."""
        tip = _tip(self.skeleton, joint)
        before = self.roles[f"{side}_forearm"]
        if tip is not None or int(self.skeleton.parents[joint]) != before:
            return tip
        bone = self._bone(before, f"{side}_forearm")
        return None if bone is None else to_matrix(self.resting_local[joint]).T @ bone

    def _mean_axes(self, joint: int, frames: Array, weights: Array | None = None) -> Array:
        """(3, 3) mean over time of world frames (T, 3, 3), seen from a joint."""
        turns = to_matrix(self.pose.rotations[:, joint])
        seen = np.einsum("tji,tjk->tik", turns, frames)
        return np.average(seen, axis=0, weights=weights)

    def _limb_axes(self, joint: int, bone: Array) -> Array:
        """Axes of a limb: y against the bone, z forward as it would hang without a twist."""
        turns = to_matrix(self.pose.rotations[:, joint])
        along = turns @ bone
        down = np.broadcast_to([0.0, -1.0, 0.0], along.shape)
        frames = to_matrix(between(down, along)) @ self.heading
        mean = self._mean_axes(joint, frames, weights=1.02 - along[:, 1])
        return about(-bone, snapped(mean)[:, 2])

    def _foot_axes(self, side: str) -> dict[int, Array]:
        """Axes of foot and toes, level while the sole is planted."""
        foot = self.roles[f"{side}_foot"]
        toes = self.roles.get(f"{side}_toes", _far_child(self.skeleton, foot))
        planted = self._planted(side)
        turns = to_matrix(self.pose.rotations[planted, foot])
        up = _unit(turns.mean(axis=0)[1])
        nearest = np.eye(3)[np.argmax(np.abs(up))] * np.sign(up[np.argmax(np.abs(up))])
        up = nearest if np.arccos(np.clip(up @ nearest, -1, 1)) < _SNAP_SOLE else up
        if toes is None:
            forward = snapped(self._mean_axes(foot, self.heading))[:, 2]
        else:
            forward = self.skeleton.offsets[toes]
        found = {foot: about(up, forward)}
        toe_role = self.roles.get(f"{side}_toes")
        if toe_role is not None:
            level = turns @ found[foot]
            toe_turns = to_matrix(self.pose.rotations[planted, toe_role])
            mean = np.einsum("tji,tjk->tik", toe_turns, level).mean(axis=0)
            found[toe_role] = polar(mean)
        return found

    def _planted(self, side: str) -> NDArray[np.intp]:
        """Frames in which a foot stands: slow and low, by ankle and ball."""
        foot = self.roles[f"{side}_foot"]
        toes = self.roles.get(f"{side}_toes", _far_child(self.skeleton, foot))
        points = self.pose.positions[:, [foot] if toes is None else [foot, toes]]
        if len(points) < 3:
            return np.arange(len(points))
        speed = np.linalg.norm(np.gradient(points, axis=0), axis=2).sum(axis=1)
        height = points[..., 1].sum(axis=1)
        low = height <= height.min() + 0.3 * (np.median(height) - height.min()) + 0.02
        ranked = np.flatnonzero(low)[np.argsort(speed[low], kind="stable")]
        return ranked[: max(3, len(points) // 8)]

    def ankle_heights(self, scale: float) -> dict[str, float]:
        """Height of each ankle above its sole: the floor's distance where that is plausible."""
        usual = profile.ANKLE_HEIGHT * scale
        found = {}
        for side in SIDES:
            joint = self.roles[f"{side}_foot"]
            height = float(np.median(self.pose.positions[self._planted(side), joint, 1]))
            found[side] = float(np.clip(height, 0.55 * usual, 1.3 * usual))
        return found

    @cached_property
    def resting_local(self) -> Array:
        """(J, 4) local rotations in which joints without a role of their own rest."""
        means = to_matrix(self.clip.rotations).mean(axis=0)
        return from_matrix(np.array([snapped(mean) for mean in means]))


def _tip(skeleton: Skeleton, joint: int) -> Array | None:
    """(3,) unit way from a chain's last joint to the farthest end site it carries, if any."""
    tips = [np.array(site.offset) for site in skeleton.end_sites if site.joint == joint]
    longest = max(tips, key=lambda tip: float(np.linalg.norm(tip)), default=np.zeros(3))
    length = float(np.linalg.norm(longest))
    return longest / length if length > 1e-3 else None


def _far_child(skeleton: Skeleton, joint: int) -> int | None:
    """The child that lies farthest from a joint, if any lies away from it."""
    children = np.flatnonzero(skeleton.parents == joint)
    if len(children) == 0:
        return None
    lengths = np.linalg.norm(skeleton.offsets[children], axis=1)
    return int(children[np.argmax(lengths)]) if lengths.max() > 1e-3 else None


def _unit(vector: Array) -> Array:
    return vector / max(float(np.linalg.norm(vector)), 1e-12)


def polar(matrix: Array) -> Array:
    """The rotation nearest to a (3, 3) matrix."""
    u, _, vt = np.linalg.svd(matrix)
    u[:, -1] *= np.sign(np.linalg.det(u @ vt))
    return u @ vt


def snapped(mean: Array) -> Array:
    """The axis-aligned frame near a mean of frames; where none is near, the mean's own."""
    turn = polar(mean)
    traces = np.einsum("fij,ij->f", _AXIS_FRAMES, turn)
    best = int(np.argmax(np.round(traces, 6)))
    angle = np.arccos(np.clip((traces[best] - 1.0) / 2.0, -1.0, 1.0))
    return _AXIS_FRAMES[best] if angle < _SNAP else turn


def about(up: Array, forward: Array) -> Array:
    """The frame with y along ``up`` and z as near to ``forward`` as that allows."""
    z = _unit(forward - (forward @ up) * up)
    return np.stack([np.cross(up, z), up, z], axis=1)
