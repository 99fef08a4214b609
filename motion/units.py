"""How large a skeleton's unit is, where up is and where the body faces."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.kinematics import WorldPose
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

UNITS = {
    "metres": 1.0,
    "decimetres": 0.1,
    "centimetres": 0.01,
    "millimetres": 0.001,
    "inches": 0.0254,
    "feet": 0.3048,
    "CMU units (5.64 cm)": 0.0254 / 0.45,
}
"""Metres in each unit that BVH files are known to use."""

TYPICAL_STATURE = 1.7
PLAUSIBLE_STATURE = (1.2, 2.2)
_HEAD = 0.105  # of the stature from the base of the skull to the crown
_ANKLE = 0.039  # of the stature from the sole to the ankle (Drillis & Contini 1966)

AXES = ("y", "z", "x", "-y", "-z", "-x")


def stature(skeleton: Skeleton, roles: Mapping[str, int], ankle: float = 0.0) -> float:
    """Standing height, in the skeleton's units, along its bones: independent of the pose.

    Ankles to hip joints, hips to head along the trunk; the part above the head's joint is
    estimated, the part below the ankles too if ``ankle``, their height, is not given or is not
    that of an ankle. Zero where roles are missing.
    """
    legs = [
        _way(skeleton, roles[f"{side}_foot"], roles[f"{side}_thigh"])
        for side in ("left", "right")
        if f"{side}_foot" in roles and f"{side}_thigh" in roles
    ]
    if not legs or "head" not in roles or "hips" not in roles:
        return 0.0
    trunk = _way(skeleton, roles["head"], roles["hips"])
    drop = _hip_drop(skeleton, roles)
    known = float(np.mean(legs)) + trunk + drop
    tips = [site.offset for site in skeleton.end_sites if site.joint == roles["head"]]
    crown = max((math.hypot(*tip) for tip in tips), default=0.0)
    height = max((known + crown) / (1 - _ANKLE), known / (1 - _ANKLE - _HEAD))
    if 0.02 * height < ankle < 0.09 * height:
        height = max(known + crown + ankle, (known + ankle) / (1 - _HEAD))
    return height


def standing_height(clip: Clip, pose: WorldPose, floor: float = 0.0) -> float:
    """Standing height of a clip's body in metres: ``stature``, its ankles as high as they stand.

    Args:
        clip: in metres, y up.
        pose: of the clip, in the world.
        floor: height of the floor that it stands on.
    """
    roles = clip.skeleton.roles
    feet = [roles[role] for role in ("left_foot", "right_foot") if role in roles]
    ankle = float(pose.positions[:, feet, 1].min()) - floor if feet else 0.0
    return stature(clip.skeleton, roles, ankle)


def _way(skeleton: Skeleton, joint: int, ancestor: int) -> float:
    length = 0.0
    while joint > ancestor:
        length += float(np.linalg.norm(skeleton.offsets[joint]))
        joint = int(skeleton.parents[joint])
    return length


def _hip_drop(skeleton: Skeleton, roles: Mapping[str, int]) -> float:
    """How far the middle of the hip joints lies from the hips: below them, when standing."""
    places = []
    for side in ("left", "right"):
        joint, place = roles.get(f"{side}_thigh", 0), np.zeros(3)
        while joint > roles["hips"]:
            place = place + skeleton.offsets[joint]
            joint = int(skeleton.parents[joint])
        places.append(place)
    return float(np.linalg.norm(np.mean(places, axis=0)))


def guess_unit(height: float) -> tuple[float, str, bool]:
    """Metres per unit for a body ``height`` units tall, the unit's name, and whether it is likely.

    Where no known unit gives a grown person, the unit is the one that makes it 1.7 m tall.
    """
    if height <= 0:
        return UNITS["centimetres"], "centimetres", False
    name = min(UNITS, key=lambda unit: abs(math.log(UNITS[unit] * height / TYPICAL_STATURE)))
    low, high = PLAUSIBLE_STATURE
    if low <= UNITS[name] * height <= high:
        return UNITS[name], name, True
    unit = TYPICAL_STATURE / height
    return unit, f"units of {unit:.4g} m", False


def unit_name(unit: float) -> str:
    """The name of a unit given in metres."""
    for name, metres in UNITS.items():
        if math.isclose(metres, unit, rel_tol=1e-3):
            return name
    return f"units of {unit:.4g} m"


def guess_up(pose: WorldPose, roles: Mapping[str, int]) -> tuple[str, float]:
    """The axis that points from the feet to the head in most frames, and how clearly (0 … 1)."""
    feet = [roles[role] for role in ("left_foot", "right_foot") if role in roles]
    if not feet or "head" not in roles:
        return "y", 0.0
    upward = pose.positions[:, roles["head"]] - pose.positions[:, feet].mean(axis=1)
    upward = upward / np.maximum(np.linalg.norm(upward, axis=-1, keepdims=True), 1e-12)
    mean = np.median(upward, axis=0)
    axis = int(np.argmax(np.abs(mean)))
    return ("-" if mean[axis] < 0 else "") + "xyz"[axis], float(abs(mean[axis]))


def turn_up(axis: str) -> Array:
    """(3, 3) rotation that brings an axis such as ``z`` or ``-y`` to +y, by quarter turns."""
    sign = -1.0 if axis.startswith("-") else 1.0
    place = "xyz".index(axis[-1])
    if place == 1:
        return np.diag([1.0, 1.0, 1.0] if sign > 0 else [1.0, -1.0, -1.0])
    up = np.zeros(3)
    up[place] = sign
    side = np.array([1.0, 0.0, 0.0]) if place == 2 else np.array([0.0, 0.0, 1.0])
    other = np.cross(side, up) if place == 2 else np.cross(up, side)
    rows = [side, up, other] if place == 2 else [other, up, side]
    return np.array(rows)


def heading(pose: WorldPose, roles: Mapping[str, int]) -> Array:
    """Heading (T,) of the body in rad about +y, zero facing +z, for a pose with y up.

    The body faces at right angles to the line from its right to its left hip joint and shoulder.
    """
    across = np.zeros((len(pose.positions), 3))
    for part in ("thigh", "upper_arm"):
        pair = [roles.get(f"{side}_{part}") for side in ("left", "right")]
        if pair[0] is not None and pair[1] is not None:
            line = pose.positions[:, pair[0]] - pose.positions[:, pair[1]]
            across += line / np.maximum(np.linalg.norm(line, axis=-1, keepdims=True), 1e-12)
    return np.arctan2(-across[:, 2], across[:, 0])


def overall_heading(headings: Array, frame_time: float) -> tuple[float, bool]:
    """The heading to turn away: the mean where it is steady, else that of the first half second.

    Returns:
        The heading in rad, and whether it was steady.
    """
    steady = np.exp(1j * headings).mean()
    if abs(steady) > 0.9:
        return float(np.angle(steady)), True
    first = np.exp(1j * headings[: max(1, round(0.5 / frame_time))]).mean()
    return float(np.angle(first)), False
