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
    """A point of a sole in a blend.

    Attributes:
        joint: that carries it.
        offset: (3,) in the joint's frame, m.
        stands: (T,) how much the foot stands on it: from 0 to 1 as soon as some examples do.
        way: (T, 2) level way to the next frame of the examples that stand, m, times ``stands``:
            in recordings they are not quite still.
    """

    joint: int
    offset: Array
    stands: Array
    way: Array

    @classmethod
    def read(cls, joint: int, offset: Array, columns: Array) -> SolePoint:
        """From the blended columns (T, 3): how firmly it stands, and its velocity times that."""
        firm = columns[:, 0]
        part = np.clip(firm / _FULLY, 0.0, 1.0)
        slope = part * (3.0 - 2.0 * part)  # of the smooth step from 0 to 1, seen from 0
        by = np.where(part < 1.0, slope / _FULLY, 1.0 / np.maximum(firm, _FULLY))
        return cls(joint, offset, part * slope, by[:, None] * columns[:, 1:3] / len(columns))


@dataclass(frozen=True, eq=False)
class BlendedFoot:
    """Means of the examples' signals of one foot, the travel put in again.

    Attributes:
        foot: its joints.
        ankle: (T, 3) m.
        turn: (T, 4) world rotation.
        lowest: (T,) m, height of the lowest point of the sole.
        points: of its sole.
        travel: (3,) m, from the first frame to the one after the last; None if there is none.
    """

    foot: Foot
    ankle: Array
    turn: Array
    lowest: Array
    points: tuple[SolePoint, ...]
    travel: Array | None

    @classmethod
    def read(
        cls,
        foot: Foot,
        offsets: Sequence[Array],
        columns: Array,
        gone: Array,
        travel: Array | None,
    ) -> BlendedFoot:
        """From the blended columns (T, 10 + 3 a point); ``gone`` (T, 3) is the travel till then."""
        points = tuple(
            SolePoint.read(point.joint, offset, columns[:, start : start + 3])
            for point, offset, start in zip(foot.points, offsets, (10, 13), strict=False)
        )
        turn = from_directions(columns[:, 3:9])
        return cls(foot, columns[:, :3] + gone, turn, columns[:, 9], points, travel)

    def goal(self, pose: WorldPose) -> Array:
        """(T, 3) place of the ankle, such that the point on which the foot stands keeps its place.

        It is the mean of the examples' ankles, less what the sole would slide: examples do not
        roll over their feet alike, and a mean of turned feet is a little shorter than they are.
        While it stands, the lowest point of the sole is as high as the examples' in the mean.
        """
        soles = self._soles(pose)
        goal = self.ankle.copy()
        goal[:, [0, 2]] -= self._slid(soles)
        lowest = np.min([sole[:, 1] for sole in soles], axis=0)
        goal[:, 1] += (1.0 - self._swings()) * (self.lowest - lowest)
        return goal

    def _soles(self, pose: WorldPose) -> list[Array]:
        """Where (T, 3) each point is if the ankle is at its mean place."""
        ankle = self.foot.ankle
        turn = multiply(self.turn, conjugate(pose.rotations[:, ankle]))
        found = []
        for point in self.points:
            here = pose.positions[:, point.joint] - pose.positions[:, ankle]
            here = here + rotate(pose.rotations[:, point.joint], point.offset)
            found.append(self.ankle + rotate(turn, here))
        return found

    def _swings(self) -> Array:
        """(T,) 1 in the air, 0 while a point of the sole stands."""
        return np.asarray(np.prod([1.0 - point.stands for point in self.points], axis=0))

    def _slid(self, soles: Sequence[Array]) -> Array:
        """(T, 2) level way that the standing foot has slid, m; taken back while it swings."""
        total = np.maximum(np.sum([point.stands for point in self.points], axis=0), 1.0)
        ways = np.zeros((len(total), 2))
        for point, sole in zip(self.points, soles, strict=True):
            after = sole[-1:] if self.travel is None else sole[:1] + self.travel
            way = np.diff(sole, axis=0, append=after)[:, [0, 2]]
            ways += (point.stands[:, None] * way - point.way) / total[:, None]
        back = self._swings() ** 2
        if back.sum() < 1.0:
            back = np.ones_like(back)
        ways -= ways.sum(axis=0) * (back / back.sum())[:, None]
        slid = np.cumsum(ways, axis=0) - ways
        stands = 1.0 - self._swings() + 1e-9
        return np.asarray(slid - (stands @ slid) / stands.sum())


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
