"""An original and its edit, posed once for all measures."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.editing.foot_plants import Foot, find_feet
from motion.errors import MotionError
from motion.kinematics import WorldPose, forward_kinematics
from motion.standing import standing_rotations

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Pair:
    """The clip before and after an edit, frame by frame.

    Raises:
        MotionError: if the two do not share skeleton, frames and frame time.
    """

    original: Clip
    edited: Clip

    def __post_init__(self) -> None:
        if self.original.skeleton.content_hash != self.edited.skeleton.content_hash:
            raise MotionError("An edit is judged against the same skeleton; these two differ.")
        if (self.original.frames, self.original.frame_time) != (
            self.edited.frames,
            self.edited.frame_time,
        ):
            raise MotionError(
                f"An edit is judged frame by frame: the original has {self.original.frames} "
                f"frames of {self.original.frame_time:.4g} s, the edited clip "
                f"{self.edited.frames} of {self.edited.frame_time:.4g} s."
            )

    @property
    def roles(self) -> Mapping[str, int]:
        """Body role to joint."""
        return self.original.skeleton.roles

    @cached_property
    def before(self) -> WorldPose:
        """The original's world pose."""
        return forward_kinematics(self.original)

    @cached_property
    def after(self) -> WorldPose:
        """The edited clip's world pose."""
        return forward_kinematics(self.edited)

    @cached_property
    def feet(self) -> tuple[Foot, Foot]:
        """The original's feet and when they stand."""
        return find_feet(self.original, self.before)

    @cached_property
    def standing(self) -> Array:
        """(J, 4) world rotations of the skeleton in upright standing."""
        return standing_rotations(self.original)
