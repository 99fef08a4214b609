"""The body's centre of mass, from an average body's segment masses.

Masses and centres: de Leva (1996), Adjustments to Zatsiorsky-Seluyanov's segment inertia
parameters, J Biomech 29:1223, table 4, each the mean of his women and men.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.errors import MotionError
from motion.kinematics import WorldPose, end_site_positions
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

SIDES = ("left", "right")


@dataclass(frozen=True)
class Segment:
    """A part of the body.

    Attributes:
        mass: share of the whole body's.
        centre: share of the way from the segment's near to its far end.
    """

    mass: float
    centre: float


# Female and male. The trunk reaches from mid-shoulder to mid-hip, the head from the vertex to the
# seventh cervical vertebra, the hand from the wrist to the finger's tip.
_TABLE = {
    "head": ((0.0668, 0.4841), (0.0694, 0.5002)),
    "trunk": ((0.4257, 0.3782), (0.4346, 0.4310)),
    "upper_arm": ((0.0255, 0.5754), (0.0271, 0.5772)),
    "forearm": ((0.0138, 0.4559), (0.0162, 0.4574)),
    "hand": ((0.0056, 0.3427), (0.0061, 0.3624)),
    "thigh": ((0.1478, 0.3612), (0.1416, 0.4095)),
    "shin": ((0.0481, 0.4352), (0.0433, 0.4395)),
    "foot": ((0.0129, 0.4014), (0.0137, 0.4415)),
}
SEGMENTS = {
    name: Segment(*(sum(pair) / 2.0 for pair in zip(*rows, strict=True)))
    for name, rows in _TABLE.items()
}
# His feet are measured from the heel. Seen from the ankle, their centre lies about as far along
# the way to the ball, because heel to ankle and ball to tip are about a quarter of the foot each.
_HAND_LENGTH = 0.69  # of the forearm's, where a skeleton's hand has no tip


def centre_of_mass(skeleton: Skeleton, pose: WorldPose) -> Array:
    """World position (T, 3) of the body's centre of mass, metres.

    Raises:
        MotionError: if a body role that a segment needs is missing.
    """
    ends = SegmentEnds(skeleton, pose)
    total, mass = np.zeros((len(pose.positions), 3)), 0.0
    for name, segment in SEGMENTS.items():
        for near, far in ends.of(name):
            total += segment.mass * (near + segment.centre * (far - near))
            mass += segment.mass
    return total / mass  # the table's masses sum to 1 but for rounding


class SegmentEnds:
    """Where the segments begin and end.

    Raises:
        MotionError: if a body role that a segment needs is missing.
    """

    def __init__(self, skeleton: Skeleton, pose: WorldPose) -> None:
        self.roles = skeleton.roles
        self.pose = pose
        tips = end_site_positions(skeleton, pose)
        self.tips = {site.joint: tips[:, i] for i, site in enumerate(skeleton.end_sites)}

    def of(self, name: str) -> list[tuple[Array, Array]]:
        """Near and far end (T, 3) of each segment of that name: one, or one a side."""
        if name == "head":
            return [self._head()]
        if name == "trunk":
            return [(self._middle("upper_arm"), self._middle("thigh"))]
        return [self._paired(side, name) for side in SIDES]

    def _paired(self, side: str, name: str) -> tuple[Array, Array]:
        follow = {"upper_arm": "forearm", "thigh": "shin", "shin": "foot"}
        if name in follow:
            return self._at(f"{side}_{name}"), self._at(f"{side}_{follow[name]}")
        if name == "foot":
            near = self._at(f"{side}_foot")
            return near, self._end(f"{side}_foot", f"{side}_toes", near)
        elbow, upper = self._at(f"{side}_forearm"), self._at(f"{side}_upper_arm")
        wrist = self._end(f"{side}_forearm", f"{side}_hand", elbow + 0.9 * (elbow - upper))
        if name == "forearm":
            return elbow, wrist
        return wrist, self._end(f"{side}_hand", None, wrist + _HAND_LENGTH * (wrist - elbow))

    def _head(self) -> tuple[Array, Array]:
        """Vertex to neck; a head without a tip has its mass at its joint, about midway."""
        joint = self._at("head")
        tip = self.tips.get(self.roles["head"])
        return (joint, joint) if tip is None else (tip, self._end("head", "neck", joint))

    def _middle(self, part: str) -> Array:
        return (self._at(f"left_{part}") + self._at(f"right_{part}")) / 2.0

    def _end(self, role: str, follower: str | None, otherwise: Array) -> Array:
        """Where a segment ends: at the next role's joint, at its tip, or where nothing tells."""
        if follower is not None and follower in self.roles:
            return self.pose.positions[:, self.roles[follower]]
        return self.tips.get(self.roles.get(role, -1), otherwise)

    def _at(self, role: str) -> Array:
        if role not in self.roles:
            name = role.replace("_", " ")
            raise MotionError(f"No joint is the {name}: set that body role first.")
        return self.pose.positions[:, self.roles[role]]
