"""Feet that stand again after an edit."""

import numpy as np
import pytest

from motion.editing.foot_plants import find_feet, runs
from motion.editing.foot_repair import repair_feet
from motion.editing.path_length import PathLength, change_path_length
from motion.kinematics import forward_kinematics
from tests.motion.editing.measures import bone_lengths, fastest_turn, strongest_hip_acceleration

pytestmark = pytest.mark.motions


@pytest.fixture(params=[0.4, 0.7, 1.3, 1.6])
def edited(request, going):
    return repair_feet(going, change_path_length(going, PathLength(request.param)))


def test_a_repaired_edit_is_sound(going, edited):
    feet, pose = find_feet(going), forward_kinematics(edited)
    for foot in feet:
        for point, planted in zip(foot.points, foot.planted, strict=True):
            places = point.positions(pose)
            assert places[:, 1].min() >= -0.01, "a sole goes through the floor"
            for plant in runs(planted):
                level = places[plant][:, [0, 2]]
                slip = np.linalg.norm(level - level[0], axis=1).max()
                assert slip <= 0.005, f"the {foot.side} foot slides {slip:.4f} m"
    assert strongest_hip_acceleration(edited) <= 2 * strongest_hip_acceleration(going)
    assert fastest_turn(edited) <= 2 * fastest_turn(going)
    np.testing.assert_allclose(bone_lengths(edited), bone_lengths(going), atol=1e-9)


def test_without_repair_the_feet_would_slide(going):
    """The check above can fail: the same measure on the same edit, unrepaired."""
    pose = forward_kinematics(change_path_length(going, PathLength(1.6)))
    slips = [0.0]
    for foot in find_feet(going):
        for point, planted in zip(foot.points, foot.planted, strict=True):
            places = point.positions(pose)[:, [0, 2]]
            slips += [np.linalg.norm(places[p] - places[p][0], axis=1).max() for p in runs(planted)]
    assert max(slips) > 0.005


def test_feet_stand_as_long_as_in_walking(motions_dir):
    """A walk stands on each foot for more than a third of the time and never flies for long."""
    from tests.motion.editing.conftest import read

    left, right = find_feet(read(motions_dir / "bandai-namco/walk_normal_001.bvh"))
    assert 0.35 < left.stands.mean() < 0.7
    assert 0.35 < right.stands.mean() < 0.7
    assert (left.stands | right.stands).mean() > 0.8
