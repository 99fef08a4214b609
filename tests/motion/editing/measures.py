"""What tests measure on edited clips, apart from the code that edits."""

from __future__ import annotations

import numpy as np

from motion import Clip
from motion.kinematics import forward_kinematics


def hands_path(clip: Clip) -> float:
    """Way of both hands relative to the hips, metres."""
    positions, roles = forward_kinematics(clip).positions, clip.skeleton.roles
    hands = positions[:, [roles["left_hand"], roles["right_hand"]]]
    relative = hands - positions[:, [roles["hips"]]]
    return float(np.linalg.norm(np.diff(relative, axis=0), axis=-1).sum())


def bone_lengths(clip: Clip) -> np.ndarray:
    """(T, J − 1) distance of every joint from its parent, metres."""
    positions = forward_kinematics(clip).positions
    return np.linalg.norm(positions[:, 1:] - positions[:, clip.skeleton.parents[1:]], axis=-1)


def strongest_hip_acceleration(clip: Clip) -> float:
    """m/s²."""
    second = np.diff(clip.root_positions, 2, axis=0) / clip.frame_time**2
    return float(np.linalg.norm(second, axis=1).max())


def fastest_turn(clip: Clip) -> float:
    """Highest angular speed of any joint, rad/s, from the rotation matrices' traces."""
    dots = np.abs(np.sum(clip.rotations[1:] * clip.rotations[:-1], axis=-1))
    return float(2 * np.arccos(np.minimum(dots, 1.0)).max() / clip.frame_time)
