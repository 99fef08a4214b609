"""Rotations in batches: quaternions, direction vectors (6-D), matrices, Euler angles.

Every function works over any leading axes. Quaternions are unit, ``wxyz``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from motion.errors import MotionError

Array = NDArray[np.float64]

_COLLAPSED = 1e-8  # a direction vector shorter than this has no direction (methods: Förger, ch. 3)
_HALF_TURN = -0.5  # of the trace: turns that lie nearer to half a turn have a small scalar part
_WXYZ_TO_XYZW = [1, 2, 3, 0]


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
    w, *axis = _rows(quaternions)
    places = _rows(vectors)
    twice = 2.0 * _cross(axis, places)
    aside = _cross(axis, twice)
    return np.stack([places[i] + w * twice[i] + aside[i] for i in range(3)], axis=-1)


def from_axis_angle(axis: Array, angle: Array | float) -> Array:
    """Quaternions (..., 4) of turns by ``angle`` (...) rad about unit vectors ``axis`` (..., 3)."""
    half = np.asarray(angle, dtype=float)[..., None] / 2.0
    vector = np.sin(half) * axis
    scalar = np.broadcast_to(np.cos(half), (*vector.shape[:-1], 1))
    return np.concatenate([scalar, vector], axis=-1)


def from_matrix(matrices: Array) -> Array:
    """Quaternions (..., 4) of rotation matrices (..., 3, 3)."""
    return _from_axes(*np.ascontiguousarray(np.moveaxis(matrices, [-1, -2], [0, 1])))


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
    return np.ascontiguousarray(np.moveaxis(_direction_rows(quaternions), 0, -1))


def _direction_rows(quaternions: Array) -> Array:
    """The same (6, ...), each component contiguous."""
    w, x, y, z = _rows(quaternions)
    rows = np.empty((6, *w.shape))
    rows[0] = 1 - 2 * (y * y + z * z)
    rows[1] = 2 * (x * y + w * z)
    rows[2] = 2 * (x * z - w * y)
    rows[3] = 2 * (x * y - w * z)
    rows[4] = 1 - 2 * (x * x + z * z)
    rows[5] = 2 * (y * z + w * x)
    return rows


def from_directions(directions: Array) -> Array:
    """Quaternions (..., 4) of direction vectors (..., 6), made orthonormal by Gram–Schmidt.

    Only directions count, not lengths. A pair that has collapsed (a length below 1e-8, or the two
    parallel) takes the previous frame's rotation along the first axis; in the first frame, the
    next good one's.

    Raises:
        MotionError: if no frame of a joint has a direction.
    """
    return _from_direction_rows(_rows(directions))


def weighted_mean(weighted: Sequence[tuple[float, Array]]) -> Array:
    """Rotations (..., 4) whose direction vectors are the weighted sums of others', orthonormal.

    Raises:
        MotionError: if all weighted rotations of a joint cancel each other out in every frame.
    """
    weight, first = weighted[0]
    rows = weight * _direction_rows(first)
    for weight, other in weighted[1:]:
        rows += weight * _direction_rows(other)
    return _from_direction_rows(rows)


def _from_direction_rows(rows: Array) -> Array:
    x, x_ok = _unit(rows[:3])
    y, _ = _unit(rows[3:])
    y, y_ok = _unit(y - np.sum(x * y, axis=0) * x)
    good = x_ok & y_ok
    if good.all():
        return _from_axes(x, y, _cross(x, y))
    # Any rotation will do where none is known: it is replaced.
    x[:, ~good], y[:, ~good] = [[1.0], [0.0], [0.0]], [[0.0], [1.0], [0.0]]
    return _carry_forward(_from_axes(x, y, _cross(x, y)), good)


def _rows(array: Array) -> Array:
    """Components first, each contiguous: that makes NumPy several times as fast."""
    return np.ascontiguousarray(np.moveaxis(array, -1, 0))


def _unit(vectors: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Vectors (3, ...) with length 1, and which of them had a length."""
    length = np.sqrt(np.einsum("c...,c...->...", vectors, vectors))
    ok = length > _COLLAPSED
    return vectors / np.where(ok, length, 1.0), ok


def _cross(a: Sequence[Array] | Array, b: Array) -> Array:
    """Cross products (3, ...) of vectors (3, ...)."""
    return np.stack([a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))])


def _from_axes(x: Array, y: Array, z: Array) -> Array:
    """Quaternions (..., 4) of rotation matrices by their columns, each (3, ...).

    4·w·(w, x, y, z) stands in the matrix's sums and differences and is normalised; where w is
    small, so are they, and 4·x·(w, x, y, z) or one of the other two serves (Shepperd 1978).
    """
    trace = x[0] + y[1] + z[2]
    result = np.stack([1.0 + trace, y[2] - z[1], z[0] - x[2], x[1] - y[0]])
    small = trace < _HALF_TURN
    if np.any(small):
        result[:, small] = _about_the_longest(x[:, small], y[:, small], z[:, small])
    result /= np.sqrt(np.einsum("c...,c...->...", result, result))
    return np.ascontiguousarray(np.moveaxis(result, 0, -1))


def _about_the_longest(x: Array, y: Array, z: Array) -> Array:
    """4·a·(w, x, y, z) (4, N), where a is the longest of x, y and z, of columns (3, N)."""
    cells = np.stack([x, y, z], axis=1)  # row, column, N
    n = np.arange(x.shape[1])
    i = np.argmax([x[0], y[1], z[2]], axis=0)
    j, k = (i + 1) % 3, (i + 2) % 3
    result = np.empty((4, len(n)))
    result[0] = cells[k, j, n] - cells[j, k, n]
    result[i + 1, n] = 1.0 + cells[i, i, n] - cells[j, j, n] - cells[k, k, n]
    result[j + 1, n] = cells[i, j, n] + cells[j, i, n]
    result[k + 1, n] = cells[i, k, n] + cells[k, i, n]
    return result


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
