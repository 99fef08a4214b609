"""How each joint of a skeleton is turned when the body stands upright with hanging arms."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.figure.reference import Reference
from motion.rotations import from_matrix, to_matrix

Array = NDArray[np.float64]


def standing_rotations(clip: Clip) -> Array:
    """World rotations (J, 4) of an upright stance facing +z, the joints' axes known from a clip.

    They make joint frames common: a rotation seen from them means the same on every skeleton.
    """
    skeleton = clip.skeleton
    reference = Reference(clip)
    axes = reference.axes()
    resting = to_matrix(reference.resting_local)
    world = np.empty((len(skeleton), 3, 3))
    for joint, parent in enumerate(skeleton.parents):
        if joint in axes:
            world[joint] = axes[joint].T
        else:
            world[joint] = resting[joint] if parent < 0 else world[parent] @ resting[joint]
    return from_matrix(world)
