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

_NOTHING = 1e-9  # m: a foot that is off by less is where it shall be
_HINT = 0.01  # m: how much a straight knee is told which way is ahead


def onto_feet(clip: Clip, feet: Sequence[BlendedFoot]) -> Array:
    """Rotations (T, J, 4) of a clip with its feet where they shall be."""
    skeleton, rotations = clip.skeleton, clip.rotations.copy()
    pose = pose_to_world(skeleton, clip.root_positions, clip.rotations)
    for blended in feet:
        foot, target = blended.foot, blended.goal(clip, pose)
        hip, knee, ankle = (pose.positions[:, j] for j in (foot.thigh, foot.shin, foot.ankle))
        gap = np.linalg.norm(target - ankle, axis=-1).max()
        whole = np.zeros((len(target), 4))
        whole[:, 0] = 1.0
        first = second = whole
        if gap > _NOTHING:
            upper, lower = knee - hip, ankle - knee
            lengths = (_length(upper), _length(lower))
            pole = _knee_way(hip, knee, ankle, blended.turn, min(_HINT, float(gap)))
            solved = solve_two_bones(hip, target, pole, lengths)
            first = between(_unit(upper), _unit(solved.middle - hip))
            second = between(_unit(rotate(first, lower)), _unit(solved.end - solved.middle))
        both = multiply(second, first)
        parents = skeleton.parents
        above = pose.rotations[:, parents[foot.thigh]]
        thigh = multiply(first, pose.rotations[:, foot.thigh])
        rotations[:, foot.thigh] = multiply(conjugate(above), thigh)
        over_shin = multiply(first, pose.rotations[:, parents[foot.shin]])
        shin = multiply(both, pose.rotations[:, foot.shin])
        rotations[:, foot.shin] = multiply(conjugate(over_shin), shin)
        over_ankle = multiply(both, pose.rotations[:, parents[foot.ankle]])
        rotations[:, foot.ankle] = multiply(conjugate(over_ankle), blended.turn)
    return rotations


def _knee_way(hip: Array, knee: Array, ankle: Array, turn: Array, hint: float) -> Array:
    """(T, 3) whither the knee points: where it does, and a little ahead in case it is straight."""
    limb = _unit(ankle - hip)
    out = knee - hip
    out = out - np.sum(out * limb, axis=-1, keepdims=True) * limb
    return out + hint * np.array([0.0, 0.0, 1.0])


def _length(vectors: Array) -> float:
    return float(np.linalg.norm(vectors, axis=-1).mean())


def _unit(vectors: Array) -> Array:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-12)
