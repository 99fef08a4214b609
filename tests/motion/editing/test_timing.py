"""Even speed and added acceleration."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from motion.editing.limbs import LIMBS, find_limbs
from motion.editing.timing import ADDED, EVEN, Timing, change_timing, limb_speed, limb_warp
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
@pytest.mark.parametrize("name", ["left_arm", "right_arm", "head"])
def test_only_the_speed_along_the_way_changes(knocking, kind, name):
    limb = find_limbs(knocking.skeleton)[name]
    before = way_from_the_root(knocking, limb)
    fine = CubicSpline(np.arange(len(before)), before)(
        np.linspace(0, len(before) - 1, 40 * len(before))
    )
    after = way_from_the_root(change_timing(knocking, Timing(kind)), limb)
    off = [np.linalg.norm(fine - place, axis=1).min() for place in after]
    assert max(off) <= 0.002  # the clips have 60 frames a second: between 1 mm at 100, 5 mm at 30


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
