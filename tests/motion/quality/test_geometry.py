"""Distances that a pencil and paper give as well."""

import numpy as np
import pytest

from motion import Clip, Skeleton
from motion.kinematics import forward_kinematics
from motion.quality.feet import distance_outside
from motion.quality.jerk import jerk
from motion.quality.limbs import Capsule, depth
from motion.quality.pair import Pair
from motion.rotations import from_axis_angle, multiply
from motion.segment_angles import X, Y, Z, twist


def capsule(start, end, radius):
    return Capsule(np.array([start], dtype=float), np.array([end], dtype=float), radius)


@pytest.mark.parametrize(
    ("other", "expected"),
    [
        (((0, 1, 0.3), (0, 0, 0.3)), 0.1),  # beside each other
        (((-1, 0.5, 0.3), (1, 0.5, 0.3)), 0.1),  # crossing
        (((-1, 0.5, 0), (1, 0.5, 0)), 0.4),  # right through
        (((0, 1.3, 0), (0, 2, 0)), 0.1),  # one after the other
        (((0.3, 1.4, 0), (1, 2, 0)), -0.1),  # apart: 3-4-5
        (((0.3, 0.5, 0), (0.3, 0.5, 0)), 0.1),  # a ball
    ],
)
def test_how_deep_two_capsules_are_in_each_other(other, expected):
    upright = capsule((0, 0, 0), (0, 1, 0), 0.2)
    assert depth(upright, capsule(*other, 0.2))[0] == pytest.approx(expected)
    assert depth(capsule(*other, 0.2), upright)[0] == pytest.approx(expected)


@pytest.mark.parametrize(
    ("place", "expected"),
    [((0.5, 0.5), 0), ((0.9, 0.1), 0), ((2, 0.5), 1), ((0.5, -0.25), 0.25), ((4, 5), 5)],
)
def test_how_far_a_place_is_from_a_square(place, expected):
    square = np.array([[[0, 0], [0, 1], [1, 0], [1, 1]]], dtype=float)
    assert distance_outside(square, np.array([place], dtype=float))[0] == pytest.approx(expected)


@pytest.mark.parametrize("axis", [X, Y, Z])
@pytest.mark.parametrize("angle", [-2.5, -0.3, 0.0, 1.0, 3.0])
def test_a_twist_is_what_is_left_of_a_turn_without_its_swing(axis, angle):
    turn = from_axis_angle(np.eye(3)[axis], np.asarray(angle))
    across = from_axis_angle(np.eye(3)[(axis + 1) % 3], np.asarray(0.7))
    for sign in (1.0, -1.0):  # a rotation has two quaternions
        assert twist(sign * multiply(across, turn), axis) == pytest.approx(angle)


def test_the_jerk_of_a_swing_is_that_of_its_sine():
    """A·ω³/√2, less what the smoothing (a Gaussian of 0.02 s) takes from a wave of that period."""
    names, parents = ("hips", "head"), np.array([-1, 0])
    skeleton = Skeleton(
        names, parents, np.array([[0, 1, 0], [0, 0.5, 0]], float), roles={"hips": 0, "head": 1}
    )
    step, omega, angle = 1 / 120, 2 * np.pi * 3.0, 0.02
    times = np.arange(600) * step
    rotations = np.zeros((600, 2, 4))
    rotations[:, 1, 0] = 1.0
    rotations[:, 0] = from_axis_angle(np.array([1.0, 0, 0]), angle * np.sin(omega * times))
    clip = Clip(skeleton, np.zeros((600, 3)), rotations, step)
    found = jerk(Pair(clip, clip), forward_kinematics(clip), "head")
    smoothing = np.exp(-((omega * 0.02) ** 2) / 2)
    expected = 0.5 * angle * omega**3 / np.sqrt(2) * smoothing
    assert np.sqrt(np.mean(found[100:500] ** 2)) == pytest.approx(expected, rel=0.02)
