"""Legs that bring the feet of a blend to where the examples' feet are in the mean."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.editing.foot_plants import Foot
from motion.ik import solve_two_bones
from motion.kinematics import WorldPose
from motion.rotations import between, conjugate, from_directions, multiply, rotate
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

_NOTHING = 1e-9  # m: a foot that is off by less is where it shall be
_HINT = 0.01  # m: how much a straight knee is told which way is ahead


@dataclass(frozen=True, eq=False)
class BlendedFoot:
    """Means of the examples' signals of one foot, the travel put in again.

    Attributes:
        foot: its joints.
        ankle: (T, 3) m.
        turn: (T, 4) world rotation.
        points: for each point of its sole, joint, offset (3,) in the joint's frame, place (T, 3)
            and how much (T,) the foot stands on it.
    """

    foot: Foot
    ankle: Array
    turn: Array
    points: tuple[tuple[int, Array, Array, Array], ...]

    @classmethod
    def read(cls, foot: Foot, offsets: Sequence[Array], columns: Array, gone: Array) -> BlendedFoot:
        """From the blended columns (T, 9 + 4 a point); ``gone`` (T, 3) is the travel."""
        points = []
        for index, (point, offset) in enumerate(zip(foot.points, offsets, strict=True)):
            part = columns[:, 9 + 4 * index : 13 + 4 * index]
            points.append((point.joint, offset, part[:, :3] + gone, part[:, 3]))
        turn = from_directions(columns[:, 3:9])
        return cls(foot, columns[:, :3] + gone, turn, tuple(points))

    def goal(self, pose: WorldPose) -> Array:
        """(T, 3) place of the ankle that leaves the point on which the foot stands in its place.

        A mean of turned feet is a little shorter than they are: without this the heel would move
        by some millimetres while it stands.
        """
        ankle = self.foot.ankle
        back = conjugate(pose.rotations[:, ankle])
        change, total = np.zeros_like(self.ankle), np.zeros((len(self.ankle), 1))
        for joint, offset, place, stands in self.points:
            point = pose.positions[:, joint] + rotate(pose.rotations[:, joint], offset)
            reach = rotate(self.turn, rotate(back, point - pose.positions[:, ankle]))
            change += stands[:, None] * (place - self.ankle - reach)
            total += stands[:, None]
        return self.ankle + change / np.maximum(total, 1.0)


def onto_feet(
    skeleton: Skeleton, pose: WorldPose, rotations: Array, feet: Sequence[BlendedFoot]
) -> None:
    """Turn the legs in ``rotations`` (T, J, 4) such that the feet are where they shall be.

    Args:
        skeleton: J joints.
        pose: the world pose of the rotations as they are.
        rotations: local; changed.
        feet: where they shall be.
    """
    for blended in feet:
        foot, target = blended.foot, blended.goal(pose)
        hip, knee, ankle = (pose.positions[:, j] for j in (foot.thigh, foot.shin, foot.ankle))
        gap = np.linalg.norm(target - ankle, axis=-1).max()
        whole = np.zeros((len(target), 4))
        whole[:, 0] = 1.0
        first = second = whole
        if gap > _NOTHING:
            upper, lower = knee - hip, ankle - knee
            lengths = (_length(upper), _length(lower))
            pole = _knee_way(hip, knee, ankle, blended.turn, min(_HINT, float(gap)))
            solved = solve_two_bones(hip, target, pole, lengths)
            first = between(_unit(upper), _unit(solved.middle - hip))
            second = between(_unit(rotate(first, lower)), _unit(solved.end - solved.middle))
        both = multiply(second, first)
        parents = skeleton.parents
        above = pose.rotations[:, parents[foot.thigh]]
        thigh = multiply(first, pose.rotations[:, foot.thigh])
        rotations[:, foot.thigh] = multiply(conjugate(above), thigh)
        over_shin = multiply(first, pose.rotations[:, parents[foot.shin]])
        shin = multiply(both, pose.rotations[:, foot.shin])
        rotations[:, foot.shin] = multiply(conjugate(over_shin), shin)
        over_ankle = multiply(both, pose.rotations[:, parents[foot.ankle]])
        rotations[:, foot.ankle] = multiply(conjugate(over_ankle), blended.turn)


def _knee_way(hip: Array, knee: Array, ankle: Array, turn: Array, hint: float) -> Array:
    """(T, 3) whither the knee points: where it does, and a little ahead in case it is straight."""
    limb = _unit(ankle - hip)
    out = knee - hip
    out = out - np.sum(out * limb, axis=-1, keepdims=True) * limb
    return out + hint * np.array([0.0, 0.0, 1.0])


def _length(vectors: Array) -> float:
    return float(np.linalg.norm(vectors, axis=-1).mean())


def _unit(vectors: Array) -> Array:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-12)
