"""Each style against the neutral walk, in the direction that studies of emotional gait report."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from motion.procedural.bodies import BODIES
from motion.procedural.library import AFFECTS, CHARACTERS
from motion.procedural.styles import NEUTRAL, for_body
from motion.procedural.walk import walk_cycle
from tests.support.gait import SIDES, Gait

MEASURES = {
    "cadence": lambda g: g.cadence,
    "stride": lambda g: g.stride,
    "step width": lambda g: g.step_width,
    "double support": lambda g: g.double_support,
    "bounce": lambda g: g.bounce,
    "sway": lambda g: g.sway,
    "lean": lambda g: g.lean,
    "head down": lambda g: float(g.head_pitch.mean()),
    "head bob": lambda g: float(np.ptp(g.head_pitch)),
    "arm swing": lambda g: g.arm_swing,
    "elbow": lambda g: float(np.mean([g.elbow(s).mean() for s in SIDES])),
    "elbow swing": lambda g: float(np.mean([np.ptp(g.elbow(s)) for s in SIDES])),
    "twist": lambda g: float(np.ptp(g.shoulder_yaw)),
    "pelvis yaw": lambda g: float(np.ptp(g.pelvis_yaw)),
    "mid-stance knee": lambda g: float(
        np.median(g.from_contact("left", g.knee("left"))[: g.clip.frames // 3])
    ),
    "push-off": lambda g: float(-g.foot_pitch("left").min()),
    "hand jerk": lambda g: g.hand_jerk(),
    "toe-out": lambda g: float(
        np.degrees(np.arcsin(-np.median((g.at("right_toes") - g.at("right_foot"))[:, 0]) / 0.11))
    ),
    "wrist out": lambda g: g.wrist_outside,
}

# + more than the neutral walk, − less, beyond what a walker varies from stride to stride.
DIRECTIONS = {
    "set_a_energetic": "+stride +step width +bounce +elbow +arm swing",
    "set_a_proud": "-cadence -head down -lean +twist +toe-out +arm swing",
    "set_a_sad": "-cadence -stride -arm swing -bounce +double support +head down +sway +lean",
    "set_a_angry": "+cadence +lean +head down +arm swing +elbow swing +hand jerk -double support",
    "set_a_old": "-stride +lean +mid-stance knee -push-off -arm swing +step width",
    "set_a_timid": "-stride -cadence +double support +elbow -arm swing +head down -push-off",
    "set_a_tired": "+head down +head bob +lean +mid-stance knee -arm swing +step width -cadence",
    "set_a_childlike": "-stride +step width +twist +elbow -push-off +head bob +arm swing",
    "set_a_swaggering": "+step width +toe-out +mid-stance knee +pelvis yaw +head down +sway",
    "set_b_excitement_normal": "+cadence +stride +bounce +arm swing +elbow -head down",
    "set_b_pleasure_normal": "+bounce +arm swing -head down +elbow swing",
    "set_b_contentment_normal": "-cadence -lean -head down",
    "set_b_sleepiness_normal": "-cadence -stride +sway +head down +head bob -push-off",
    "set_b_depression_normal": "-cadence -stride -arm swing -bounce +head down +lean",
    "set_b_misery_normal": "-cadence -stride +lean +head down -arm swing +elbow",
    "set_b_distress_normal": "+cadence -stride +elbow -arm swing",
    "set_b_arousal_normal": "+cadence +elbow +arm swing -head down",
}  # fmt: skip

# Standard deviation from stride to stride of one walker (in legs for the stride).
SPREAD = {
    "cadence": 2.5, "stride": 0.03, "step width": 0.9, "double support": 0.9, "bounce": 0.5,
    "sway": 0.25, "lean": 0.8, "head down": 1.3, "head bob": 1.0, "arm swing": 3.7, "elbow": 1.5,
    "elbow swing": 3.0, "twist": 1.6, "pelvis yaw": 1.6, "mid-stance knee": 1.7, "push-off": 2.4,
    "hand jerk": 5.9, "toe-out": 1.5, "wrist out": 0.4,
}  # fmt: skip

CASES = [
    (name, word[0], word[1:])
    for name, words in DIRECTIONS.items()
    for word in words.replace(" +", "|+").replace(" -", "|-").split("|")
]


@pytest.mark.parametrize(("name", "sign", "measure"), CASES)
def test_a_style_differs_from_neutral_in_the_reported_direction(
    gaits, neutral, name, sign, measure
):
    take = MEASURES[measure]
    difference = take(gaits[name]) - take(neutral)
    if sign == "-":
        difference = -difference
    assert difference > SPREAD[measure]


def test_the_swaggering_shoulders_go_with_the_pelvis(gaits):
    gait = gaits["set_a_swaggering"]
    assert np.corrcoef(gait.shoulder_yaw, gait.pelvis_yaw)[0, 1] > 0.5


@pytest.mark.parametrize("names", [
    [f"set_a_{name}" for name in CHARACTERS],
    [f"set_b_{name}_normal" for name in AFFECTS],
], ids=["A", "B"])  # fmt: skip
def test_any_two_styles_of_a_set_are_told_apart_by_several_measures(gaits, names):
    for first, second in itertools.combinations(names, 2):
        apart = [
            measure
            for measure, take in MEASURES.items()
            if abs(take(gaits[first]) - take(gaits[second])) > 3 * SPREAD[measure]
        ]
        assert len(apart) >= 3, f"{first} and {second} differ in {apart} only"


@pytest.mark.parametrize("affect", AFFECTS)
def test_fast_is_faster_than_normal_and_normal_than_slow_in_rate_and_reach(gaits, affect):
    slow, normal, fast = (gaits[f"set_b_{affect}_{s}"] for s in ("slow", "normal", "fast"))
    assert slow.cadence < normal.cadence < fast.cadence
    assert slow.stride < normal.stride < fast.stride
    assert slow.double_support > fast.double_support
    assert slow.speed < 0.85 * normal.speed
    assert fast.speed > 1.15 * normal.speed


def test_women_roll_and_turn_the_pelvis_turn_the_chest_and_swing_the_arms_more_than_men():
    # Bruening et al. 2015
    walks = {
        name: Gait(walk_cycle(for_body(NEUTRAL, BODIES[name]), BODIES[name]), BODIES[name])
        for name in ("female", "male")
    }
    for take in (
        lambda g: np.ptp(g.pelvis_roll),
        lambda g: np.ptp(g.pelvis_yaw),
        lambda g: np.ptp(g.shoulder_yaw),
        lambda g: g.arm_swing,
    ):
        assert take(walks["female"]) > 1.1 * take(walks["male"])


def test_the_bodies_differ_in_stature_and_proportions():
    female, male = BODIES["female"], BODIES["male"]
    assert female.stature < BODIES["adult"].stature < male.stature
    assert female.shoulder_half / female.hip_half < 0.85 * male.shoulder_half / male.hip_half
