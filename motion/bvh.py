"""Read BVH: the hierarchy and the numbers as the file has them.

What the numbers mean in Manner's conventions is decided in ``motion.ingest``.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.bvh_hierarchy import BvhJoint, BvhTip, read_hierarchy
from motion.bvh_motion import read_motion
from motion.bvh_text import Limits, Note, Scanner, normalise_text
from motion.bvh_write import write_bvh

__all__ = ["BvhFile", "BvhJoint", "BvhTip", "Limits", "Note", "read_bvh", "write_bvh"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class BvhFile:
    """A BVH file's content, nothing converted.

    Attributes:
        joints: all joints in the file's order; every parent before its children.
        tips: end sites.
        values: (T, C) channel values; the columns follow the joints' channels.
        frame_time: seconds a frame; None where the file has no motion.
        motion_line: 1-based line of the first frame; None without motion.
        notes: what was repaired or left as it is.
    """

    joints: tuple[BvhJoint, ...]
    tips: tuple[BvhTip, ...]
    values: Array
    frame_time: float | None
    motion_line: int | None
    notes: tuple[Note, ...]

    @property
    def roots(self) -> tuple[int, ...]:
        """Indices of the joints without a parent."""
        return tuple(index for index, joint in enumerate(self.joints) if joint.parent < 0)


def read_bvh(
    data: bytes,
    *,
    limits: Limits | None = None,
    fill_gaps: bool = False,
    frame_time: float | None = None,
) -> BvhFile:
    """Read a BVH file.

    Args:
        data: the file's bytes.
        limits: what it may hold at most.
        fill_gaps: interpolate over values that are not finite instead of refusing them.
        frame_time: seconds a frame, instead of what the file says.

    Raises:
        BvhSyntaxError: with line and column, if the text has no single meaning.
    """
    limits = limits or Limits()
    text, notes = normalise_text(data, limits)
    scanner = Scanner(text)
    joints, tips = read_hierarchy(scanner, limits, notes)
    motion = read_motion(scanner, joints, limits, notes, fill_gaps, frame_time)
    return BvhFile(joints, tips, motion.values, motion.frame_time, motion.line, tuple(notes))
