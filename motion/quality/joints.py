"""Joints bent farther than people's.

Ranges: American Academy of Orthopaedic Surgeons (1965), Joint Motion: Method of Measuring and
Recording, widened by 15 degrees, because a skeleton's joints are not where the bones' are. An
ankle under load bends farther than a free one (35 to 45 degrees in a lunge: Bennell et al. 1998).
What the original does beyond is its own affair: only more than that is a fault.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.kinematics import WorldPose
from motion.quality.pair import Pair
from motion.quality.report import Measure
from motion.rotations import rotate
from motion.segment_angles import X, Y, Z, seen_from, twist

Array = NDArray[np.float64]

MARGIN = 15.0  # degrees beyond the normal range
BEYOND = 5.0  # degrees beyond the original, where that leaves the range itself


@dataclass(frozen=True)
class Range:
    """How far a segment may turn against another about one axis, degrees.

    Attributes:
        name: of the joint, in words.
        part: the segment's role; a paired one without its side.
        against: the other segment's role; the first of several that the skeleton has.
        axis: canonical; about y and z, towards the own side's outside is positive.
        low, high: ends of the normal range.
    """

    name: str
    part: str
    against: tuple[str, ...]
    axis: int
    low: float
    high: float


_TRUNK = ("chest", "spine", "hips")
PAIRED = (
    Range("elbow", "forearm", ("upper_arm",), X, -150, 0),
    Range("hip", "thigh", ("hips",), X, -120, 30),
    Range("hip", "thigh", ("hips",), Z, -30, 45),
    Range("knee", "shin", ("thigh",), X, -10, 135),
    Range("ankle", "foot", ("shin",), X, -35, 50),
)
MIDDLE = (
    Range("neck", "head", _TRUNK, X, -60, 45),
    Range("neck", "head", _TRUNK, Y, -80, 80),
    Range("neck", "head", _TRUNK, Z, -45, 45),
    Range("back", "chest", ("hips",), X, -25, 80),
    Range("back", "chest", ("hips",), Y, -45, 45),
    Range("back", "chest", ("hips",), Z, -35, 35),
)
SHOULDER_BACK = 60.0  # the upper arm's reach behind the trunk; its others wrap around overhead


def bends(pair: Pair) -> Iterator[Measure]:
    """Every angle of every joint against its range, both ends."""
    for found in MIDDLE:
        yield from _both_ends(pair, found, "")
    for side in ("left_", "right_"):
        for found in PAIRED:
            yield from _both_ends(pair, found, side)
        yield from _shoulder(pair, side)


def angles(pair: Pair, pose: WorldPose, found: Range, side: str) -> Array | None:
    """Angle (T,) in degrees that a range is about; None where the skeleton has no such joint."""
    joint = pair.roles.get(side + found.part)
    others = [side * (part in _SIDED) + part for part in found.against]
    other = next((pair.roles[role] for role in others if role in pair.roles), None)
    if joint is None or other is None:
        return None
    turn = np.degrees(twist(seen_from(pose, pair.standing, joint, other), found.axis))
    return -turn if side == "right_" and found.axis != X else turn


_SIDED = ("upper_arm", "thigh", "shin")


def _both_ends(pair: Pair, found: Range, side: str) -> Iterator[Measure]:
    before, after = (angles(pair, pose, found, side) for pose in (pair.before, pair.after))
    if before is None or after is None:
        return
    name = side.replace("_", " ") + found.name
    for sign, end in ((1.0, found.high), (-1.0, -found.low)):
        limit = _limit(end, sign * before)
        yield Measure("joint range", name, "°", sign * after, limit)


def _limit(end: float, before: Array) -> float:
    return max(end + MARGIN, float(before.max()) + BEYOND)


def _shoulder(pair: Pair, side: str) -> Iterator[Measure]:
    joint = pair.roles[f"{side}upper_arm"]
    other = next(pair.roles[role] for role in _TRUNK if role in pair.roles)
    down = np.array([0.0, -1.0, 0.0])
    before, after = (
        -np.degrees(np.arcsin(np.clip(arm[:, 2], -1.0, 1.0)))
        for pose in (pair.before, pair.after)
        for arm in [rotate(seen_from(pose, pair.standing, joint, other), down)]
    )
    limit = _limit(SHOULDER_BACK, before)
    yield Measure("joint range", f"{side[:-1]} shoulder", "°", after, limit)
