"""Arm span, step length, cadence and the hands' speed."""

from dataclasses import replace

import numpy as np
import pytest

from motion import MotionError
from motion.features.gait_measures import gait_measures
from motion.procedural.bodies import BODIES
from motion.rotations import multiply
from tests.motion.features.robots import BODY, X, Z, hanging, moved, robot, times, turn, walker
from tests.support.gait import Gait

ARM = (0.163 + 0.143) * BODY.stature  # shoulder to wrist


def test_arms_that_are_spread_and_lowered_give_their_span():
    t = times(60, 1.0)
    hangs, spread = gait_measures(robot(t)), robot(t, {"left_upper_arm": turn(Z, 0 * t)})
    shoulders = 2 * BODY.shoulder_half
    assert [hangs.arm_span, hangs.widest_arm_span] == pytest.approx([shoulders, shoulders])
    one_side = np.hypot(shoulders + ARM, ARM)
    assert gait_measures(spread).arm_span == pytest.approx(one_side)


def test_the_widest_span_is_that_of_one_moment():
    t = times(60, 2.0)
    raised = 90.0 * np.sin(np.pi * t / 2) ** 2
    found = gait_measures(robot(t, {"left_upper_arm": turn(Z, raised - 90.0)}))
    assert found.widest_arm_span == pytest.approx(np.hypot(2 * BODY.shoulder_half + ARM, ARM))
    assert found.arm_span < 0.8 * found.widest_arm_span


@pytest.mark.parametrize("rate", [30, 120])
def test_a_swinging_hand_has_the_mean_speed_of_its_arc(rate):
    """Two arcs of 2 × swing each second, along a circle of the arm's length."""
    t = times(rate, 1.0)
    angle = 20.0 * np.sin(2 * np.pi * t)
    clip = robot(t, {"left_upper_arm": multiply(turn(X, -angle), hanging("left"))})
    arcs = 2 * 2 * np.radians(20.0) * ARM
    assert gait_measures(clip).hand_speed == pytest.approx(arcs / 2, rel=5e-3)  # of two hands


@pytest.mark.parametrize("rate", [30, 60, 120])
def test_a_walk_of_known_steps_gives_them_and_their_cadence(rate):
    found = gait_measures(walker(rate, left=0.5, right=0.62))
    assert found.step_length == pytest.approx(0.56, abs=1e-6)
    assert found.cadence == pytest.approx(100.0)


def test_the_sample_walks_have_the_cadence_that_they_were_made_with(cycles):
    for clip in cycles.values():
        assert gait_measures(clip).cadence == pytest.approx(Gait(clip, BODIES["adult"]).cadence)


def test_cadence_is_the_same_without_a_cycle(cycles):
    for clip in (walker(), cycles["set_a_neutral"]):
        last = clip.frames - 1
        index = np.arange(5 * last + 1)
        root = clip.root_positions[index % last] + (index // last)[:, None] * clip.travel
        rotations = clip.rotations[index % last]
        row = replace(clip, root_positions=root, rotations=rotations, cyclic=False)
        assert gait_measures(row).cadence == pytest.approx(gait_measures(clip).cadence, rel=0.01)


def test_walking_ahead_is_no_motion_of_the_hands():
    t = times(60, 1.0)
    ahead = np.stack([0 * t, 0 * t, 3.0 * t], axis=1)
    assert gait_measures(robot(t, root=ahead)).hand_speed == pytest.approx(0.0, abs=1e-9)


def test_who_stands_still_has_no_steps_and_no_cadence():
    found = gait_measures(robot(times(60, 1.0), cyclic=False))
    assert (found.step_length, found.cadence) == (0.0, 0.0)
    assert found.hand_speed == pytest.approx(0.0, abs=1e-9)


def test_heading_and_start_position_do_not_matter(cycles):
    clip = cycles["set_b_excitement_fast"]
    one, other = gait_measures(clip), gait_measures(moved(clip, 130.0, to=(2.0, 0.0, 5.0)))
    assert vars(one) == pytest.approx(vars(other))


def test_a_clip_without_frames_is_refused():
    clip = robot(times(60, 1.0))
    empty = replace(clip, root_positions=clip.root_positions[:0], rotations=clip.rotations[:0])
    with pytest.raises(MotionError, match="without frames"):
        gait_measures(empty)
