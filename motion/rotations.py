"""Rotations in batches: quaternions, direction vectors (6-D), matrices, Euler angles.

Every function works over any leading axes. Quaternions are unit, ``wxyz``.
"""

from __future__ import annotations

from typing import Any, cast

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from motion.errors import MotionError

Array = NDArray[np.float64]

_COLLAPSED = 1e-8  # a direction vector shorter than this has no direction (methods: Förger, ch. 3)
_WXYZ_TO_XYZW = [1, 2, 3, 0]
_XYZW_TO_WXYZ = [3, 0, 1, 2]


def normalise(quaternions: Array) -> Array:
    """Unit quaternions (..., 4) in the directions of ``quaternions`` (..., 4)."""
    return quaternions / np.linalg.norm(quaternions, axis=-1, keepdims=True)


def conjugate(quaternions: Array) -> Array:
    """Inverse rotations (..., 4)."""
    return quaternions * np.array([1.0, -1.0, -1.0, -1.0])


def multiply(first: Array, second: Array) -> Array:
    """Products (..., 4): the rotation ``second`` followed by ``first``; leading axes broadcast."""
    w1, x1, y1, z1 = np.moveaxis(first, -1, 0)
    w2, x2, y2, z2 = np.moveaxis(second, -1, 0)
    return np.stack(
        [
            w1 * w2 - x1 * x2 - y1 * y2 - z1 * z2,
            w1 * x2 + x1 * w2 + y1 * z2 - z1 * y2,
            w1 * y2 - x1 * z2 + y1 * w2 + z1 * x2,
            w1 * z2 + x1 * y2 - y1 * x2 + z1 * w2,
        ],
        axis=-1,
    )


def rotate(quaternions: Array, vectors: Array) -> Array:
    """Rotated vectors (..., 3); leading axes broadcast."""
    axis = quaternions[..., 1:]
    twice = 2.0 * np.cross(axis, vectors)
    return vectors + quaternions[..., :1] * twice + np.cross(axis, twice)


def from_axis_angle(axis: Array, angle: Array | float) -> Array:
    """Quaternions (..., 4) of turns by ``angle`` (...) rad about unit vectors ``axis`` (..., 3)."""
    half = np.asarray(angle, dtype=float)[..., None] / 2.0
    vector = np.sin(half) * axis
    scalar = np.broadcast_to(np.cos(half), (*vector.shape[:-1], 1))
    return np.concatenate([scalar, vector], axis=-1)


def from_matrix(matrices: Array) -> Array:
    """Quaternions (..., 4) of rotation matrices (..., 3, 3)."""
    flat = Rotation.from_matrix(matrices.reshape(-1, 3, 3)).as_quat()
    return flat[:, _XYZW_TO_WXYZ].reshape(*matrices.shape[:-2], 4)


def to_matrix(quaternions: Array) -> Array:
    """Rotation matrices (..., 3, 3) of quaternions (..., 4)."""
    w, x, y, z = np.moveaxis(quaternions, -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def from_euler(angles: Array, order: str) -> Array:
    """Quaternions (..., 4) of intrinsic Euler angles.

    Args:
        angles: (..., n) rad, in the order of ``order``.
        order: n of the letters X, Y, Z as BVH lists its channels: "ZXY" turns about z, then about
            the turned x, then about the twice turned y.
    """
    result: Array | None = None
    for index, letter in enumerate(order.upper()):
        axis = np.eye(3)["XYZ".index(letter)]
        turn = from_axis_angle(axis, angles[..., index])
        result = turn if result is None else multiply(result, turn)
    if result is None:
        return np.broadcast_to([1.0, 0.0, 0.0, 0.0], (*angles.shape[:-1], 4)).copy()
    return result


def to_euler(quaternions: Array, order: str) -> Array:
    """Intrinsic Euler angles (..., 3) rad in ``order`` (three letters), any at gimbal lock."""
    flat = quaternions.reshape(-1, 4)[:, _WXYZ_TO_XYZW]
    axes = cast(Any, order.upper())  # SciPy's stubs list the orders one by one
    angles = Rotation.from_quat(flat).as_euler(axes, suppress_warnings=True)
    return angles.reshape(*quaternions.shape[:-1], 3)


def to_directions(quaternions: Array) -> Array:
    """Direction vectors (..., 6): the first two columns of the rotation matrix, x then y."""
    matrices = to_matrix(quaternions)
    return np.concatenate([matrices[..., 0], matrices[..., 1]], axis=-1)


def from_directions(directions: Array) -> Array:
    """Quaternions (..., 4) of direction vectors (..., 6), made orthonormal by Gram–Schmidt.

    Only directions count, not lengths. A pair that has collapsed (a length below 1e-8, or the two
    parallel) takes the previous frame's rotation along the first axis; in the first frame, the
    next good one's.

    Raises:
        MotionError: if no frame of a joint has a direction.
    """
    x, x_ok = _unit(directions[..., :3])
    y = directions[..., 3:]
    y, _ = _unit(y)
    y, y_ok = _unit(y - np.sum(x * y, axis=-1, keepdims=True) * x)
    good = x_ok & y_ok
    x = np.where(good[..., None], x, [1.0, 0.0, 0.0])
    y = np.where(good[..., None], y, [0.0, 1.0, 0.0])
    quaternions = from_matrix(np.stack([x, y, np.cross(x, y)], axis=-1))
    return quaternions if good.all() else _carry_forward(quaternions, good)


def _unit(vectors: Array) -> tuple[Array, NDArray[np.bool_]]:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    ok = length[..., 0] > _COLLAPSED
    return vectors / np.where(length > _COLLAPSED, length, 1.0), ok


def _carry_forward(quaternions: Array, good: NDArray[np.bool_]) -> Array:
    if good.ndim == 0 or not good.any(axis=0).all():
        raise MotionError("Direction vectors without a direction cannot become a rotation.")
    index = np.arange(len(good)).reshape(-1, *[1] * (good.ndim - 1))
    last_good = np.maximum.accumulate(np.where(good, index, -1), axis=0)
    source = np.where(last_good >= 0, last_good, np.argmax(good, axis=0))
    return np.take_along_axis(quaternions, source[..., None], axis=0)


def make_continuous(quaternions: Array) -> Array:
    """The same rotations (T, ..., 4), signs chosen so that no frame jumps to the double cover."""
    if len(quaternions) < 2:
        return quaternions
    dots = np.sum(quaternions[1:] * quaternions[:-1], axis=-1)
    signs = np.cumprod(np.where(dots < 0, -1.0, 1.0), axis=0)
    return np.concatenate([quaternions[:1], quaternions[1:] * signs[..., None]])


def angle_between(first: Array, second: Array) -> Array:
    """Angles (...) rad in [0, π] of the turns that lead from ``first`` to ``second``."""
    difference = multiply(conjugate(first), second)
    return 2.0 * np.arctan2(
        np.linalg.norm(difference[..., 1:], axis=-1), np.abs(difference[..., 0])
    )


def slerp(first: Array, second: Array, share: Array | float) -> Array:
    """Rotations (..., 4) on the shorter arc from ``first`` (share 0) to ``second`` (share 1)."""
    dot = np.sum(first * second, axis=-1, keepdims=True)
    second = np.where(dot < 0, -second, second)
    angle = np.arccos(np.clip(np.abs(dot), 0.0, 1.0))
    part = np.asarray(share, dtype=float)[..., None]
    sine = np.sin(angle)
    near = sine < 1e-9
    safe = np.where(near, 1.0, sine)
    a = np.where(near, 1.0 - part, np.sin((1.0 - part) * angle) / safe)
    b = np.where(near, part, np.sin(part * angle) / safe)
    return normalise(a * first + b * second)


def between(first: Array, second: Array) -> Array:
    """Smallest rotations (..., 4) that turn the unit vectors ``first`` (..., 3) into ``second``."""
    first, second = np.broadcast_arrays(first, second)
    # By the direction half-way: 1 + cos loses its digits where the two are nearly opposite.
    middle = first + second
    length = np.linalg.norm(middle, axis=-1, keepdims=True)
    opposite = length < 1e-12
    middle = middle / np.where(opposite, 1.0, length)
    helper = np.where(np.abs(first[..., :1]) < 0.9, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    axis = np.cross(first, np.where(opposite, helper, middle))
    w = np.where(opposite, 0.0, np.sum(first * middle, axis=-1, keepdims=True))
    return normalise(np.concatenate([w, axis], axis=-1))
