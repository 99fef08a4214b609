"""What is seen of a walk, by name: for the page on the sliders."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion import Clip
from motion.features import FEATURES, features
from motion.features.gait_measures import gait_measures
from motion.keytimes import find_keytimes

Array = NDArray[np.float64]

_FEATURES = {feature.id: index for index, feature in enumerate(FEATURES)}


@dataclass(frozen=True)
class Measure:
    """What is measured of a walk: its unit, and how many digits of it are told."""

    unit: str
    digits: int


MEASURES: Mapping[str, Measure] = {
    "arm span": Measure("m", 2),
    "widest arm span": Measure("m", 2),
    "step length": Measure("m", 3),
    "cadence": Measure("steps/min", 0),
    "hand speed": Measure("m/s", 2),
    "walking speed": Measure("m/s", 2),
    "double support": Measure("%", 1),
    "bounce": Measure("mm", 1),
    "sway": Measure("mm", 1),
    "trunk bent forward": Measure("°", 1),
    "head bowed": Measure("°", 1),
}


def measure(clip: Clip) -> Array:
    """The values of ``MEASURES`` of a walk, in their order."""
    gait, found = gait_measures(clip), features(clip)
    by_name = {
        "arm span": gait.arm_span,
        "widest arm span": gait.widest_arm_span,
        "step length": gait.step_length,
        "cadence": gait.cadence,
        "hand speed": gait.hand_speed,
        "walking speed": found[_FEATURES["com_velocity_front_back_mean"]],
        "double support": 100.0 * _double_support(clip),
        "bounce": 1000.0 * found[_FEATURES["com_position_vertical_spread"]],
        "sway": 1000.0 * found[_FEATURES["com_left_right_spread"]],
        "trunk bent forward": found[_FEATURES["torso_front_back_mean"]],
        "head bowed": found[_FEATURES["head_front_back_mean"]],
    }
    return np.array([by_name[name] for name in MEASURES])


def _double_support(clip: Clip) -> float:
    """Share of a cycle in which both feet stand."""
    at = find_keytimes(clip)
    left = (at["right_off"] - at["left_strike"]) % clip.duration
    right = (at["left_off"] - at["right_strike"]) % clip.duration
    return (left + right) / clip.duration
