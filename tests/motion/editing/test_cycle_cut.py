"""One seamless cycle, cut out of real walks and out of walks whose cycle is known."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from motion import Clip, MotionError
from motion.editing.cycle_cut import cut_cycle, roll_cycle
from motion.editing.cycles import three_cycles
from motion.editing.foot_plants import find_feet, runs
from motion.keytimes import find_keytimes
from motion.kinematics import forward_kinematics
from motion.procedural.library import set_a, set_b
from motion.rotations import angle_between, from_axis_angle, multiply, rotate
from tests.motion.editing.conftest import WALKS, read

UP = np.array([0.0, 1.0, 0.0])
REAL = [f"bandai-namco/walk_{style}_001" for style in WALKS] + ["cmu/12_01_walk"]
KNOWN = ("set_a_neutral", "set_a_sad", "set_a_angry", "set_b_pleasure_slow")


@cache
def cut(path: Path) -> Clip:
    return cut_cycle(read(path))


@pytest.fixture(params=REAL)
def cycle(request, motions_dir) -> Clip:
    return cut(motions_dir / f"{request.param}.bvh")


@pytest.fixture(scope="module")
def cycles() -> dict[str, Clip]:
    return {sample.name: sample.clip for sample in (*set_a(), *set_b())}


def bent(clip: Clip, turn: float) -> Clip:
    """Three cycles walked along a curve, ``turn`` rad a cycle; no cycle any more."""
    three = three_cycles(clip)
    angles = turn * np.arange(float(three.frames)) / (clip.frames - 1)
    ways = np.diff(three.root_positions, axis=0)
    steps = rotate(from_axis_angle(UP, (angles[1:] + angles[:-1]) / 2), ways)
    rotations = three.rotations.copy()
    rotations[:, 0] = multiply(from_axis_angle(UP, angles), rotations[:, 0])
    root = three.root_positions[0] + np.concatenate([np.zeros((1, 3)), np.cumsum(steps, axis=0)])
    return replace(three, root_positions=root, rotations=rotations)


def test_the_end_is_the_beginning_moved_along_z(cycle):
    assert cycle.cyclic
    places = forward_kinematics(cycle).positions
    way = places[-1] - places[0]
    np.testing.assert_allclose(way[:, 0], 0.0, atol=1e-9)
    np.testing.assert_allclose(way[:, 1], 0.0, atol=1e-9)
    np.testing.assert_allclose(way[:, 2], cycle.travel[2], atol=1e-9)
    assert cycle.travel[2] > 0.5


def test_no_joint_jumps_at_the_seam_more_than_within(cycle):
    """Neither its place nor its velocity: the seam's change of velocity is one among others."""
    places, last = forward_kinematics(three_cycles(cycle)).positions, cycle.frames - 1
    steps = np.linalg.norm(np.diff(places, axis=0), axis=2).max(axis=1)
    changes = np.linalg.norm(np.diff(places, 2, axis=0), axis=2).max(axis=1)
    assert max(steps[last - 1], steps[last]) <= steps[last + 1 : 2 * last - 1].max()
    assert changes[last - 1] <= changes[last : 2 * last - 1].max()


def test_feet_slide_less_than_a_centimetre(cycle):
    three = three_cycles(cycle)
    pose = forward_kinematics(three)
    for foot in find_feet(three, pose):
        for point, planted in zip(foot.points, foot.planted, strict=True):
            places = point.positions(pose)
            assert places[:, 1].min() > -0.012, "a sole goes through the floor"
            for plant in runs(planted):
                slip = np.linalg.norm((places[plant] - places[plant][0])[:, [0, 2]], axis=1).max()
                assert slip <= 0.01, f"the {foot.side} foot slides {slip:.4f} m"


def test_it_faces_where_it_goes_and_does_not_drift(cycle):
    places, roles = forward_kinematics(cycle).positions, cycle.skeleton.roles
    left = (places[:, roles["left_thigh"]] - places[:, roles["right_thigh"]]).mean(axis=0)
    assert abs(np.degrees(np.arctan2(-left[2], left[0]))) < 10
    assert abs(cycle.root_positions[:-1, 0].mean()) < 1e-9
    assert np.ptp(cycle.root_positions[:, 0]) < 0.1


def test_it_begins_with_the_left_strike(cycle):
    strike = find_keytimes(cycle)["left_strike"]
    assert min(strike, cycle.duration - strike) <= cycle.frame_time
    assert cut_cycle(cycle) is cycle, "what is cut already stays as it is"


def test_a_still_cycle_of_one_frame_stays(cycles):
    pose = cycles[KNOWN[0]]
    still = replace(pose, root_positions=pose.root_positions[:1], rotations=pose.rotations[:1])
    assert cut_cycle(still) is still


def test_joints_turn_as_in_the_recording(motions_dir):
    """Given where to cut, every frame is near the recorded one: the seam is spread thin."""
    walk = read(motions_dir / "bandai-namco/walk_normal_001.bvh")
    edges = (107, 139)
    done = cut_cycle(walk, *(frame * walk.frame_time for frame in edges))
    assert done.frames == edges[1] - edges[0] + 1
    recorded = walk.rotations[edges[0] : edges[1] + 1, 1:]
    apart = np.degrees(angle_between(done.rotations[:, 1:], recorded))
    assert apart.mean() < 1.5
    assert apart.max() < 10


def test_cut_twice_the_bits_are_the_same(motions_dir):
    walk = read(motions_dir / "bandai-namco/walk_old_001.bvh")
    assert cut_cycle(walk).content_hash == cut_cycle(walk).content_hash


@pytest.mark.parametrize("turn", [0.0, 0.3, -0.2])
@pytest.mark.parametrize("name", KNOWN)
def test_a_known_cycle_is_found_again_even_on_a_curve(name, turn, cycles):
    """Rolled out to three strides and bent, a cycle comes back straight and as it was."""
    expected, found = cut_cycle(cycles[name]), cut_cycle(bent(cycles[name], turn))
    assert found.frames == expected.frames
    np.testing.assert_allclose(found.travel, expected.travel, atol=1e-6)
    one, other = (forward_kinematics(clip).positions for clip in (found, expected))
    one, other = (places - places[:1, :1] * [1, 0, 1] for places in (one, other))
    assert np.linalg.norm(one - other, axis=2).max() < 0.005


def test_a_cycle_begun_elsewhere_is_rolled_to_its_left_strike(cycles):
    for name in KNOWN:
        rolled = cut_cycle(roll_cycle(cycles[name], 23))
        strike = find_keytimes(rolled)["left_strike"]
        assert min(strike, rolled.duration - strike) <= 0.51 * rolled.frame_time
        np.testing.assert_allclose(rolled.travel, cycles[name].travel, atol=1e-12)


def test_rolled_all_the_way_round_a_cycle_is_itself(cycles):
    clip = cycles["set_a_old"]
    there = roll_cycle(clip, 30)
    back = roll_cycle(there, clip.frames - 1 - 30)
    assert np.degrees(angle_between(back.rotations, clip.rotations)).max() < 1e-6
    ways = [c.root_positions - c.root_positions[0] for c in (back, clip)]
    np.testing.assert_allclose(ways[0], ways[1], atol=1e-12)


@pytest.mark.motions
@pytest.mark.parametrize("style", [s for s in WALKS if s not in ("normal", "masculinity")])
def test_runs_are_cut_too_and_fly_between_their_steps(style, motions_dir):
    """All but one too short for a stride and one whose feet never rest between two frames."""
    run = cut_cycle(read(motions_dir / f"bandai-namco/run_{style}_001.bvh"))
    assert run.cyclic
    assert run.travel[2] > 1.2
    found = find_keytimes(run)
    stances = [(found[f"{s}_off"] - found[f"{s}_strike"]) % run.duration for s in ("left", "right")]
    assert all(0.15 < stance / run.duration < 0.55 for stance in stances)


def test_a_motion_without_two_left_strikes_says_what_to_do(samples):
    for name in ("bow", "acted_female_sad"):
        clip = samples[name]
        short = Clip(
            clip.skeleton, clip.root_positions[:40].copy(), clip.rotations[:40].copy(), 1 / 60
        )
        with pytest.raises(MotionError, match="give the start and the end"):
            cut_cycle(short)


def test_with_start_and_end_any_motion_becomes_a_cycle(samples):
    bow = samples["bow"]
    done = cut_cycle(bow, 0.0, bow.duration)
    assert done.cyclic
    assert done.frames == bow.frames
    np.testing.assert_allclose(done.travel, 0.0, atol=0.02)
    arms = {role: joint for role, joint in bow.skeleton.roles.items() if "arm" in role}
    without_legs = replace(bow, skeleton=bow.skeleton.with_roles(arms))
    assert cut_cycle(without_legs, 0.5, 1.5).cyclic
    with pytest.raises(MotionError, match="set that body role"):
        cut_cycle(without_legs)


@pytest.mark.parametrize(
    ("start", "end", "told"),
    [
        (0.5, None, "both"),
        (None, 0.5, "both"),
        (-1.0, 1.0, "within the clip"),
        (0.5, 500.0, "within the clip"),
        (1.0, 1.01, "after its start"),
        (2.0, 1.0, "after its start"),
    ],
)
def test_wrong_ends_are_refused_with_the_mend(start, end, told, samples):
    with pytest.raises(MotionError, match=told):
        cut_cycle(samples["bow"], start, end)
