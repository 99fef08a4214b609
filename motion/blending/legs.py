"""Legs that bring the feet of a blend to where they shall be."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from motion.blending.feet import BlendedFoot
from motion.clip import Clip
from motion.ik import solve_two_bones
from motion.kinematics import pose_to_world
from motion.rotations import between, conjugate, multiply, rotate

Array = NDArray[np.float64]

_NOTHING = 1e-9  # m: feet that are off by less are where they shall be
_HINT = 0.01  # m: how much a straight knee is told which way is ahead


def onto_feet(clip: Clip, feet: Sequence[BlendedFoot]) -> Array:
    """Rotations (T, J, 4) of a clip with its F feet where they shall be.

    All legs are turned at once: arrays lead with (T, F).
    """
    rotations = clip.rotations.copy()
    if not feet:
        return rotations
    pose = pose_to_world(clip.skeleton, clip.root_positions, clip.rotations)
    target = np.stack([foot.goal(clip, pose) for foot in feet], axis=1)
    turn = np.stack([foot.turn for foot in feet], axis=1)
    thigh, shin, ankle = np.array([(f.foot.thigh, f.foot.shin, f.foot.ankle) for f in feet]).T
    hip, knee, end = (pose.positions[:, joints] for joints in (thigh, shin, ankle))
    first, second = _turns(hip, knee, end, target)
    both = multiply(second, first)
    parents = clip.skeleton.parents
    above = pose.rotations[:, parents[thigh]]
    new = multiply(first, pose.rotations[:, thigh])
    rotations[:, thigh] = multiply(conjugate(above), new)
    above = multiply(first, pose.rotations[:, parents[shin]])
    new = multiply(both, pose.rotations[:, shin])
    rotations[:, shin] = multiply(conjugate(above), new)
    above = multiply(both, pose.rotations[:, parents[ankle]])
    rotations[:, ankle] = multiply(conjugate(above), turn)
    return rotations


def _turns(hip: Array, knee: Array, ankle: Array, target: Array) -> tuple[Array, Array]:
    """World turns (T, F, 4) of the whole legs, and then of the lower legs, onto the targets."""
    gap = np.linalg.norm(target - ankle, axis=-1).max()
    if gap <= _NOTHING:
        still = np.zeros((*target.shape[:2], 4))
        still[..., 0] = 1.0
        return still, still
    upper, lower = knee - hip, ankle - knee
    lengths = [_rows(np.broadcast_to(_length(b).mean(axis=0), b.shape)) for b in (upper, lower)]
    pole = _knee_way(hip, knee, ankle, min(_HINT, float(gap)))
    solved = solve_two_bones(
        _rows(hip), _rows(target), _rows(pole), (lengths[0][:, 0], lengths[1][:, 0])
    )
    middle, end = solved.middle.reshape(hip.shape), solved.end.reshape(hip.shape)
    first = between(_unit(upper), _unit(middle - hip))
    return first, between(_unit(rotate(first, lower)), _unit(end - middle))


def _knee_way(hip: Array, knee: Array, ankle: Array, hint: float) -> Array:
    """(T, F, 3) whither knees point: where they do, and a little ahead in case one is straight."""
    limb = _unit(ankle - hip)
    out = knee - hip
    out = out - np.sum(out * limb, axis=-1, keepdims=True) * limb
    return out + hint * np.array([0.0, 0.0, 1.0])


def _rows(vectors: Array) -> Array:
    return vectors.reshape(-1, 3)


def _length(vectors: Array) -> Array:
    return np.linalg.norm(vectors, axis=-1, keepdims=True)


def _unit(vectors: Array) -> Array:
    return vectors / np.maximum(_length(vectors), 1e-12)
