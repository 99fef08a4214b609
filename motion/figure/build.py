"""One body for one skeleton."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.figure.bind import bind_pose
from motion.figure.body import Body, make_body
from motion.figure.mesh import FigureMesh
from motion.figure.skin import skin_weights
from motion.figure.spheres import limb_of_joints, occlusion_spheres, soles
from motion.figure.surface import grow_surface

Array = NDArray[np.float64]

# Distances along the normal at which the sky is looked for, metres.
_LOOKOUT = np.array([0.012, 0.025, 0.05, 0.09])


def build_figure(clip: Clip) -> FigureMesh:
    """The mannequin around a clip's skeleton, its joint axes known from the clip's frames.

    Deterministic: the same clip gives the same mesh.

    Raises:
        MotionError: if the clip is empty or a role that a body cannot do without is missing.
    """
    pose = bind_pose(clip)
    body = make_body(pose)
    positions, normals, triangles = grow_surface(body)
    joints, weights = skin_weights(body, positions)
    floor = float(np.mean([foot.frame.origin[1] for foot in body.feet.values()]))
    hip = (pose.place("left_thigh") + pose.place("right_thigh"))[1] / 2.0
    legs = np.mean([limb.upper + limb.lower for limb in body.legs.values()])
    ankle = np.mean(list(pose.ankle_height.values()))
    return FigureMesh(
        skeleton=clip.skeleton,
        positions=positions,
        normals=normals,
        triangles=triangles,
        joints=joints,
        weights=weights,
        occlusion=_sky(body, positions, normals),
        bind_positions=pose.positions,
        bind_rotations=pose.rotations,
        bind_local=pose.local,
        floor=floor,
        stature=float(positions[:, 1].max() - hip + legs + ankle),
        spheres=occlusion_spheres(body),
        soles=soles(body),
        limbs=limb_of_joints(body),
    )


def _sky(body: Body, positions: Array, normals: Array) -> Array:
    """(V,) how open the sky above each vertex is, from the field at a few steps outward.

    Follows the distance-field occlusion of Evans, "Fast approximations for global illumination
    on dynamic scenes" (2006): where the field grows slower than the step, something is near.
    """
    lacking = np.zeros(len(positions))
    for step in _LOOKOUT * body.trunk.scale:
        lacking += np.maximum(step - body.whole.distance(positions + normals * step), 0.0) / step
    return np.clip(1.0 - 0.8 * lacking / len(_LOOKOUT), 0.0, 1.0)
