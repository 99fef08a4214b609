"""How one body segment is turned against another, in axes that are the same for every skeleton.

Canonical axes (see ``motion.standing``): x to the left, y up, z forward; the identity in upright
standing with hanging arms. So a positive turn about x bows a trunk and bends a knee.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motion.kinematics import WorldPose
from motion.rotations import conjugate, multiply

Array = NDArray[np.float64]

X, Y, Z = 0, 1, 2


def seen_from(pose: WorldPose, standing: Array, joint: int, other: int) -> Array:
    """Rotation (T, 4) of a joint's segment in the frame of another's, in canonical axes.

    Args:
        pose: of T frames.
        standing: (J, 4) world rotations in upright standing.
        joint: whose segment it is.
        other: against whose segment it is measured.
    """
    world = [multiply(pose.rotations[:, j], conjugate(standing[j])) for j in (joint, other)]
    return multiply(conjugate(world[1]), world[0])


def twist(rotations: Array, axis: int) -> Array:
    """Angle (...) rad in (−π, π] by which rotations (..., 4) turn about a canonical axis.

    The swing–twist split: the rotation is this turn, followed by one about an axis across it.
    """
    w, part = rotations[..., 0], rotations[..., 1 + axis]
    return 2.0 * np.arctan2(np.where(w < 0, -part, part), np.abs(w))
