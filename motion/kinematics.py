"""From local rotations to world positions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.rotations import rotate
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

# Frames handled at once: small enough for the working set of one joint to stay in the cache.
_BLOCK = 2048


@dataclass(frozen=True)
class WorldPose:
    """World positions (T, J, 3) in metres and world rotations (T, J, 4), wxyz."""

    positions: Array
    rotations: Array


def forward_kinematics(clip: Clip) -> WorldPose:
    """World pose of every joint in every frame of a clip."""
    return pose_to_world(clip.skeleton, clip.root_positions, clip.rotations)


def pose_to_world(skeleton: Skeleton, root_positions: Array, rotations: Array) -> WorldPose:
    """World pose of local rotations.

    Args:
        skeleton: J joints.
        root_positions: (T, 3) metres.
        rotations: (T, J, 4) local, wxyz.

    Returns:
        The pose; both arrays are views whose memory is ordered component, joint, time, because
        each joint is worked on as contiguous rows of one component.
    """
    frames, joints = rotations.shape[:2]
    positions = np.empty((3, joints, frames))
    world = np.empty((4, joints, frames))
    for start in range(0, frames, _BLOCK):
        part = slice(start, min(start + _BLOCK, frames))
        local = np.ascontiguousarray(rotations[part].transpose(2, 1, 0))
        _solve_block(skeleton, root_positions[part].T, local, positions[:, :, part], world[:, :, part])
    return WorldPose(positions.transpose(2, 1, 0), world.transpose(2, 1, 0))


def end_site_positions(skeleton: Skeleton, pose: WorldPose) -> Array:
    """World positions (T, E, 3) of the skeleton's E end sites, metres."""
    joints = [site.joint for site in skeleton.end_sites]
    offsets = np.array([site.offset for site in skeleton.end_sites]).reshape(-1, 3)
    return pose.positions[:, joints] + rotate(pose.rotations[:, joints], offsets)


def _solve_block(
    skeleton: Skeleton, root: Array, local: Array, positions: Array, world: Array
) -> None:
    positions[:, 0] = root
    world[:, 0] = local[:, 0]
    scratch = np.empty((4, local.shape[2]))
    for joint in range(1, len(skeleton)):
        parent = int(skeleton.parents[joint])
        turn = world[:, parent]
        _multiply_rows(turn, local[:, joint], world[:, joint], scratch[0])
        _place_rows(turn, skeleton.offsets[joint], positions[:, parent], positions[:, joint], scratch)


def _multiply_rows(a: Array, b: Array, out: Array, scratch: Array) -> None:
    """Write the quaternion product a·b, all (4, T), row by row without temporary arrays."""
    for row, terms in enumerate(_PRODUCT):
        target = out[row]
        np.multiply(a[terms[0][0]], b[terms[0][1]], out=target)
        for left, right, sign in terms[1:]:
            np.multiply(a[left], b[right], out=scratch)
            (np.add if sign > 0 else np.subtract)(target, scratch, out=target)


def _place_rows(turn: Array, offset: Array, parent: Array, out: Array, scratch: Array) -> None:
    """Write parent + R(turn)·offset into out (3, T): offset + w·t + v × t with t = 2 v × offset."""
    w, v = turn[0], turn[1:]
    t = scratch[:3]
    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        np.multiply(v[b], 2.0 * offset[c], out=t[axis])
        np.multiply(v[c], 2.0 * offset[b], out=scratch[3])
        np.subtract(t[axis], scratch[3], out=t[axis])
    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        target = out[axis]
        np.add(parent[axis], offset[axis], out=target)
        for left, right, add in ((w, t[axis], True), (v[b], t[c], True), (v[c], t[b], False)):
            np.multiply(left, right, out=scratch[3])
            (np.add if add else np.subtract)(target, scratch[3], out=target)


# Hamilton product by component: (left factor, right factor, sign); the first term is positive.
_PRODUCT = (
    ((0, 0, 1), (1, 1, -1), (2, 2, -1), (3, 3, -1)),
    ((0, 1, 1), (1, 0, 1), (2, 3, 1), (3, 2, -1)),
    ((0, 2, 1), (2, 0, 1), (3, 1, 1), (1, 3, -1)),
    ((0, 3, 1), (3, 0, 1), (1, 2, 1), (2, 1, -1)),
)
