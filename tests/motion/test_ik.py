"""Two-bone inverse kinematics: laws that hold for every limb and target."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from motion.errors import MotionError
from motion.ik import frame_along, soft_limit, solve_two_bones
from motion.rotations import from_axis_angle, rotate

FORWARD = np.array([0.0, 0.0, 1.0])
THIGH, SHIN = 0.42, 0.40

bones = st.floats(0.1, 0.6)
coordinates = st.floats(-1.5, 1.5)
points = st.tuples(coordinates, coordinates, coordinates).map(np.array)


def leg_to(*targets, soft=0.0, pole=FORWARD):
    targets = np.array(targets, dtype=float)
    return solve_two_bones(np.zeros_like(targets), targets, pole, (THIGH, SHIN), soft=soft)


@given(points, points, points, bones, bones, st.floats(0.0, 0.3))
def test_bones_keep_their_lengths_wherever_the_target_is(start, target, pole, upper, lower, soft):
    limb = solve_two_bones(start[None], target[None], pole, (upper, lower), soft=soft)
    assert np.linalg.norm(limb.middle - start) == pytest.approx(upper, abs=1e-6)
    assert np.linalg.norm(limb.end - limb.middle) == pytest.approx(lower, abs=1e-6)


@given(points, points, bones, bones)
def test_the_end_reaches_every_target_within_reach(start, direction, upper, lower):
    length = np.linalg.norm(direction)
    assume(length > 1e-3)
    target = start + direction / length * max(upper, lower)  # between |a − b| and a + b
    limb = solve_two_bones(start[None], target[None], FORWARD, (upper, lower))
    np.testing.assert_allclose(limb.end[0], target, atol=1e-9)


def test_the_bend_follows_from_the_law_of_cosines():
    # A right angle at the knee: Pythagoras gives the distance.
    limb = leg_to([0.0, -np.hypot(THIGH, SHIN), 0.0])
    assert np.degrees(limb.bend[0]) == pytest.approx(90.0, abs=1e-9)


def test_the_knee_points_along_the_pole_and_the_hinge_across():
    limb = leg_to([0.0, -0.7, 0.0])
    assert limb.middle[0, 2] > 0.1
    assert limb.middle[0, 0] == pytest.approx(0.0, abs=1e-12)
    np.testing.assert_allclose(limb.hinge[0], [1.0, 0.0, 0.0], atol=1e-12)


def test_turning_the_first_bone_about_the_hinge_by_the_bend_gives_the_second():
    limb = leg_to([0.2, -0.6, 0.3])
    turn = from_axis_angle(limb.hinge, limb.bend)
    np.testing.assert_allclose(
        rotate(turn, limb.middle) / THIGH, (limb.end - limb.middle) / SHIN, atol=1e-9
    )


def test_turning_the_pole_turns_the_knee_about_the_limb():
    poles = np.array([[np.sin(a), 0.0, np.cos(a)] for a in np.linspace(0.0, 2 * np.pi, 9)])
    targets = np.tile([0.0, -0.6, 0.0], (9, 1))
    limb = solve_two_bones(np.zeros((9, 3)), targets, poles, (THIGH, SHIN))
    aside = limb.middle * [1.0, 0.0, 1.0]
    np.testing.assert_allclose(aside / np.linalg.norm(aside, axis=1)[:, None], poles, atol=1e-9)


def test_a_target_out_of_reach_is_pointed_at_with_a_straight_limb():
    limb = leg_to([0.6, -1.0, 0.2])
    assert np.degrees(limb.bend[0]) < 0.1
    ray = np.array([0.6, -1.0, 0.2])
    assert np.dot(limb.end[0], ray) == pytest.approx(0.82 * np.linalg.norm(ray), rel=1e-6)


def test_a_soft_limb_never_stretches_fully_and_never_snaps():
    distance = np.linspace(0.6, 1.2, 2001)
    targets = np.stack([0 * distance, -distance, 0 * distance], axis=-1)
    hard, soft = (leg_to(*targets, soft=softness) for softness in (0.0, 0.05))
    assert soft.bend.min() > 0.0
    assert soft.bend[-1] < soft.bend[0]
    # The steepest turn of the knee: unbounded for a hard limb, tame for a soft one.
    assert np.abs(np.diff(soft.bend)).max() < 0.2 * np.abs(np.diff(hard.bend)).max()


def test_softness_leaves_targets_alone_that_are_well_in_reach():
    distances = np.array([0.1, 0.5, 0.94])
    np.testing.assert_array_equal(soft_limit(distances, 1.0, 0.05), distances)
    close = soft_limit(np.array([0.95 - 1e-6, 0.95 + 1e-6]), 1.0, 0.05)
    assert np.diff(close)[0] == pytest.approx(2e-6, rel=1e-3)  # no corner at the seam


def test_targets_without_a_direction_still_give_a_pose():
    limb = leg_to([0.0, 0.0, 0.0], [0.0, 0.0, 0.7])  # at the hip; along the pole
    assert np.isfinite(limb.middle).all()
    assert np.isfinite(limb.end).all()
    np.testing.assert_allclose(limb.end[1], [0.0, 0.0, 0.7], atol=1e-9)


@pytest.mark.parametrize(
    ("lengths", "soft"), [((0.0, 0.4), 0.0), ((0.4, -0.1), 0.0), ((0.4, 0.4), 0.6)]
)
def test_an_impossible_limb_is_refused(lengths, soft):
    with pytest.raises(MotionError, match="no limb"):
        solve_two_bones(np.zeros((1, 3)), np.ones((1, 3)), FORWARD, lengths, soft=soft)


def test_a_bones_frame_turns_its_rest_direction_and_its_hinge_into_place():
    down = np.array([0.0, -1.0, 0.0])
    limb = leg_to([0.1, -0.7, 0.2], [0.0, -0.5, -0.3])
    frames = frame_along(limb.middle, limb.hinge, down)
    np.testing.assert_allclose(rotate(frames, down) * THIGH, limb.middle, atol=1e-9)
    np.testing.assert_allclose(rotate(frames, np.eye(3)[0]), limb.hinge, atol=1e-9)
