"""What must hold in each clip of the sample library."""

from __future__ import annotations

import numpy as np
import pytest

from motion.procedural.library import sample_clips
from motion.procedural.styles import ACTED, AFFECTS, CHARACTERS, SPEEDS
from motion.rotations import angle_between, conjugate, multiply, rotate
from tests.support.gait import SIDES

LOOPS = [f"set_a_{name}" for name in CHARACTERS]
LOOPS += [f"set_b_{name}_{speed}" for name in AFFECTS for speed in SPEEDS]
SCENES = [f"acted_{body}_{name}" for body in ("female", "male") for name in ACTED]
SCENES += ["bow"]
STEERED = ["stand", "walk", "turn_left", "turn_right"]
ALL = LOOPS + SCENES + STEERED


def test_the_sets_have_their_names_counts_and_tags(library):
    assert sorted(library) == sorted(ALL)
    sets = [sample.tags["set"] for sample in library.values()]
    counts = {"A": 10, "B": 27, "acted": 20, "gesture": 1, "graph": 4}
    assert {name: sets.count(name) for name in sets} == counts
    assert set(AFFECTS) == {
        "excitement", "pleasure", "contentment", "sleepiness", "depression", "misery", "distress",
        "arousal", "neutral",
    }  # fmt: skip
    assert set(ACTED) == {
        "afraid", "angry", "excited", "happy", "neutral", "relaxed", "sad", "strong", "tired",
        "weak",
    }  # fmt: skip
    assert {sample.tags["synthetic"] for sample in library.values()} == {"yes"}
    assert library["set_b_misery_slow"].tags["speed"] == "slow"
    assert library["acted_male_weak"].tags["body"] == "male"


def test_a_second_generation_gives_the_same_clips_and_no_two_are_equal(library):
    again = {sample.name: sample.clip.content_hash for sample in sample_clips()}
    assert again == {name: sample.clip.content_hash for name, sample in library.items()}
    assert len(set(again.values())) == 62


@pytest.mark.parametrize("name", ALL)
def test_planted_feet_do_not_slip(gaits, name):
    gait, planted = gaits[name], 0
    for side in SIDES:
        sole, speed = gait.sole(side), np.linalg.norm(gait.velocity(gait.sole(side)), axis=-1)
        for point in range(3):
            down = np.flatnonzero((sole[point, :, 1] < 0.003) & (speed[point] < 0.2))
            planted += len(down)
            for run in np.split(down, np.flatnonzero(np.diff(down) > 1) + 1):
                way = sole[point, run][:, [0, 2]]
                assert len(run) == 0 or np.linalg.norm(np.ptp(way, axis=0)) < 0.005
    assert planted > gait.clip.frames  # two feet stand more than half the time: it was measured


@pytest.mark.parametrize("name", ALL)
def test_soles_touch_the_floor_in_stance_and_never_go_below(gaits, name):
    for side in SIDES:
        lowest = gaits[name].sole(side)[..., 1].min(axis=0)
        assert lowest.min() > -0.002
        assert lowest[gaits[name].stance(side)].max() < 0.02
        assert np.median(lowest[gaits[name].stance(side)]) < 0.001


@pytest.mark.parametrize("name", ALL)
def test_knees_and_elbows_bend_the_right_way_only(gaits, name):
    gait = gaits[name]
    for side in SIDES:
        across = rotate(gait.turn(f"{side}_thigh"), np.array([1.0, 0.0, 0.0]))
        thigh = gait.at(f"{side}_shin") - gait.at(f"{side}_thigh")
        shin = gait.at(f"{side}_foot") - gait.at(f"{side}_shin")
        backward = np.sum(np.cross(thigh, shin) * across, axis=-1)
        assert backward.min() > 0.0
        assert gait.knee(side).min() > 3.0
        assert gait.knee(side).max() < 90.0
        assert gait.elbow(side).min() > 1.0
        assert gait.elbow(side).max() < 150.0


@pytest.mark.parametrize("name", ALL)
def test_knees_point_ahead_of_the_hips(gaits, name):
    for side in SIDES:
        thigh = multiply(conjugate(gaits[name].turn("hips")), gaits[name].turn(f"{side}_thigh"))
        across = rotate(thigh, np.array([1.0, 0.0, 0.0]))
        turned = np.degrees(np.arctan2(-across[:, 2], across[:, 0]))
        assert np.abs(turned).max() < 30.0


@pytest.mark.parametrize("name", ALL)
def test_bones_keep_their_lengths(gaits, name):
    gait = gaits[name]
    skeleton = gait.clip.skeleton
    np.testing.assert_allclose(np.linalg.norm(gait.clip.rotations, axis=-1), 1.0, atol=1e-12)
    for joint in range(1, len(skeleton)):
        bone = gait.world.positions[:, joint] - gait.world.positions[:, skeleton.parents[joint]]
        expected = np.linalg.norm(skeleton.offsets[joint])
        np.testing.assert_allclose(np.linalg.norm(bone, axis=-1), expected, atol=1e-9)


@pytest.mark.parametrize("name", ALL)
def test_joints_turn_no_faster_and_no_more_abruptly_than_bodies_can(gaits, name):
    clip = gaits[name].clip
    speed = angle_between(clip.rotations[1:], clip.rotations[:-1]) / clip.frame_time
    assert speed.max() < 20.0  # rad/s; a sprinter's knee reaches about that
    change = np.abs(np.diff(speed, axis=0)) / clip.frame_time
    assert change.max() < 900.0  # rad/s²; one frame's jump by 15 degrees


@pytest.mark.parametrize("name", LOOPS)
def test_a_loop_closes_and_its_seam_is_no_rougher_than_its_inside(library, name):
    clip = library[name].clip
    assert clip.cyclic
    np.testing.assert_array_equal(clip.rotations[0], clip.rotations[-1])
    assert clip.travel[[0, 1]] == pytest.approx([0.0, 0.0], abs=1e-12)
    frames = clip.frames - 1
    step = multiply(conjugate(clip.rotations[:-1]), clip.rotations[1:])
    turn = 2 * step[..., 1:] * np.sign(step[..., :1]) / clip.frame_time
    rough = np.linalg.norm(turn - np.roll(turn, 1, axis=0), axis=-1).max(axis=1)
    inside = rough[2 : frames - 1].max()
    assert rough[[0, 1, frames - 1]].max() <= 1.05 * inside
    way = np.diff(clip.root_positions, axis=0)
    rough = np.linalg.norm(way - np.roll(way, 1, axis=0), axis=-1)
    assert rough[[0, 1, frames - 1]].max() <= 1.05 * rough[2 : frames - 1].max()


def test_all_clips_run_at_sixty_frames_a_second_on_one_skeleton_a_body(library):
    assert {sample.clip.frame_time for sample in library.values()} == {1 / 60}
    skeletons = {
        (sample.tags["body"], sample.clip.skeleton.content_hash) for sample in library.values()
    }
    assert len(skeletons) == 3
