"""The finished body: a skinned mesh and what a viewer needs beside it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.skeleton import Skeleton

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Sphere:
    """A ball that shades other limbs: fixed to a joint, part of a limb."""

    joint: int
    centre: tuple[float, float, float]
    radius: float
    limb: str


@dataclass(frozen=True)
class Sole:
    """Points (in the joint's frame, metres) of a sole's outline that touch a level floor."""

    joint: int
    points: tuple[tuple[float, float, float], ...]


@dataclass(frozen=True, eq=False)
class FigureMesh:
    """A closed body for one skeleton, in its bind pose.

    Attributes:
        skeleton: the J joints that carry it.
        positions: (V, 3) metres, in world axes with the origin at the root joint.
        normals: (V, 3) unit.
        triangles: (F, 3) vertex indices, counter-clockwise from outside.
        joints: (V, 4) the joints that carry each vertex, strongest first.
        weights: (V, 4) their shares, sum 1.
        occlusion: (V,) share of the sky that creases of the bind pose leave open, 0–1.
        bind_positions: (J, 3) the joints in the bind pose, same axes as positions.
        bind_rotations: (J, 4) their world rotations, wxyz.
        bind_local: (J, 4) the same, each relative to its parent.
        floor: height of the soles below the root joint, metres (negative).
        stature: metres from the soles to the crown, legs straight.
        spheres: balls along the bones, for shading one limb by another.
        soles: the outline of each sole.
        limbs: joint index to the limb that it belongs to.
    """

    skeleton: Skeleton
    positions: Array
    normals: Array
    triangles: NDArray[np.intp]
    joints: NDArray[np.intp]
    weights: Array
    occlusion: Array
    bind_positions: Array
    bind_rotations: Array
    bind_local: Array
    floor: float
    stature: float
    spheres: tuple[Sphere, ...]
    soles: tuple[Sole, ...]
    limbs: Mapping[int, str]
