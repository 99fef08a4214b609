"""The neutral sample walk against published ranges of adults walking at ease."""

from __future__ import annotations

import numpy as np
import pytest

from tests.support.gait import SIDES

# Öberg 1993; Perry & Burnfield 2010; Winter 1991; Orendurff 2004; Schwartz 2008; Crosbie 1997;
# Murray 1967; Schulz 2011. Steps a minute, legs, cm, % of the cycle, degrees.
PUBLISHED = {
    "cadence": (100, 126),
    "speed": (1.1, 1.5),
    "stride": (1.4, 1.7),
    "step_width": (7, 13),
    "stance_share": (59, 63),
    "double_support": (18, 26),
    "bounce": (2.5, 5),
    "sway": (3.5, 7),
    "arm_swing": (22, 45),
    "toe_clearance": (0.6, 2.6),
    "lean": (2, 6),
    "wrist_outside": (9, 21),
}
RANGES = {"pelvis_yaw": (7, 13), "pelvis_roll": (6, 11), "shoulder_yaw": (5, 12)}


def inside(value, limits):
    return limits[0] <= value <= limits[1]


@pytest.mark.parametrize("measure", PUBLISHED)
def test_steps_and_hips_are_those_of_people(neutral, measure):
    assert inside(getattr(neutral, measure), PUBLISHED[measure]), getattr(neutral, measure)


@pytest.mark.parametrize("measure", RANGES)
def test_pelvis_and_shoulders_turn_as_far_as_peoples(neutral, measure):
    assert inside(np.ptp(getattr(neutral, measure)), RANGES[measure])


def test_step_length_and_cadence_keep_the_walk_ratio(neutral):
    step = neutral.clip.travel[2] / 2
    assert inside(step / neutral.cadence, (0.0055, 0.007))


@pytest.mark.parametrize("side", SIDES)
def test_the_knee_bends_as_published_at_contact_loading_mid_stance_and_swing(neutral, side):
    knee = neutral.from_contact(side, neutral.knee(side))
    phase = np.linspace(0, 100, len(knee), endpoint=False)
    loading = np.where((phase > 3) & (phase < 30), knee, 0)
    assert inside(knee[0], (0, 12))
    assert inside(loading.max(), (12, 26))
    assert inside(phase[loading.argmax()], (10, 24))
    assert inside(knee[(phase > 20) & (phase < 55)].min(), (0, 13))
    assert inside(knee.max(), (53, 68))
    assert inside(phase[knee.argmax()], (68, 78))


@pytest.mark.parametrize("side", SIDES)
def test_the_foot_strikes_with_the_heel_lies_flat_and_pushes_off(neutral, side):
    pitch = neutral.from_contact(side, neutral.foot_pitch(side))
    phase = np.linspace(0, 100, len(pitch), endpoint=False)
    assert inside(pitch[0], (12, 27))
    assert np.abs(pitch[(phase > 14) & (phase < 30)]).max() < 0.5
    assert inside(pitch.min(), (-85, -62))
    assert inside(phase[pitch.argmin()], (58, 70))


@pytest.mark.parametrize("side", SIDES)
def test_the_thigh_swings_as_far_as_published(neutral, side):
    assert inside(np.ptp(neutral.thigh(side)), (37, 48))


@pytest.mark.parametrize("side", SIDES)
def test_arms_swing_against_the_legs(neutral, side):
    arm = neutral.from_contact(side, neutral.arm(side))
    thigh = neutral.from_contact(side, neutral.thigh(side))
    assert np.corrcoef(arm, thigh)[0, 1] < -0.8
    # Foremost when the other foot is set down.
    assert inside(100 * arm.argmax() / len(arm), (40, 58))
    assert inside(neutral.elbow(side).mean(), (15, 35))


def test_shoulders_turn_against_the_pelvis(neutral):
    assert np.corrcoef(neutral.shoulder_yaw, neutral.pelvis_yaw)[0, 1] < -0.5


def test_hips_are_lowest_in_double_support_and_highest_in_single_support(neutral):
    height = neutral.from_contact("left", neutral.hips[:, 1])
    phase = 100 * np.arange(len(height)) / len(height)
    assert inside(phase[np.where(phase < 45, height, np.inf).argmin()], (0, 12))
    assert inside(phase[np.where(phase < 50, height, 0).argmax()], (24, 38))


def test_the_hips_are_over_the_standing_leg(neutral):
    aside = neutral.from_contact("left", neutral.hips[:, 0])
    assert inside(100 * aside.argmax() / len(aside), (18, 42))  # left is +x


def test_the_head_stays_level_and_ahead_while_the_trunk_turns(neutral):
    assert np.ptp(neutral.head_pitch) < 4
    gaze = neutral.yaw("left_upper_arm", "right_upper_arm")
    head = np.degrees(2 * np.arctan2(neutral.turn("head")[:, 2], neutral.turn("head")[:, 0]))
    assert np.ptp(head) < 0.4 * np.ptp(gaze)


def test_left_and_right_differ_a_little_but_not_much(neutral):
    swing = [np.ptp(neutral.arm(side)) for side in SIDES]
    assert 0.01 < abs(swing[0] / swing[1] - 1) < 0.3


def test_toes_bend_while_the_heel_rises_and_lie_flat_under_the_flat_foot(neutral):
    for side in SIDES:
        bend = neutral.bend(f"{side}_foot", f"{side}_toes", f"{side}_toes")
        del bend  # the toes have no joint beyond; their pitch is measured by their tip instead
        toes = neutral.tips[f"{side}_toes"] - neutral.at(f"{side}_toes")
        pitch = np.degrees(np.arctan2(toes[:, 1], np.hypot(toes[:, 0], toes[:, 2])))
        pitch = neutral.from_contact(side, pitch - np.median(pitch))
        foot = neutral.from_contact(side, neutral.foot_pitch(side))
        phase = 100 * np.arange(len(foot)) / len(foot)
        at = np.abs(phase - 52).argmin()
        assert foot[at] < -12
        assert abs(pitch[at]) < 3
