"""Even speed and added acceleration."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.spatial import cKDTree

from motion.editing.limbs import LIMBS, find_limbs
from motion.editing.tempo import resample_rate
from motion.editing.timing import (
    ADDED,
    EVEN,
    Timing,
    _added,
    _even,
    change_timing,
    limb_speed,
    limb_warp,
)
from motion.kinematics import forward_kinematics
from motion.rotations import conjugate, rotate


def variation(clip, name):
    """Coefficient of variation of a limb's speed."""
    speed = limb_speed(clip, forward_kinematics(clip), find_limbs(clip.skeleton)[name])
    return speed.std() / speed.mean()


def way_from_the_root(clip, limb):
    """(T, 3) path of a limb's end from its root, in the frame of the root's parent."""
    pose = forward_kinematics(clip)
    parent = int(clip.skeleton.parents[limb.root])
    way = pose.positions[:, limb.end] - pose.positions[:, limb.root]
    return rotate(conjugate(pose.rotations[:, parent]), way)


@pytest.mark.parametrize("kind", [EVEN, ADDED])
def test_length_first_and_last_frame_stay(knocking, kind):
    edited = change_timing(knocking, Timing(kind))
    assert edited.frames == knocking.frames
    for frame in (0, -1):
        np.testing.assert_allclose(
            np.abs(np.sum(edited.rotations[frame] * knocking.rotations[frame], axis=-1)),
            1,
            atol=1e-9,
        )


@pytest.mark.parametrize("kind", [EVEN, ADDED])
@pytest.mark.parametrize("name", LIMBS)
@pytest.mark.parametrize(("rate", "within"), [(100.0, 0.001), (30.0, 0.005)])
def test_only_the_speed_along_the_way_changes(knocking, kind, name, rate, within):
    limb = find_limbs(knocking.skeleton)[name]
    clip = resample_rate(knocking, rate)
    before = way_from_the_root(clip, limb)
    frames = np.linspace(0, len(before) - 1, 40 * len(before))
    fine = CubicSpline(np.arange(len(before)), before)(frames)
    after = way_from_the_root(change_timing(clip, Timing(kind, LIMBS)), limb)
    nearest, _ = cKDTree(fine).query(after)
    assert nearest.max() <= within


def test_even_speed_varies_less_and_added_acceleration_more(knocking):
    arm = "right_arm"
    even = variation(change_timing(knocking, Timing(EVEN)), arm)
    added = variation(change_timing(knocking, Timing(ADDED)), arm)
    assert even < 0.9 * variation(knocking, arm)
    assert added > 1.2 * variation(knocking, arm)


def test_added_acceleration_makes_slow_parts_slower_and_fast_parts_faster(knocking):
    """Figures 24 and 25: time stands still where the hand was slow and runs where it was fast."""
    pose, limb = forward_kinematics(knocking), find_limbs(knocking.skeleton)["right_arm"]
    warp = limb_warp(knocking, pose, limb, Timing(ADDED))
    assert np.all(np.diff(warp) > 0)
    pace = np.diff(warp)
    assert pace.min() < 0.5
    assert pace.max() > 1.2


def test_legs_of_a_walk_are_left_alone_unless_asked(knocking):
    limbs = find_limbs(knocking.skeleton)
    legs = [joint for name in ("left_leg", "right_leg") for joint in limbs[name].joints]
    default = change_timing(knocking, Timing(ADDED))
    np.testing.assert_array_equal(default.rotations[:, legs], knocking.rotations[:, legs])
    asked = change_timing(knocking, Timing(ADDED, LIMBS))
    assert np.abs(asked.rotations[:, legs] - knocking.rotations[:, legs]).max() > 0.01


@pytest.mark.parametrize("kind", [EVEN, ADDED])
def test_the_amount_goes_from_nothing_to_all_and_beyond(knocking, kind):
    assert change_timing(knocking, Timing(kind, amount=0.0)) is knocking
    amounts = (0.0, 0.5, 1.0, 1.3)
    varied = [
        variation(change_timing(knocking, Timing(kind, amount=a)), "right_arm") for a in amounts
    ]
    assert np.all(np.diff(varied) < 0 if kind == EVEN else np.diff(varied) > 0)


@pytest.mark.parametrize("kind", [EVEN, ADDED])
@pytest.mark.parametrize("segment", [0.5, 1.0, 2.0])
def test_segments_keep_their_length(knocking, kind, segment):
    """Where one segment ends and the next begins, a limb is where it was."""
    pose, limb = forward_kinematics(knocking), find_limbs(knocking.skeleton)["right_arm"]
    warp = limb_warp(knocking, pose, limb, Timing(kind, segment=segment))
    last = knocking.frames - 1
    pieces = int(np.ceil(knocking.duration / segment - 1e-9))
    edges = np.linspace(0, last, pieces + 1)
    np.testing.assert_allclose(np.interp(edges, np.arange(last + 1), warp), edges, atol=0.8)
    assert np.abs(warp - np.arange(last + 1)).max() > 1.5


def test_the_thesis_s_segments_are_the_default(knocking):
    for kind, segment in ((EVEN, 1.5), (ADDED, 1.0)):
        ours = change_timing(knocking, Timing(kind)).rotations
        same = change_timing(knocking, Timing(kind, segment=segment)).rotations
        np.testing.assert_array_equal(ours, same)


@pytest.fixture
def knock_like():
    """Speed (T,) of a hand, m/s, 100 a second: as figure 23, two strokes with a stop between."""
    seconds = np.arange(0.0, 1.0, 0.01)
    return 0.02 + 2.0 * np.abs(np.sin(2 * np.pi * seconds)) ** 3


def test_figure_23_even_speed_lasts_as_long_as_it_is_fast(knock_like):
    durations = _even(knock_like)
    fast = knock_like > 0.3 * knock_like.max()
    share = durations[fast] / knock_like[fast]
    np.testing.assert_allclose(share, share[0])
    # The stop is held about as long as what surrounds it on the average, not skipped.
    assert durations[knock_like < 0.1].min() > 0.5 * durations.mean()


def test_figures_24_and_25_one_short_pause_is_prolonged_and_long_ones_are_not(knock_like):
    prolonged = _added(knock_like, 0.01)
    stop = slice(48, 53)
    assert prolonged[stop].min() > 5.0
    assert prolonged.argmax() in range(48, 53)
    assert prolonged[knock_like > 0.9 * knock_like.max()].max() < 1.5
    resting = np.concatenate([knock_like[:50], np.full(60, 0.02), knock_like[50:]])
    assert _added(resting, 0.01)[60:100].max() < 1.5


@pytest.mark.motions
@pytest.mark.parametrize("kind", [EVEN, ADDED])
def test_a_walk_s_arms_go_the_same_way_at_another_speed(walk, kind):
    """Recorded at 30 frames a second."""
    for name in ("left_arm", "right_arm"):
        limb = find_limbs(walk.skeleton)[name]
        before = way_from_the_root(walk, limb)
        frames = np.linspace(0, len(before) - 1, 20 * len(before))
        fine = CubicSpline(np.arange(len(before)), before)(frames)
        edited = change_timing(walk, Timing(kind))
        after = way_from_the_root(edited, limb)
        nearest, _ = cKDTree(fine).query(after)
        assert nearest.max() <= 0.005
        more = variation(edited, name) > variation(walk, name)
        assert more == (kind == ADDED)
