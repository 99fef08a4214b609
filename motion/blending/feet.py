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
_FULLY = 0.3  # weight of the examples that stand, from which on the blend stands
_HINT = 0.01  # m: how much a straight knee is told which way is ahead


@dataclass(frozen=True, eq=False)
class SolePoint:
    """Means of the examples' signals of one point of a sole.

    Attributes:
        joint: that carries it.
        offset: (3,) in the joint's frame, m.
        place: (T, 3) m.
        stands: (T,) how much the foot stands on it, from 0 to 1 as soon as some examples do.
        excess: (T, 2) level velocity, in m by the length of the blend, that it has because other
            examples' points have left their place already.
    """

    joint: int
    offset: Array
    place: Array
    stands: Array
    excess: Array

    @classmethod
    def read(
        cls, joint: int, offset: Array, columns: Array, gone: Array, after: Array
    ) -> SolePoint:
        """From the blended columns (T, 6), the travel (T, 3) and that after the last (3,)."""
        place = columns[:, :3] + gone
        part = np.clip(columns[:, 3] / _FULLY, 0.0, 1.0)
        slope = part * (3.0 - 2.0 * part)  # of the smooth step from 0 to 1, seen from 0
        stands = part * slope
        ahead = np.concatenate([place[1:], (columns[0, :3] + after)[None]])
        velocity = (ahead - place)[:, [0, 2]] * len(place)
        # Less the mean velocity of the points that stand, which are not quite still in recordings.
        still = np.where(part < 1.0, slope / _FULLY, 1.0 / np.maximum(columns[:, 3], _FULLY))
        excess = stands[:, None] * velocity - still[:, None] * columns[:, 4:6]
        return cls(joint, offset, place, stands, excess)


@dataclass(frozen=True, eq=False)
class BlendedFoot:
    """Means of the examples' signals of one foot, the travel put in again.

    Attributes:
        foot: its joints.
        ankle: (T, 3) m.
        turn: (T, 4) world rotation.
        lowest: (T,) m, height of the lowest point of the sole.
        points: of its sole.
    """

    foot: Foot
    ankle: Array
    turn: Array
    lowest: Array
    points: tuple[SolePoint, ...]

    @classmethod
    def read(
        cls, foot: Foot, offsets: Sequence[Array], columns: Array, gone: Array, after: Array
    ) -> BlendedFoot:
        """From the blended columns (T, 10 + 6 a point); ``gone`` (T, 3) is the travel.

        ``after`` (3,) is the travel one frame after the last.
        """
        points = []
        for index, (point, offset) in enumerate(zip(foot.points, offsets, strict=True)):
            part = columns[:, 10 + 6 * index : 16 + 6 * index]
            points.append(SolePoint.read(point.joint, offset, part, gone, after))
        turn = from_directions(columns[:, 3:9])
        return cls(foot, columns[:, :3] + gone, turn, columns[:, 9], tuple(points))

    def goal(self, pose: WorldPose) -> Array:
        """(T, 3) place of the ankle that leaves the point on which the foot stands in its place.

        A mean of turned feet is a little shorter than they are: without this the heel would move
        by some millimetres while it stands.
        """
        ankle = self.foot.ankle
        back = conjugate(pose.rotations[:, ankle])
        change, heights = np.zeros_like(self.ankle), []
        for point, share in zip(self.points, self._shares(), strict=True):
            here = pose.positions[:, point.joint]
            here = here + rotate(pose.rotations[:, point.joint], point.offset)
            reach = rotate(self.turn, rotate(back, here - pose.positions[:, ankle]))
            change += share * (point.place - self.ankle - reach)
            heights.append(self.ankle[:, 1] + reach[:, 1])
        change[:, [0, 2]] -= self._drift()
        change[:, 1] = (1.0 - self._swings()) * (self.lowest - np.min(heights, axis=0))
        return self.ankle + change

    def _swings(self) -> Array:
        """(T,) 1 in the air, 0 while a point of the sole stands."""
        return np.asarray(np.prod([1.0 - point.stands for point in self.points], axis=0))

    def _shares(self) -> list[Array]:
        """For each point how much (T, 1) it tells the foot's place."""
        total = np.maximum(sum(point.stands for point in self.points), 1.0)
        return [(point.stands / total)[:, None] for point in self.points]

    def _drift(self) -> Array:
        """(T, 2) level way that the standing foot has slid, m; taken back while it swings.

        Examples do not leave the floor with the same point at the same time: while one of them
        stands, the mean of all would slide with those that are off.
        """
        shares = self._shares()
        rate = np.sum([s * p.excess for s, p in zip(shares, self.points, strict=True)], axis=0)
        swings = self._swings()[:, None]
        if swings.sum() < 1.0:
            swings = np.ones_like(swings)
        rate = (rate - rate.sum(axis=0) * swings / swings.sum()) / len(rate)
        drift = np.cumsum(rate, axis=0) - rate
        stands = 1.0 - swings + 1e-9
        return np.asarray(drift - (stands * drift).sum(axis=0) / stands.sum())


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
