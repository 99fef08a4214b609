"""What presets shall change, measured from world positions and rotations alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d

from motion import Clip
from motion.kinematics import WorldPose, forward_kinematics
from motion.rotations import conjugate, rotate
from motion.standing import standing_rotations

_HANDS = ("left_hand", "right_hand")
_ENDS = (*_HANDS, "left_foot", "right_foot", "head")
_SMOOTH = 0.02  # s: the noise of single frames is no jerk


def measure(clip: Clip, before: Clip | None = None) -> dict[str, float]:
    """Every feature of a clip by name.

    ``before``, the clip from which it was made, tells how the body stands: an edit that bows the
    head would otherwise be taken for the way in which the head is built.
    """
    pose, stance = forward_kinematics(clip), standing_rotations(before or clip)
    return {name: feature.of(clip, pose, stance) for name, feature in FEATURES.items()}


def _hands_path(clip: Clip, pose: WorldPose, _: np.ndarray) -> float:
    """Way of both hands relative to the hips, m."""
    return float(sum(_steps(clip, pose, role).sum() for role in _HANDS))


def _mean_speed(clip: Clip, pose: WorldPose, _: np.ndarray) -> float:
    """Of hands, feet and head relative to the hips, m/s."""
    return float(np.mean([_steps(clip, pose, role) for role in _ENDS]) / clip.frame_time)


def _unevenness(clip: Clip, pose: WorldPose, _: np.ndarray) -> float:
    """Standard deviation of the hands' speed in units of its mean, where they move."""
    found = []
    for role in _HANDS:
        speed = _steps(clip, pose, role)
        moving = speed[speed > 0.1 * np.quantile(speed, 0.95)]
        found.append(moving.std() / moving.mean())
    return float(np.mean(found))


def _jerk(clip: Clip, pose: WorldPose, _: np.ndarray) -> float:
    """Root mean square of the third derivative of the same paths, m/s³."""
    paths = np.stack([_relative(clip, pose, role) for role in _ENDS], axis=1)
    smooth = gaussian_filter1d(paths, _SMOOTH / clip.frame_time, axis=0, mode="nearest")
    third = np.diff(smooth, 3, axis=0) / clip.frame_time**3
    return float(np.sqrt(np.mean(np.sum(third**2, axis=-1))))


def _head_pitch(clip: Clip, pose: WorldPose, stance: np.ndarray) -> float:
    """How far the nose points down, ° on the mean."""
    head = clip.skeleton.roles["head"]
    nose = rotate(conjugate(stance[head]), np.array([0.0, 0.0, 1.0]))
    gaze = rotate(pose.rotations[:, head], nose)
    return float(np.degrees(np.arcsin(np.clip(-gaze[:, 1], -1.0, 1.0))).mean())


def _arm_span(clip: Clip, pose: WorldPose, _: np.ndarray) -> float:
    """Width from the outermost of the left arm to that of the right, m on the mean."""
    across = _across(clip, pose)
    outermost = [
        np.max(
            [sign * _along(clip, pose, f"{side}_{part}", across) for part in ("forearm", "hand")],
            axis=0,
        )
        for side, sign in (("left", 1.0), ("right", -1.0))
    ]
    return float(np.sum(outermost, axis=0).mean())


def _feet_apart(clip: Clip, pose: WorldPose, _: np.ndarray) -> float:
    """Sideways distance of the ankles, m on the mean."""
    across = _across(clip, pose)
    left, right = (_along(clip, pose, f"{side}_foot", across) for side in ("left", "right"))
    return float((left - right).mean())


@dataclass(frozen=True)
class Feature:
    """A measure of a clip, its unit, and how many digits of it are told."""

    of: Callable[[Clip, WorldPose, np.ndarray], float]
    unit: str
    digits: int


FEATURES: Mapping[str, Feature] = {
    "hands' path": Feature(_hands_path, "m", 2),
    "mean speed": Feature(_mean_speed, "m/s", 3),
    "unevenness": Feature(_unevenness, "", 3),
    "jerk": Feature(_jerk, "m/s³", 0),
    "head pitch": Feature(_head_pitch, "°", 1),
    "arm span": Feature(_arm_span, "m", 3),
    "feet apart": Feature(_feet_apart, "m", 3),
}


def _relative(clip: Clip, pose: WorldPose, role: str) -> np.ndarray:
    roles = clip.skeleton.roles
    return pose.positions[:, roles[role]] - pose.positions[:, roles["hips"]]


def _steps(clip: Clip, pose: WorldPose, role: str) -> np.ndarray:
    return np.linalg.norm(np.diff(_relative(clip, pose, role), axis=0), axis=-1)


def _across(clip: Clip, pose: WorldPose) -> np.ndarray:
    """(T, 3) level direction from the right hip joint to the left one."""
    roles = clip.skeleton.roles
    way = pose.positions[:, roles["left_thigh"]] - pose.positions[:, roles["right_thigh"]]
    way = way * [1.0, 0.0, 1.0]
    return way / np.linalg.norm(way, axis=-1, keepdims=True)


def _along(clip: Clip, pose: WorldPose, role: str, direction: np.ndarray) -> np.ndarray:
    return np.sum(_relative(clip, pose, role) * direction, axis=-1)
