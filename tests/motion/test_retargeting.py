"""Motions on other bodies: limbs point where they pointed, feet stand on the floor."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from motion import Clip, MotionError
from motion.editing.cycle_cut import cut_cycle
from motion.editing.foot_plants import find_feet, leg_length, runs
from motion.keytimes import find_keytimes
from motion.kinematics import forward_kinematics
from motion.procedural.library import sample_clips
from motion.retargeting import Retargeted, retarget
from tests.motion.editing.conftest import WALKS, read
from tests.motion.editing.measures import bone_lengths

LIMBS = {"upper_arm": "forearm", "forearm": "hand", "thigh": "shin", "shin": "foot"}
BOTH = ("left", "right")


@pytest.fixture(scope="module")
def samples() -> dict[str, Clip]:
    return {sample.name: sample.clip for sample in sample_clips()}


@pytest.fixture(scope="module")
def cmu(motions_dir) -> Clip:
    return read(motions_dir / "cmu/12_01_walk.bvh")


@pytest.fixture(scope="module")
def bandai(motions_dir) -> Clip:
    return read(motions_dir / "bandai-namco/walk_normal_001.bvh")


@cache
def onto_bandai(motions: Path) -> Retargeted:
    cmu, bandai = motions / "cmu/12_01_walk.bvh", "bandai-namco/walk_normal_001.bvh"
    return retarget(read(cmu), read(motions / bandai))


def directions(clip: Clip) -> dict[str, np.ndarray]:
    """Limb segment to its direction (T, 3) in the world."""
    places, roles = forward_kinematics(clip).positions, clip.skeleton.roles
    found = {}
    for side in BOTH:
        for near, far in LIMBS.items():
            way = places[:, roles[f"{side}_{far}"]] - places[:, roles[f"{side}_{near}"]]
            found[f"{side}_{near}"] = way / np.linalg.norm(way, axis=1, keepdims=True)
    return found


def turned_away(one: Clip, other: Clip) -> dict[str, np.ndarray]:
    """Degrees (T,) between each limb segment's directions in two clips."""
    before, after = directions(one), directions(other)
    return {
        name: np.degrees(np.arccos(np.clip(np.sum(before[name] * after[name], axis=1), -1, 1)))
        for name in before
    }


def slip(clip: Clip) -> float:
    pose, farthest = forward_kinematics(clip), 0.0
    for foot in find_feet(clip, pose):
        for point, planted in zip(foot.points, foot.planted, strict=True):
            level = point.positions(pose)[:, [0, 2]]
            ways = [np.linalg.norm(level[p] - level[p.start], axis=1).max() for p in runs(planted)]
            farthest = max([farthest, *ways])
    return farthest


def test_onto_its_own_skeleton_a_motion_is_itself(cmu, samples):
    for clip in (cmu, samples["set_a_proud"]):
        done = retarget(clip, clip)
        np.testing.assert_allclose(done.clip.rotations, clip.rotations, atol=1e-6)
        np.testing.assert_allclose(done.clip.root_positions, clip.root_positions, atol=1e-6)
        assert done.error.greatest_direction < 1e-6
        assert done.error.unmapped == ()


def test_onto_the_same_body_by_other_names_it_is_nearly_itself(bandai, samples):
    """Nothing is known but the roles; what is left is the repair of the recording's own feet."""
    for clip, most, mean in ((bandai, 0.03, 0.003), (samples["set_a_sad"], 0.005, 0.002)):
        names = tuple(f"{name} of the other" for name in clip.skeleton.names)
        other = replace(clip, skeleton=replace(clip.skeleton, names=names))
        done = retarget(clip, other)
        one, two = (forward_kinematics(c).positions for c in (clip, done.clip))
        gaps = np.linalg.norm(one - two, axis=2)
        assert gaps.max() < most
        assert gaps.mean() < mean


def test_bones_keep_the_new_body_s_lengths(motions_dir, bandai):
    done = onto_bandai(motions_dir).clip
    assert done.skeleton.content_hash == bandai.skeleton.content_hash
    expected = np.broadcast_to(bone_lengths(bandai)[:1], (done.frames, len(done.skeleton) - 1))
    np.testing.assert_allclose(bone_lengths(done), expected, atol=1e-9)


def test_limbs_point_where_they_pointed(motions_dir, cmu):
    """Arms as they did; legs but for what other feet and standing soles ask of them."""
    away = turned_away(cmu, onto_bandai(motions_dir).clip)
    for name, angles in away.items():
        if "arm" in name:
            assert angles.max() < 1e-3, name
        else:
            assert angles.mean() < 4.0, name
    assert np.mean(list(away.values())) < 1.5
    inside = [angles[60:-60] for angles in away.values()]  # at its ends the recording walks on
    assert np.max(inside) < 12.0


def test_soles_stand_on_the_floor_and_do_not_slide(motions_dir, bandai):
    done = onto_bandai(motions_dir)
    assert slip(done.clip) <= 0.01
    pose = forward_kinematics(done.clip)
    for sole, foot in zip(find_feet(bandai), find_feet(done.clip, pose), strict=True):
        lowest = np.min([point.positions(pose)[:, 1] for point in sole.points], axis=0)
        assert lowest.min() > -0.015
        assert np.abs(lowest[foot.stands]).mean() < 0.01


def test_the_error_is_what_can_be_measured(motions_dir, cmu):
    done = onto_bandai(motions_dir)
    away = np.array(list(turned_away(cmu, done.clip).values()))
    assert np.degrees(done.error.mean_direction) == pytest.approx(away.mean(), abs=1e-3)
    assert np.degrees(done.error.greatest_direction) == pytest.approx(away.max(), abs=1e-3)
    assert done.error.slip == pytest.approx(slip(done.clip), abs=1e-9)
    assert done.error.sole_height < 0.01
    assert done.error.unmapped == ()


def test_the_hips_go_as_many_leg_lengths(motions_dir, cmu):
    done = onto_bandai(motions_dir).clip
    scale = leg_length(done, "left") / leg_length(cmu, "left")
    assert done.travel[2] == pytest.approx(scale * cmu.travel[2], rel=0.01)
    roles = done.skeleton.roles
    height = forward_kinematics(done).positions[:, roles["left_thigh"], 1].mean()
    assert 0.9 < height / leg_length(done, "left") < 1.15


def test_left_stays_left(motions_dir, cmu):
    """On the same side of the hips, and in the same half of the stride."""
    done = onto_bandai(motions_dir).clip
    for part in ("hand", "foot", "upper_arm"):
        asides = []
        for clip in (cmu, done):
            places, roles = forward_kinematics(clip).positions, clip.skeleton.roles
            across = places[:, roles["left_thigh"]] - places[:, roles["right_thigh"]]
            way = places[:, roles[f"left_{part}"]] - places[:, roles[f"right_{part}"]]
            asides.append(np.sum(across * way, axis=1).mean())
        assert asides[0] > 0
        assert asides[1] > 0
    ahead = []
    for clip in (cmu, done):
        places, roles = forward_kinematics(clip).positions, clip.skeleton.roles
        ahead.append(places[:, roles["left_foot"], 2] - places[:, roles["right_foot"], 2])
    assert np.corrcoef(*ahead)[0, 1] > 0.99


def test_there_and_back_little_is_lost(motions_dir, cmu):
    back = retarget(onto_bandai(motions_dir).clip, cmu).clip
    away = turned_away(cmu, back)
    assert np.mean(list(away.values())) < 2.5
    joints = sorted(cmu.skeleton.roles.values())
    one, two = (forward_kinematics(clip).positions[:, joints] for clip in (cmu, back))
    gaps = np.linalg.norm((one - one[:, :1]) - (two - two[:, :1]), axis=2)
    assert gaps.mean() < 0.03, "what joints without a role did is lost"


@pytest.mark.parametrize("style", WALKS)
def test_every_walk_s_cycle_stays_one_on_another_body(style, motions_dir, cmu):
    cycle = cut_cycle(read(motions_dir / f"bandai-namco/walk_{style}_001.bvh"))
    done = retarget(cycle, cmu)
    assert done.clip.cyclic
    assert done.error.slip <= 0.01
    assert done.error.sole_height <= 0.01
    assert np.degrees(done.error.mean_direction) < 2.0
    before, after = find_keytimes(cycle), find_keytimes(done.clip)
    for event, time in before.items():
        gap = abs(after[event] - time) % cycle.duration
        assert min(gap, cycle.duration - gap) < 0.07, event


def test_joints_without_a_role_rest_as_in_standing(bandai, cmu):
    done = retarget(bandai, cmu).clip
    for name in ("LThumb", "RightFingerBase", "LHipJoint", "Neck1"):
        joint = done.skeleton.names.index(name)
        turns = done.rotations[:, joint]
        assert np.abs(np.abs(turns @ turns[0]) - 1.0).max() < 1e-9


def test_a_body_of_other_proportions_stands_upright_as_before(samples):
    """The man's knock on a slighter body: nothing but the size changes."""
    done = retarget(samples["acted_male_neutral"], samples["set_a_neutral"])
    assert np.degrees(done.error.greatest_direction) < 1.0
    assert done.error.slip < 0.002
    assert done.error.sole_height < 0.002


def test_roles_of_only_one_body_are_told(samples):
    clip = samples["set_a_neutral"]
    fewer = {r: j for r, j in clip.skeleton.roles.items() if r not in ("chest", "left_toes")}
    other = replace(clip, skeleton=clip.skeleton.with_roles(fewer))
    assert retarget(clip, other).error.unmapped == ("chest", "left_toes")
    assert retarget(other, clip).error.unmapped == ("chest", "left_toes")


def test_a_missing_role_is_named_with_its_skeleton(samples):
    clip = samples["set_a_neutral"]
    legs = {r: j for r, j in clip.skeleton.roles.items() if r != "left_shin"}
    lame = replace(clip, skeleton=clip.skeleton.with_roles(legs))
    with pytest.raises(MotionError, match="left shin of the new skeleton: set"):
        retarget(clip, lame)
    with pytest.raises(MotionError, match="left shin of the motion's skeleton: set"):
        retarget(lame, clip)
