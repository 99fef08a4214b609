"""One body for one skeleton."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.figure.bind import SIDES, bind_pose
from motion.figure.body import Body, make_body
from motion.figure.field import gradient
from motion.figure.mesh import FigureMesh
from motion.figure.skin import skin_weights
from motion.figure.spheres import limb_of_joints, occlusion_spheres, soles
from motion.figure.surface_nets import sample, surface_nets

Array = NDArray[np.float64]

_NEWTON_STEPS = 3
_MARGIN = 0.045  # metres of air around the body in the grid
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
    positions, normals, triangles = _surface(body)
    joints, weights = skin_weights(body, positions)
    floor = float(np.mean([frame.origin[1] for frame in body.feet.values()]))
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


def _surface(body: Body) -> tuple[Array, Array, NDArray[np.intp]]:
    axes = _grid(body)
    values = sample(body.whole.distance, axes)
    positions, quads = surface_nets(values, axes)
    for _ in range(_NEWTON_STEPS):
        slope = gradient(body.whole, positions)
        value = body.whole.distance(positions)[:, None]
        square = np.maximum(np.sum(slope * slope, axis=1, keepdims=True), 0.05)
        positions = positions - np.clip(value / square, -0.01, 0.01) * slope
    normals = gradient(body.whole, positions)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
    triangles = _split(positions, quads)
    order = _walk(triangles, len(positions))
    return _reordered(positions, normals, triangles, order)


def _split(positions: Array, quads: NDArray[np.intp]) -> NDArray[np.intp]:
    """Triangles (2Q, 3) of quads (Q, 4), along the shorter diagonal."""
    corners = positions[quads]
    first = np.linalg.norm(corners[:, 0] - corners[:, 2], axis=1)
    second = np.linalg.norm(corners[:, 1] - corners[:, 3], axis=1)
    turned = np.where((first <= second + 1e-9)[:, None], quads, np.roll(quads, -1, axis=1))
    return np.concatenate([turned[:, [0, 1, 2]], turned[:, [0, 2, 3]]], axis=1).reshape(-1, 3)


def _walk(triangles: NDArray[np.intp], count: int) -> NDArray[np.intp]:
    return np.arange(count)


def _reordered(
    positions: Array, normals: Array, triangles: NDArray[np.intp], order: NDArray[np.intp]
) -> tuple[Array, Array, NDArray[np.intp]]:
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return positions[order], normals[order], rank[triangles]


def _grid(body: Body) -> tuple[Array, Array, Array]:
    """Coordinates of the grid: fine at hands, feet and head, coarse along shins and trunk."""
    scale = body.trunk.scale
    head = float(body.pose.place("head")[1])
    sole = min(float(frame.origin[1]) for frame in body.feet.values())
    tips = [
        limb.end.world(np.array([0.0, 0.75 * limb.girth[1], 0.0])) for limb in body.arms.values()
    ]
    wrists = [limb.end.origin for limb in body.arms.values()]
    reach = max(abs(float(tip[0])) for tip in tips) + _MARGIN
    near = min(abs(float(wrist[0])) for wrist in wrists) - 0.02
    high, low = max(float(w[1]) for w in wrists), min(float(t[1]) for t in tips)
    half = _spaced([(0.0, 0.0155), (near - 0.05, 0.0155), (near, 0.0125), (reach, 0.0125)], scale)
    half = half[: -((len(half) - 1) % 2) or None]
    x = np.concatenate([-half[:0:-1], half])
    toe = max(body.toe_ahead.values()) * 2.2
    depth = max(float(frame.origin[2]) for frame in body.feet.values()) + toe + _MARGIN
    back = min(float(body.trunk.centre(h)[2]) for h in (-0.04, 0.3)) - 0.13 * scale - _MARGIN
    y = _spaced(
        [
            (sole - _MARGIN, 0.0115), (sole + 0.12 * scale, 0.0115), (sole + 0.2 * scale, 0.018),
            (low - 0.02, 0.017), (low, 0.014), (high, 0.014), (high + 0.06, 0.0165),
            (head - 0.06 * scale, 0.0155), (head, 0.0135), (head + 0.2 * scale + _MARGIN, 0.0135),
        ],
        scale,
    )
    z = _spaced([(back, 0.0145), (depth, 0.0145)], scale)
    return _fours(x, centred=True), _fours(y), _fours(z)


def _spaced(steps: Sequence[tuple[float, float]], scale: float) -> Array:
    """Coordinates from the first place to beyond the last, with the step wanted at each place."""
    places = np.linspace(steps[0][0], steps[-1][0], 2000)
    wanted = np.interp(places, *np.array(steps).T) * scale
    count = np.concatenate([[0.0], np.cumsum(np.diff(places) * 2.0 / (wanted[1:] + wanted[:-1]))])
    return np.interp(np.arange(np.ceil(count[-1])), count, places)


def _fours(axis: Array, *, centred: bool = False) -> Array:
    """The axis with steps added at its end (or both ends) until four divides their number."""
    lack = -(len(axis) - 1) % 4
    before = lack // 2 if centred else 0
    first, last = axis[1] - axis[0], axis[-1] - axis[-2]
    return np.concatenate([
        axis[0] - first * np.arange(before, 0, -1),
        axis,
        axis[-1] + last * np.arange(1, lack - before + 1),
    ])


def _sky(body: Body, positions: Array, normals: Array) -> Array:
    """(V,) how open the sky above each vertex is, from the field at a few steps outward.

    Follows the distance-field occlusion of Evans, "Fast approximations for global illumination
    on dynamic scenes" (2006): where the field grows slower than the step, something is near.
    """
    lacking = np.zeros(len(positions))
    for step in _LOOKOUT:
        lacking += np.maximum(step - body.whole.distance(positions + normals * step), 0.0) / step
    return np.clip(1.0 - 0.8 * lacking / len(_LOOKOUT), 0.0, 1.0)


__all__ = ["SIDES", "build_figure"]
