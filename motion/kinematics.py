"""From local rotations to world positions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.rotations import conjugate, multiply, rotate
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

# Frames handled at once: the rows of one joint stay in the cache, and do not lie a multiple of
# 4 KiB apart, which would make them evict each other.
_BLOCK = 640


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
        The pose; both arrays are views whose memory is ordered joint, component, time, because
        each joint is worked on as contiguous rows of one component.
    """
    frames, joints = rotations.shape[:2]
    positions = np.empty((joints, 3, frames))
    world = np.empty((joints, 4, frames))
    solve = _Solver(skeleton, min(_BLOCK, frames)).solve
    for start in range(0, frames, _BLOCK):
        part = slice(start, min(start + _BLOCK, frames))
        solve(root_positions[part], rotations[part], positions[..., part], world[..., part])
    return WorldPose(positions.transpose(2, 0, 1), world.transpose(2, 0, 1))


def end_site_positions(skeleton: Skeleton, pose: WorldPose) -> Array:
    """World positions (T, E, 3) of the skeleton's E end sites, metres."""
    joints = [site.joint for site in skeleton.end_sites]
    offsets = np.array([site.offset for site in skeleton.end_sites]).reshape(-1, 3)
    return pose.positions[:, joints] + rotate(pose.rotations[:, joints], offsets)


class _Solver:
    """Solves blocks of frames, joint by joint.

    NumPy costs most by the call and by the pass over memory. Both a quaternion product a·b and a
    rotated offset R(a)·v are sums of products of components, a₀b₀ … a₃b₃ and a₀a₀ … a₃a₃: one call
    makes the sixteen products of a block, a small constant matrix sums them up.
    """

    def __init__(self, skeleton: Skeleton, block: int) -> None:
        self.parents = skeleton.parents.tolist()
        self.placements = np.einsum("rcp,jc->jrp", _ROTATION, skeleton.offsets)
        self.local = np.empty((len(skeleton), 4, block))
        self.squares = np.empty((4, 4, block))
        self.products = np.empty((4, 4, block))

    def solve(self, root: Array, rotations: Array, positions: Array, world: Array) -> None:
        """Fill positions (J, 3, B) and world (J, 4, B) from root (B, 3) and rotations (B, J, 4)."""
        count = len(root)
        local = self.local[..., :count]
        squares, products = self.squares[..., :count], self.products[..., :count]
        flat_squares, flat_products = squares.reshape(16, count), products.reshape(16, count)
        local[...] = rotations.transpose(1, 2, 0)
        positions[0], world[0] = root.T, local[0]
        before = -1
        for joint in range(1, len(self.parents)):
            parent = self.parents[joint]
            turn = world[parent]
            if parent != before:
                np.multiply(turn[:, None], turn, out=squares)
                before = parent
            np.multiply(turn[:, None], local[joint], out=products)
            np.matmul(_PRODUCT, flat_products, out=world[joint])
            place = positions[joint]
            np.matmul(self.placements[joint], flat_squares, out=place)
            place += positions[parent]


def _product_matrix() -> Array:
    """(4, 16) matrix that sums the products a₀b₀ … a₃b₃ up to the quaternion a·b."""
    one = np.eye(4)
    return np.array([[multiply(a, b) for b in one] for a in one]).reshape(16, 4).T


def _rotation_matrix() -> Array:
    """(3, 3, 16) matrix that sums the products a₀a₀ … a₃a₃ up to the rotation matrix of a.

    R(a) is quadratic in a, so its polarisation at two unit vectors gives their product's share.
    """
    one = np.eye(4)
    pure = np.pad(np.eye(3), ((0, 0), (1, 0)))  # the axes as quaternions without a scalar part
    parts = [[multiply(multiply(a, pure), conjugate(b))[:, 1:].T for b in one] for a in one]
    return np.stack([part for row in parts for part in row], axis=-1)


_PRODUCT = _product_matrix()
_ROTATION = _rotation_matrix()
