"""Waveshaping (Bruderlin & Williams 1995): joint angles passed through soft limits.

The curve works on one angle of a joint, the turn about one canonical axis, frame by frame. It is
the identity where the angle is well within its limits, and presses it together near them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.errors import MotionError
from motion.ik import soft_limit
from motion.rotations import from_axis_angle, multiply
from motion.segment_angles import X, Y, Z, twist
from motion.standing import Standing

Array = NDArray[np.float64]

AXES = {"x": X, "y": Y, "z": Z}


@dataclass(frozen=True)
class SoftLimit:
    """How far a joint may turn about one axis.

    Attributes:
        role: body role of the joint, such as "left_forearm".
        axis: canonical, "x", "y" or "z": x bows and bends, y turns, z leans and spreads.
        low, high: degrees, which are approached but never passed. An elbow bends to −150.
        soft: degrees before a limit from which on the angle is pressed together.
    """

    role: str
    axis: str
    low: float = -180.0
    high: float = 180.0
    soft: float = 15.0

    def __post_init__(self) -> None:
        if self.axis not in AXES or self.soft < 0 or self.high - self.low < 2.0 * self.soft:
            raise MotionError(
                f"“{self.role}”: the axis must be x, y or z, not “{self.axis}”, and between "
                f"{self.low}° and {self.high}° there must be room for {self.soft}° at both ends."
            )

    def __call__(self, angle: Array) -> Array:
        """Angles (T,) rad pressed together towards the limits."""
        low, high, soft = np.radians([self.low, self.high, self.soft])
        above = soft_limit(angle, float(high), float(soft))
        return -soft_limit(-above, float(-low), float(soft))


def shape(
    clip: Clip,
    limits: Sequence[SoftLimit],
    amount: float = 1.0,
    standing: Standing | None = None,
) -> Clip:
    """The clip with joint angles passed through soft limits.

    Args:
        clip: a clip whose skeleton has body roles.
        limits: each applied to what the ones before have left.
        amount: 0 leaves the clip, 1 keeps the limits; more goes farther than they ask.
        standing: of the motion before other edits, where it is known; None finds it in the clip.

    Raises:
        MotionError: if no joint has a limit's role.
    """
    if amount == 0.0 or not limits:
        return clip
    standing = standing or Standing.of(clip)
    rotations = clip.rotations.copy()
    for limit in limits:
        if limit.role not in clip.skeleton.roles:
            name = limit.role.replace("_", " ")
            raise MotionError(f"No joint is the {name}: set that body role first.")
        joint = clip.skeleton.roles[limit.role]
        canonical = standing.canonical(rotations[:, joint], joint)
        angle = twist(canonical, AXES[limit.axis])
        # A rotation is its turn about the axis, followed by the swing: adding to the turn comes
        # first, so from the right.
        more = from_axis_angle(np.eye(3)[AXES[limit.axis]], amount * (limit(angle) - angle))
        rotations[:, joint] = standing.from_canonical(multiply(canonical, more), joint)
    return replace(clip, rotations=rotations)
