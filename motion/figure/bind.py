"""How the body stands when it is grown: joint axes from roles and motion, then the bind pose.

A skeleton says where its joints are, not which way a knee bends or a face looks. The clip tells:
over its frames, each joint's axes are compared with the way that the character faces, a planted
sole is taken to be level, and an estimate near an axis of the joint snaps to that axis, so that a
clip performed with the head bowed still yields a level gaze.

Canonical axes of a body segment, as matrix columns: x to the character's left, y up, z forward,
standing upright with hanging arms.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import permutations, product

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.errors import MotionError
from motion.figure import profile
from motion.kinematics import WorldPose, forward_kinematics
from motion.rotations import between, conjugate, from_matrix, multiply, normalise, to_matrix
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

SIDES = ("left", "right")
_REQUIRED = (
    "hips",
    "head",
    *(f"{s}_{p}" for s in SIDES for p in ("upper_arm", "forearm", "thigh", "shin", "foot")),
)
_TRUNK = ("hips", "spine", "chest", "neck", "head")
_FRAMES = 400  # enough to know a joint's axes by
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
    reference = _Reference(clip)
    axes = reference.axes()
    turns = _bind_turns(skeleton)
    world = _world_rotations(skeleton, axes, turns, reference.resting_local())
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


class _Reference:
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
            part = role.partition("_")[2] if role.startswith(SIDES) else role
            if part in ("foot", "toes"):
                continue
            bone = self._bone(joint, role)
            if role in _TRUNK or part == "clavicle" or bone is None:
                found[joint] = _snapped(self._mean_axes(joint, self.heading))
            else:
                found[joint] = self._limb_axes(joint, bone)
        for side in SIDES:
            found |= self._foot_axes(side)
        return found

    def _bone(self, joint: int, role: str) -> Array | None:
        """(3,) unit way from a limb's joint to the next role's, in its own resting frame."""
        follow = {"upper_arm": "forearm", "forearm": "hand", "thigh": "shin", "shin": "foot"}
        side, _, _ = role.partition("_")
        part = role.removeprefix(f"{side}_")
        target = self.roles.get(f"{side}_{follow[part]}") if part in follow else None
        if part == "hand" or (part == "forearm" and target is None):
            target = _far_child(self.skeleton, joint)
        if target is None:
            return None
        turns = to_matrix(self.resting_local())
        way = np.zeros(3)
        while target != joint:
            parent = int(self.skeleton.parents[target])
            way = self.skeleton.offsets[target] + turns[target] @ way
            if parent < 0:
                return None
            target = parent
        length = float(np.linalg.norm(way))
        return way / length if length > 1e-4 else None

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
        return _about(-bone, _snapped(mean)[:, 2])

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
            forward = _snapped(self._mean_axes(foot, self.heading))[:, 2]
        else:
            forward = self.skeleton.offsets[toes]
        found = {foot: _about(up, forward)}
        toe_role = self.roles.get(f"{side}_toes")
        if toe_role is not None:
            level = turns @ found[foot]
            toe_turns = to_matrix(self.pose.rotations[planted, toe_role])
            mean = np.einsum("tji,tjk->tik", toe_turns, level).mean(axis=0)
            found[toe_role] = _polar(mean)
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

    def resting_local(self) -> Array:
        """(J, 4) local rotations in which joints without a role of their own rest."""
        if not hasattr(self, "_resting"):
            means = to_matrix(self.clip.rotations).mean(axis=0)
            self._resting = from_matrix(np.array([_snapped(mean) for mean in means]))
        return self._resting


def _far_child(skeleton: Skeleton, joint: int) -> int | None:
    """The child that lies farthest from a joint, if any lies away from it."""
    children = np.flatnonzero(skeleton.parents == joint)
    if len(children) == 0:
        return None
    lengths = np.linalg.norm(skeleton.offsets[children], axis=1)
    return int(children[np.argmax(lengths)]) if lengths.max() > 1e-3 else None


def _unit(vector: Array) -> Array:
    return vector / max(float(np.linalg.norm(vector)), 1e-12)


def _polar(matrix: Array) -> Array:
    """The rotation nearest to a (3, 3) matrix."""
    u, _, vt = np.linalg.svd(matrix)
    u[:, -1] *= np.sign(np.linalg.det(u @ vt))
    return u @ vt


def _snapped(mean: Array) -> Array:
    """The axis-aligned frame near a mean of frames; where none is near, the mean's own."""
    turn = _polar(mean)
    traces = np.einsum("fij,ij->f", _AXIS_FRAMES, turn)
    best = int(np.argmax(np.round(traces, 6)))
    angle = np.arccos(np.clip((traces[best] - 1.0) / 2.0, -1.0, 1.0))
    return _AXIS_FRAMES[best] if angle < _SNAP else turn


def _about(up: Array, forward: Array) -> Array:
    """The frame with y along ``up`` and z as near to ``forward`` as that allows."""
    z = _unit(forward - (forward @ up) * up)
    return np.stack([np.cross(up, z), up, z], axis=1)


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
