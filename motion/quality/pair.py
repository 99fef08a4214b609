"""An original and its edit, posed once for all measures."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from motion.clip import Clip
from motion.editing.foot_plants import Foot, find_feet
from motion.editing.timing import resample
from motion.errors import MotionError
from motion.kinematics import WorldPose, forward_kinematics
from motion.standing import standing_rotations

Array = NDArray[np.float64]


def matched(original: Clip, edited: Clip) -> Pair:
    """The two clips frame by frame; an edit that lasts longer is compared with a slower original.

    Raises:
        MotionError: if their skeletons differ.
    """
    if original.skeleton.content_hash != edited.skeleton.content_hash:
        raise MotionError("An edit is judged against the same skeleton; these two differ.")
    if (original.frames, original.frame_time) == (edited.frames, edited.frame_time):
        return Pair(original, edited)
    if min(original.frames, edited.frames) < 2:
        raise MotionError(
            f"An edited clip of {edited.frames} frames cannot be judged against one of "
            f"{original.frames}."
        )
    at = np.linspace(0.0, original.frames - 1.0, edited.frames)
    root = CubicSpline(np.arange(original.frames), original.root_positions)(at)
    slower = Clip(original.skeleton, root, resample(original.rotations, at), edited.frame_time)
    return Pair(slower, edited)


@dataclass(frozen=True, eq=False)
class Pair:
    """The clip before and after an edit, frame by frame; see ``matched``."""

    original: Clip
    edited: Clip

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
