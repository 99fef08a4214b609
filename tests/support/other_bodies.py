"""A motion of another body than the samples': names of its own, smaller, with longer arms."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np

from motion import Clip
from motion.bvh_write import write_bvh
from motion.editing.cycles import three_cycles
from tests.support.motions import walk

SMALLER = 0.86
LONGER_ARMS = 1.08
_PARTS = {
    "clavicle": "Shoulder",
    "upper_arm": "Arm",
    "forearm": "ForeArm",
    "hand": "Hand",
    "thigh": "UpLeg",
    "shin": "Leg",
    "foot": "Foot",
    "toes": "ToeBase",
}


@cache
def stranger() -> Clip:
    """Three strides, not yet cut to one."""
    strides = three_cycles(walk())
    body = strides.skeleton
    arms = np.array([any(part in name for part in ("forearm", "hand")) for name in body.names])
    offsets = body.offsets * SMALLER * np.where(arms, LONGER_ARMS, 1.0)[:, None]
    named = replace(body, names=tuple(map(_renamed, body.names)), offsets=offsets)
    return replace(strides, skeleton=named, root_positions=strides.root_positions * SMALLER)


@cache
def stranger_bvh() -> bytes:
    """The same as a BVH file, in centimetres."""
    return write_bvh(stranger())


def _renamed(name: str) -> str:
    side, _, part = name.partition("_")
    return side.title() + _PARTS[part] if part else name.title()
