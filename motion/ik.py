"""Two-bone inverse kinematics: where the knee or elbow must be, for every frame at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.errors import MotionError
from motion.rotations import from_matrix

Array = NDArray[np.float64]

_TINY = 1e-9


@dataclass(frozen=True)
class TwoBones:
    """A solved limb.

    Attributes:
        middle: (T, 3) position of the middle joint, metres.
        end: (T, 3) position of the end joint: the target, unless it is out of reach.
        bend: (T,) angle between the bones, rad; 0 is straight.
        hinge: (T, 3) unit axis about which the second bone bends away from the first.
    """

    middle: Array
    end: Array
    bend: Array
    hinge: Array


def solve_two_bones(
    start: Array,
    target: Array,
    pole: Array,
    lengths: tuple[float | Array, float | Array],
    *,
    soft: float = 0.0,
) -> TwoBones:
    """Place the middle and end joints of a limb.

    Near full stretch a small change of the target turns the middle joint a lot (it "snaps").
    With ``soft`` above 0 the reach is compressed smoothly over that share of the limb's length, so
    that full stretch is only approached.

    Args:
        start: (T, 3) hip or shoulder, metres.
        target: (T, 3) where the ankle or wrist shall be.
        pole: (T, 3) or (3,) direction into which the middle joint points; any length, not along
            the limb.
        lengths: first and second bone, metres; (T,) each where limbs of several are solved.
        soft: share of the limb's length over which the reach is compressed, 0 to 0.5.

    Raises:
        MotionError: if a bone has no length or ``soft`` is out of its range.
    """
    upper, lower = lengths
    if min(np.min(upper), np.min(lower)) <= 0 or not 0.0 <= soft <= 0.5:
        raise MotionError(f"Bones {lengths} and softness {soft} make no limb.")
    reach, distance = _direction(target - start)
    limb = upper + lower
    distance = soft_limit(distance, limb, soft * limb)
    distance = np.clip(distance, np.abs(upper - lower) + _TINY, limb - _TINY * limb)
    along = (upper**2 - lower**2 + distance**2) / (2.0 * distance)
    aside = np.sqrt(np.maximum(upper**2 - along**2, 0.0))
    outward = _perpendicular(np.broadcast_to(pole, reach.shape), reach)
    cosine = (distance**2 - upper**2 - lower**2) / (2.0 * upper * lower)
    return TwoBones(
        middle=start + along[:, None] * reach + aside[:, None] * outward,
        end=start + distance[:, None] * reach,
        bend=np.arccos(np.clip(cosine, -1.0, 1.0)),
        hinge=np.cross(outward, reach),
    )


def soft_limit(distance: Array, limit: float | Array, width: float | Array) -> Array:
    """Distances (T,) compressed so that they approach ``limit`` but never pass it.

    The identity below ``limit − width``; from there exponential with a continuous slope.
    """
    if np.max(width) <= _TINY:
        return np.minimum(distance, limit)
    over = np.maximum(distance - (limit - width), 0.0)
    return np.where(over > 0, limit - width * np.exp(-over / width), distance)


def frame_along(direction: Array, hinge: Array, down: Array) -> Array:
    """World rotations (T, 4) that turn ``down`` into a bone's direction and x into its hinge.

    Args:
        direction: (T, 3) from the bone's near to its far joint; any length.
        hinge: (T, 3) the axis its local x shall lie along; need not be exactly perpendicular.
        down: (3,) the bone's direction at rest, perpendicular to x.
    """
    bone, _ = _direction(direction)
    x = _perpendicular(hinge, bone)
    rest = np.stack([np.array([1.0, 0.0, 0.0]), down, np.cross([1.0, 0.0, 0.0], down)], axis=-1)
    posed = np.stack([x, bone, np.cross(x, bone)], axis=-1)
    return from_matrix(posed @ rest.T)


def _direction(vectors: Array) -> tuple[Array, Array]:
    length = np.linalg.norm(vectors, axis=-1)
    safe = np.where(length > _TINY, length, 1.0)
    unit = np.where(length[..., None] > _TINY, vectors / safe[..., None], [0.0, -1.0, 0.0])
    return unit, length


def _perpendicular(vectors: Array, axis: Array) -> Array:
    """Unit parts of ``vectors`` (T, 3) at right angles to the unit ``axis`` (T, 3)."""
    rest = vectors - np.sum(vectors * axis, axis=-1, keepdims=True) * axis
    length = np.linalg.norm(rest, axis=-1, keepdims=True)
    helper = np.where(np.abs(axis[..., 2:]) < 0.9, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0])
    fallback = helper - np.sum(helper * axis, axis=-1, keepdims=True) * axis
    rest = np.where(length > _TINY, rest, fallback)
    unit: Array = rest / np.linalg.norm(rest, axis=-1, keepdims=True)
    return unit
