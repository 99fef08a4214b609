"""How a body stands upright with hanging arms, and rotations as seen from there.

Seen from standing, joint frames are common to all skeletons: x to the left, y up, z forward, and
the identity for whoever stands.
"""

from __future__ import annotations

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.figure.reference import Reference
from motion.rotations import conjugate, from_matrix, multiply, to_matrix

Array = NDArray[np.float64]
Joints = int | slice | NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class Standing:
    """An upright stance facing +z.

    Attributes:
        rotations: (J, 4) world rotation of each joint.
        above: (J, 4) world rotation of each joint's parent; the identity for the root.
    """

    rotations: Array
    above: Array

    @classmethod
    def of(cls, clip: Clip) -> Standing:
        """The stance of a clip's skeleton, its joints' axes known from the clip.

        It is remembered for as long as the clip is.
        """
        known = _KNOWN.get(clip)
        if known is None:
            rotations = standing_rotations(clip)
            root = np.array([[1.0, 0.0, 0.0, 0.0]])
            above = np.concatenate([root, rotations[clip.skeleton.parents[1:]]])
            known = _KNOWN[clip] = cls(rotations, above)
        return known

    @property
    def local(self) -> Array:
        """(J, 4) the stance as local rotations."""
        return multiply(conjugate(self.above), self.rotations)

    def canonical(self, local: Array, joint: Joints = slice(None)) -> Array:
        """Local rotations (T, 4) of one joint, or (T, K, 4) of several or all, from standing."""
        return multiply(multiply(self.above[joint], local), conjugate(self.rotations[joint]))

    def from_canonical(self, canonical: Array, joint: Joints = slice(None)) -> Array:
        """The local rotations of rotations seen from standing."""
        return multiply(multiply(conjugate(self.above[joint]), canonical), self.rotations[joint])


_KNOWN: WeakKeyDictionary[Clip, Standing] = WeakKeyDictionary()


def standing_rotations(clip: Clip) -> Array:
    """World rotations (J, 4) of an upright stance, the joints' axes known from a clip."""
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
