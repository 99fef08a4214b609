"""Soft limits of joint angles."""

import numpy as np
import pytest

from motion import MotionError
from motion.editing.waveshaping import SoftLimit, shape
from motion.kinematics import forward_kinematics
from motion.rotations import angle_between
from motion.segment_angles import seen_from, twist
from motion.standing import standing_rotations
from tests.motion.editing.measures import bone_lengths


def elbow_bend(clip, standing):
    """Degrees, from world rotations; bent is positive."""
    roles = clip.skeleton.roles
    turn = seen_from(
        forward_kinematics(clip), standing, roles["right_forearm"], roles["right_upper_arm"]
    )
    return -np.degrees(twist(turn, 0))


def test_an_elbow_keeps_its_limit_and_the_order_of_its_angles(knocking):
    standing = standing_rotations(knocking)
    limit = SoftLimit("right_forearm", "x", low=-80.0, soft=20.0)
    before = elbow_bend(knocking, standing)
    after = elbow_bend(shape(knocking, [limit]), standing)
    assert before.max() > 100
    assert after.max() < 80.0
    within = before < 60.0
    assert 10 < within.sum() < len(before)
    np.testing.assert_allclose(after[within], before[within], atol=1e-6)
    order = np.argsort(before)
    assert np.diff(after[order]).min() > -1e-6


def test_other_joints_and_bones_stay(knocking):
    shaped = shape(knocking, [SoftLimit("right_forearm", "x", low=-80.0)])
    joint = knocking.skeleton.roles["right_forearm"]
    others = [j for j in range(len(knocking.skeleton)) if j != joint]
    np.testing.assert_array_equal(shaped.rotations[:, others], knocking.rotations[:, others])
    np.testing.assert_allclose(bone_lengths(shaped), bone_lengths(knocking), atol=1e-9)


def test_limits_that_are_not_reached_change_nothing(knocking):
    shaped = shape(knocking, [SoftLimit("right_forearm", "x")])
    np.testing.assert_allclose(angle_between(shaped.rotations, knocking.rotations), 0.0, atol=1e-7)


@pytest.mark.parametrize("amount", [0.0, 0.3, 1.0])
def test_the_amount_scales_the_change(knocking, amount):
    standing = standing_rotations(knocking)
    limit = SoftLimit("right_forearm", "x", low=-80.0)
    before, whole = (elbow_bend(c, standing) for c in (knocking, shape(knocking, [limit])))
    part = elbow_bend(shape(knocking, [limit], amount), standing)
    np.testing.assert_allclose(part, before + amount * (whole - before), atol=1e-6)


@pytest.mark.motions
def test_a_recording_keeps_a_limit_on_any_axis(walk):
    for axis in "xyz":
        limit = SoftLimit("head", axis, low=-10.0, high=5.0, soft=3.0)
        shaped = shape(walk, [limit])
        again = shape(shaped, [SoftLimit("head", axis, low=-10.0, high=5.0, soft=0.0)])
        np.testing.assert_allclose(angle_between(again.rotations, shaped.rotations), 0.0, atol=1e-6)


def test_impossible_limits_and_missing_joints_are_refused(knocking):
    with pytest.raises(MotionError, match="room"):
        SoftLimit("head", "x", low=-10.0, high=10.0, soft=15.0)
    with pytest.raises(MotionError, match="axis"):
        SoftLimit("head", "forward")
    with pytest.raises(MotionError, match="left wing"):
        shape(knocking, [SoftLimit("left_wing", "x")])
