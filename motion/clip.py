"""A motion: one skeleton and its pose in every frame."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from motion.errors import MotionError
from motion.skeleton import Skeleton


@dataclass(frozen=True, eq=False)
class Clip:
    """Frames at an even rate.

    Attributes:
        skeleton: the J joints.
        root_positions: (T, 3) world position of the root joint, metres.
        rotations: (T, J, 4) local rotation of each joint, unit quaternions wxyz.
        frame_time: seconds from one frame to the next.
        cyclic: the last frame is the first again, moved by the travel of one cycle.

    Raises:
        MotionError: if shapes disagree, a number is not finite or the frame time is not positive.
    """

    skeleton: Skeleton
    root_positions: NDArray[np.float64]
    rotations: NDArray[np.float64]
    frame_time: float
    cyclic: bool = False

    def __post_init__(self) -> None:
        frames = len(self.root_positions)
        expected = (frames, len(self.skeleton), 4)
        if self.root_positions.shape != (frames, 3) or self.rotations.shape != expected:
            raise MotionError(
                f"Expected root positions ({frames}, 3) and rotations {expected}; "
                f"got {self.root_positions.shape} and {self.rotations.shape}."
            )
        if not (np.isfinite(self.frame_time) and self.frame_time > 0):
            raise MotionError(f"The frame time must be above 0 s, not {self.frame_time}.")
        if not (np.isfinite(self.root_positions).all() and np.isfinite(self.rotations).all()):
            raise MotionError("Positions and rotations must be finite numbers.")
        for array in (self.root_positions, self.rotations):
            array.setflags(write=False)

    @property
    def frames(self) -> int:
        """Number of frames T."""
        return len(self.root_positions)

    @property
    def duration(self) -> float:
        """Seconds from the first frame to the last."""
        return max(self.frames - 1, 0) * self.frame_time

    @property
    def travel(self) -> NDArray[np.float64]:
        """(3,) way of the root from the first frame to the last, metres."""
        if self.frames == 0:
            return np.zeros(3)
        return self.root_positions[-1] - self.root_positions[0]

    @cached_property
    def content_hash(self) -> str:
        """SHA-256 of skeleton and motion: equal hashes mean equal clips."""
        digest = hashlib.sha256(self.skeleton.content_hash.encode())
        digest.update(np.asarray(self.root_positions, "<f8").tobytes())
        digest.update(np.asarray(self.rotations, "<f8").tobytes())
        digest.update(np.array([self.frame_time, self.cyclic], "<f8").tobytes())
        return digest.hexdigest()
