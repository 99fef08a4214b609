"""Where the feet of a blend are: in the mean of the examples, and still while they stand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.editing.foot_plants import Foot, motion_level
from motion.kinematics import WorldPose
from motion.rotations import conjugate, from_directions, multiply, rotate

Array = NDArray[np.float64]

_FIRM = 0.5  # of the limits of height and speed: that much below them a point stands firmly
_FULLY = 0.1  # firmness from which on a point is kept in its place
_ALIKE = 0.004  # m, standard deviation of the ankles: examples that differ less are about alike
_SLOW = 0.02  # m/s: points of a sole slower than this stand alike
_AROUND = 0.1  # s before and after a cycle that are looked at for speeds at its ends


def firmness(sole: Array, travel: Array | None, clip: Clip, side: str) -> Array:
    """How firmly (T,) a point of a sole stands, by its path (T, 3) in metres.

    1 where it is about at rest on the floor, 0 where it is too high or too fast to stand.

    Args:
        sole: of a cycle without the closing frame.
        travel: (3,) m, the travel of a cycle; None if it is none.
        clip: whose skeleton and frame time count.
        side: left or right.
    """
    if travel is None:
        level = motion_level(sole, clip, side)
    else:
        around = min(len(sole), max(3, round(_AROUND / clip.frame_time)))
        longer = np.concatenate([sole[-around:] - travel, sole, sole[:around] + travel])
        level = motion_level(longer, clip, side)[around:-around]
    share = np.clip((1.0 - level) / _FIRM, 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))


@dataclass(frozen=True, eq=False)
class SolePoint:
    """A point of a sole in a blend.

    Attributes:
        joint: that carries it.
        offset: (3,) in the joint's frame, m.
        firm: (T,) how firmly it stands in the examples.
        way: (T, 2) its level way to the next frame, m, times that: in recordings those that stand
            are not quite still.
    """

    joint: int
    offset: Array
    firm: Array
    way: Array

    def place(self, ankle: Array, turn: Array, pose: WorldPose, joint: int) -> Array:
        """Its place (T, 3) on a foot that is moved from a pose's ankle joint to another place."""
        here = pose.positions[:, self.joint] - pose.positions[:, joint]
        here = here + rotate(pose.rotations[:, self.joint], self.offset)
        return ankle + rotate(turn, here)


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
        own: how much is kept of the way that examples slide while they stand: all of it for one
            alone, less the more examples differ.
    """

    foot: Foot
    ankle: Array
    turn: Array
    lowest: Array
    points: tuple[SolePoint, ...]
    travel: Array | None
    own: float

    def goal(self, clip: Clip, pose: WorldPose) -> Array:
        """(T, 3) place of the ankle, such that the point on which the foot stands keeps its place.

        It is the mean of the examples' ankles, less what the sole would slide: examples do not
        roll over their feet alike, and a mean of turned feet is a little shorter than they are.
        While it stands, the lowest point of the sole is as high as the examples' in the mean.

        Args:
            clip: the blend so far.
            pose: its world pose.
        """
        joint = self.foot.ankle
        turn = multiply(self.turn, conjugate(pose.rotations[:, joint]))
        soles = [point.place(self.ankle, turn, pose, joint) for point in self.points]
        slid, swings = self._slid(soles, clip)
        lowest = np.min([sole[:, 1] for sole in soles], axis=0)
        goal = self.ankle.copy()
        goal[:, [0, 2]] -= slid
        goal[:, 1] += (1.0 - swings) * (self.lowest - lowest)
        return goal

    def _slid(self, soles: Sequence[Array], clip: Clip) -> tuple[Array, Array]:
        """(T, 2) m, the level way that the standing foot has slid; and (T,) 1 where it swings.

        It stands as long as one of the examples does, or as it would by itself.
        """
        alone = np.stack([firmness(sole, self.travel, clip, self.foot.side) for sole in soles])
        firm = np.maximum(np.stack([point.firm for point in self.points]), alone)
        by = _held(firm)
        ways = np.stack([self._way(sole) for sole in soles])
        allowed = self.own * np.stack([point.way for point in self.points])
        too_far = by[..., None] * (firm[..., None] * ways - allowed)
        # It stands on the point that would stand by itself; of two, on the slower one.
        speed = np.linalg.norm(ways, axis=-1) / clip.frame_time
        share = (alone + 1e-3 * firm * by + 1e-9) / (speed**2 + _SLOW**2)
        share = share / share.sum(axis=0)
        swings = np.prod(1.0 - firm * by, axis=0)
        return _taken_back(np.sum(share[..., None] * too_far, axis=0), swings), swings

    def _way(self, sole: Array) -> Array:
        """(T, 2) level way to the next frame."""
        after = sole[-1:] if self.travel is None else sole[:1] + self.travel
        return np.diff(sole, axis=0, append=after)[:, [0, 2]]


def foot_columns(points: int) -> int:
    """Number of columns of a foot with so many points under its sole."""
    return 11 + 3 * points


def read_foot(
    foot: Foot, offsets: Sequence[Array], columns: Array, gone: Array, travel: Array | None
) -> BlendedFoot:
    """A foot from blended columns (T, 11 + 3 a point), in the order of ``Example.rows``.

    Args:
        foot: its joints.
        offsets: (3,) of each point of the sole, m.
        columns: weighted sums of the examples'.
        gone: (T, 3) m, the travel until then.
        travel: see ``BlendedFoot``.
    """
    steps = len(columns) if travel is not None else len(columns) - 1
    points = tuple(
        SolePoint(point.joint, offset, columns[:, at], columns[:, at + 1 : at + 3] / steps)
        for point, offset, at in zip(foot.points, offsets, (11, 14), strict=False)
    )
    ankle, turn = columns[:, :3], from_directions(columns[:, 4:10])
    # The variance of the examples' ankles: none between a clip and itself, wherever it walks.
    about = ankle - ankle.mean(axis=0)
    apart = max(float((columns[:, 3] - np.sum(about**2, axis=1)).mean()), 0.0)
    own = 1.0 / (1.0 + apart / _ALIKE**2)
    return BlendedFoot(foot, ankle + gone, turn, columns[:, 10], points, travel, own)


def _held(firm: Array) -> Array:
    """(T,) by what to multiply firmness to see how much a point is kept in its place.

    Together they are a smooth step from 0 to 1, reached at a small firmness.
    """
    part = np.clip(firm / _FULLY, 0.0, 1.0)
    return np.where(part < 1.0, part * (3.0 - 2.0 * part) / _FULLY, 1.0 / np.maximum(firm, _FULLY))


def _taken_back(ways: Array, swings: Array) -> Array:
    """(T, 2) m, the sum of ways (T, 2) up to each frame, taken back while the foot swings.

    In the mean of the frames in which it stands it is 0.
    """
    back = swings**2 if swings.sum() >= 1.0 else np.ones_like(swings)
    ways = ways - ways.sum(axis=0) * (back / back.sum())[:, None]
    slid = np.cumsum(ways, axis=0) - ways
    stands = 1.0 - swings + 1e-9
    return np.asarray(slid - (stands @ slid) / stands.sum())
