"""The standing poses that posture edits are made of, as angles on an upright body.

Förger captured his from actors (figure 21); these are made by code, nearly symmetrical and in
balance, as the thesis asks. Angles are round values of our own.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from motion.rotations import from_axis_angle, multiply

Array = NDArray[np.float64]

_X, _Y, _Z = np.eye(3)
_SIDES = (("left", 1.0), ("right", -1.0))

# Degrees. Head and trunk: forward is positive. Limbs: out is away from the midline, elbow bends
# the forearm forward, turn rotates the upper arm so that the elbow points outwards.
STANCES: Mapping[str, Mapping[str, float]] = {
    "neutral": {},
    "head_down": {"neck": 16, "head": 20, "chest": 5},
    "head_a_little_down": {"neck": 8, "head": 10, "chest": 2},
    "elbows_away": {"arm_out": 20, "elbow": 14, "arm_turn": 22, "shoulder_up": 2},
    "hands_and_feet_closer": {"arm_out": -5, "elbow": 12, "arm_turn": -16, "leg_out": -2.5},
    "hands_away_and_feet_apart": {"arm_out": 13, "leg_out": 4, "shoulder_up": 1},
}


def stance(name: str) -> dict[str, Array]:
    """Body role to local rotation (4,) in canonical axes (``motion.standing``).

    Raises:
        KeyError: if there is no stance of that name.
    """
    angles = {key: np.radians(value) for key, value in STANCES[name].items()}
    pose = {role: _turn(_X, angles.get(role, 0.0)) for role in ("spine", "chest", "neck", "head")}
    for side, sign in _SIDES:
        out = _turn(_Z, sign * angles.get("arm_out", 0.0))
        turn = _turn(_Y, -sign * angles.get("arm_turn", 0.0))
        leg = sign * angles.get("leg_out", 0.0)
        pose |= {
            f"{side}_clavicle": _turn(_Z, sign * angles.get("shoulder_up", 0.0)),
            f"{side}_upper_arm": multiply(out, turn),
            f"{side}_forearm": _turn(_X, -angles.get("elbow", 0.0)),
            f"{side}_thigh": _turn(_Z, leg),
            f"{side}_foot": _turn(_Z, -leg),
        }
    return pose


def _turn(axis: Array, angle: float) -> Array:
    return from_axis_angle(axis, np.asarray(angle))
