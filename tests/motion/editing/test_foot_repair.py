"""Feet that stand again after an edit."""

from dataclasses import replace

import numpy as np
import pytest

from motion.editing.foot_plants import find_feet, runs
from motion.editing.foot_repair import repair_feet
from motion.editing.path_length import PathLength, change_path_length
from motion.editing.tempo import resample_rate
from motion.kinematics import forward_kinematics
from motion.rotations import angle_between
from tests.motion.editing.measures import bone_lengths, fastest_turn, strongest_hip_acceleration

pytestmark = pytest.mark.motions


@pytest.fixture(params=[0.4, 0.7, 1.0, 1.3, 1.6])
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


def test_what_nobody_edited_goes_where_it_went(going):
    """Repair takes out what an edit put in, and little else."""
    repaired = repair_feet(going, going)
    assert np.abs(repaired.root_positions - going.root_positions).max() < 0.03


def test_longer_and_shorter_paths_go_farther_and_less_far(walk):
    way = [
        np.linalg.norm(repair_feet(walk, change_path_length(walk, PathLength(gain))).travel)
        for gain in (0.5, 1.0, 1.5)
    ]
    assert way[0] < way[1] < way[2]


def test_a_cycle_stays_a_cycle(samples):
    for name in ("set_a_proud", "set_b_excitement_fast", "set_a_old"):
        clip = samples[name]
        repaired = repair_feet(clip, change_path_length(clip, PathLength(1.6)))
        assert repaired.cyclic
        np.testing.assert_array_equal(repaired.rotations[0], repaired.rotations[-1])
        across = np.degrees(angle_between(repaired.rotations[1], repaired.rotations[-2])).max()
        inside = np.degrees(angle_between(repaired.rotations[2:], repaired.rotations[:-2])).max()
        assert across <= inside
        assert repaired.travel[2] > 1.1 * clip.travel[2]
        assert repaired.travel[1] == 0.0


def test_a_foot_at_rest_stands_on_heel_and_ball(samples):
    """Not on either by the chance of rounding: its plant is one piece on both."""
    clip = samples["acted_female_neutral"]
    still = slice(clip.frames - 60, clip.frames)
    for foot in find_feet(clip):
        assert foot.planted[:, still].all()


def test_a_recording_s_jitter_does_not_lift_a_foot(motions_dir):
    from tests.motion.editing.conftest import read

    walk = read(motions_dir / "bandai-namco/walk_normal_001.bvh")
    fine = resample_rate(walk, 120.0)
    jitter = np.random.default_rng(3).normal(scale=1e-4, size=fine.root_positions.shape)
    shaken = replace(fine, root_positions=fine.root_positions + jitter)
    for calm, foot in zip(find_feet(fine), find_feet(shaken), strict=True):
        assert len(list(foot.plants())) == len(list(calm.plants()))
