"""How far a created motion is from its target."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from motion import Clip, MotionError
from motion.blending import matching_distance
from motion.editing.tempo import change_tempo
from motion.rotations import from_axis_angle, multiply, rotate
from tests.motion.blending.conftest import mixtures

UP = np.array([0.0, 1.0, 0.0])


def moved(clip: Clip, angle: float, shift: np.ndarray) -> Clip:
    turn = from_axis_angle(UP, angle)
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    root = rotate(turn, clip.root_positions) + shift
    return replace(clip, root_positions=root, rotations=rotations)


def with_head(clip: Clip, shift: float) -> Clip:
    """The clip with its head joint so much farther from the neck."""
    head = clip.skeleton.roles["head"]
    offsets = clip.skeleton.offsets.copy()
    offsets[head] *= 1.0 + shift / np.linalg.norm(offsets[head])
    return replace(clip, skeleton=replace(clip.skeleton, offsets=offsets))


def test_a_motion_is_no_way_from_itself(walks_a):
    assert matching_distance(walks_a[2], walks_a[2]) == 0.0


def test_it_is_the_same_both_ways_and_above_zero(walks_a):
    there, back = matching_distance(*walks_a[:2]), matching_distance(*walks_a[1::-1])
    assert there == back > 0.01


@pytest.mark.parametrize("angle", [0.0, 1.0, 3.0])
def test_where_a_motion_starts_and_heads_does_not_count(walks_a, angle):
    away = moved(walks_a[1], angle, np.array([3.0, 0.0, -7.0]))
    assert matching_distance(away, walks_a[1]) == pytest.approx(0.0, abs=1e-9)
    plain = matching_distance(*walks_a[:2])
    assert matching_distance(walks_a[0], away) == pytest.approx(plain, abs=1e-9)


def test_a_body_carried_higher_is_that_much_away(walks_a):
    assert matching_distance(
        moved(walks_a[0], 0.0, np.array([0.0, 0.1, 0.0])), walks_a[0]
    ) == pytest.approx(0.1, abs=1e-12)


def test_one_joint_of_twenty_counts_a_twentieth(walks_a):
    longer = with_head(walks_a[0], 0.2)
    assert matching_distance(longer, walks_a[0]) == pytest.approx(0.2 / 20, abs=1e-6)


def test_tempo_and_stride_alone_do_not_count(walks_a):
    slower = change_tempo(walks_a[0], 0.5)
    assert matching_distance(slower, walks_a[0]) < 0.002
    way = np.linspace(0.0, 0.4, walks_a[0].frames)[:, None] * [0.0, 0.0, 1.0]
    farther = replace(walks_a[0], root_positions=walks_a[0].root_positions + way)
    assert matching_distance(farther, walks_a[0]) == pytest.approx(0.0, abs=1e-9)


def test_the_nearer_the_weights_the_nearer_the_motion(blender_b, walks_b):
    start, end = (blender_b.blend(weights) for weights in mixtures(3, len(walks_b), seed=8)[1:])
    one, two = mixtures(3, len(walks_b), seed=8)[1:]
    distances = [
        matching_distance(start, blender_b.blend((1 - share) * one + share * two))
        for share in (0.0, 0.25, 0.5, 1.0)
    ]
    assert distances == sorted(distances)
    assert distances[0] == 0.0
    assert distances[-1] == matching_distance(start, end)


def test_a_body_without_hips_is_refused(walks_a):
    roles = {role: j for role, j in walks_a[0].skeleton.roles.items() if role != "hips"}
    hipless = replace(walks_a[0], skeleton=walks_a[0].skeleton.with_roles(roles))
    with pytest.raises(MotionError, match="hips"):
        matching_distance(walks_a[0], hipless)
