"""Emotion from examples (Amaya, Bruderlin & Calvert 1996): how fast, and how far.

The same action done neutrally and with an emotion tells two transforms: when along its way the
emotional one is faster (speed transform), and how much wider each joint swings (spatial amplitude
transform). Both can be put onto other actions of anybody.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from motion.clip import Clip
from motion.editing.limbs import end_relative_to_hips, find_limbs
from motion.editing.timing import resample
from motion.errors import MotionError
from motion.kinematics import forward_kinematics
from motion.rotations import conjugate, from_directions, multiply, to_directions

Array = NDArray[np.float64]

_WIDEST = 4.0  # times wider or narrower that a joint may swing
_SMALLEST = np.radians(0.5)  # what a joint must swing in the neutral action to be compared
_XYZW, _WXYZ = [1, 2, 3, 0], [3, 0, 1, 2]
_SAMPLES = 101
_EVEN = 0.1  # of a mean progress, mixed in so that the way never stands still


@dataclass(frozen=True, eq=False)
class EmotionTransform:
    """What an emotion does to an action.

    Attributes:
        pace: how many times as long the emotional action lasts.
        timing: (101,) at even shares of the emotional action's time, the share of the neutral
            one's at which the body had come as far.
        amplitude: body role to how many times as wide the joint swings.
    """

    pace: float
    timing: Array
    amplitude: Mapping[str, float]


def learn_emotion(neutral: Clip, emotional: Clip) -> EmotionTransform:
    """The transform between two performances of the same action, by one body or two.

    Raises:
        MotionError: if one of them does not last.
    """
    if min(neutral.frames, emotional.frames) < 4:
        raise MotionError("An emotion is learned from two clips of at least 4 frames.")
    shares = np.linspace(0.0, 1.0, _SAMPLES)
    before, after = _progress(neutral), _progress(emotional)
    far = np.interp(shares, np.linspace(0.0, 1.0, len(after)), after)
    timing = np.interp(far, before, np.linspace(0.0, 1.0, len(before)))
    common = [role for role in neutral.skeleton.roles if role in emotional.skeleton.roles]
    amplitude = {}
    for role in common:
        swings = [_swing(clip, clip.skeleton.roles[role]) for clip in (neutral, emotional)]
        if swings[0] > _SMALLEST:
            amplitude[role] = float(np.clip(swings[1] / swings[0], 1.0 / _WIDEST, _WIDEST))
    return EmotionTransform(emotional.duration / neutral.duration, timing, amplitude)


def apply_emotion(clip: Clip, emotion: EmotionTransform, amount: float = 1.0) -> Clip:
    """The clip done with an emotion; its feet may need repair afterwards.

    Args:
        clip: any action of any skeleton with body roles.
        emotion: learned from another.
        amount: 0 leaves the clip, 1 is as learned, more exaggerates.
    """
    if amount == 0.0 or clip.frames < 4:
        return clip
    rotations = clip.rotations.copy()
    for role, times in emotion.amplitude.items():
        # The hips' turn is where the body goes, which is no matter of expression.
        if role in clip.skeleton.roles and clip.skeleton.roles[role] != 0:
            joint = clip.skeleton.roles[role]
            rotations[:, joint] = _widened(clip.rotations[:, joint], times**amount)
    return _in_time(replace(clip, rotations=rotations), emotion, amount)


def _in_time(clip: Clip, emotion: EmotionTransform, amount: float) -> Clip:
    last = clip.frames - 1
    frames = max(3, round(last * emotion.pace**amount))
    shares = np.linspace(0.0, 1.0, frames + 1)
    learned = np.interp(shares, np.linspace(0.0, 1.0, _SAMPLES), emotion.timing)
    # Exaggerated, time might run backwards; it may at most stand still.
    at = np.maximum.accumulate(np.clip(shares + amount * (learned - shares), 0.0, 1.0)) * last
    root = CubicSpline(np.arange(clip.frames), clip.root_positions)(at)
    return replace(clip, root_positions=root, rotations=resample(clip.rotations, at))


def _progress(clip: Clip) -> Array:
    """(T,) from 0 to 1: how much of the way of all limbs' ends is done."""
    pose = forward_kinematics(clip)
    way = np.zeros(clip.frames - 1)
    for limb in find_limbs(clip.skeleton).values():
        path = end_relative_to_hips(clip, pose, limb)
        way += np.linalg.norm(np.diff(path, axis=0), axis=1)
    way = way + _EVEN * way.mean() + 1e-12
    return np.concatenate([[0.0], np.cumsum(way)]) / way.sum()


def _mean(rotations: Array) -> Array:
    """(4,) rotation in the middle of rotations (T, 4)."""
    return from_directions(to_directions(rotations).mean(axis=0, keepdims=True))[0]


def _away(rotations: Array, middle: Array) -> Array:
    """Rotation vectors (T, 3) from the middle."""
    return Rotation.from_quat(multiply(conjugate(middle), rotations)[:, _XYZW]).as_rotvec()


def _swing(clip: Clip, joint: int) -> float:
    """Root of the mean squared angle, rad, by which a joint leaves its mean."""
    rotations = clip.rotations[:, joint]
    return float(np.sqrt(np.mean(np.sum(_away(rotations, _mean(rotations)) ** 2, axis=1))))


def _widened(rotations: Array, times: float) -> Array:
    middle = _mean(rotations)
    vectors = times * _away(rotations, middle)
    # Half a turn from the middle is the farthest; beyond it the joint would come back behind.
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    vectors *= np.minimum(1.0, 0.95 * np.pi / np.maximum(length, 1e-12))
    return multiply(middle, Rotation.from_rotvec(vectors).as_quat()[:, _WXYZ])
