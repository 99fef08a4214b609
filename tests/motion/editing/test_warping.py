"""Keyframes that a motion is bent through, and moments that are moved."""

import numpy as np
import pytest

from motion import MotionError
from motion.editing.warping import Keyframe, warp_poses, warp_time
from motion.kinematics import forward_kinematics
from motion.rotations import angle_between, from_axis_angle, multiply
from tests.motion.editing.measures import bone_lengths

BEND = from_axis_angle(np.array([0.0, 1.0, 0.0]), np.asarray(0.5))


def keyframe(clip, frame, role, root=None):
    joint = clip.skeleton.roles[role]
    return Keyframe(frame, {joint: multiply(clip.rotations[frame, joint], BEND)}, root)


def test_keyframes_are_met_and_what_is_far_from_them_stays(knocking):
    keys = [keyframe(knocking, 150, "left_forearm"), keyframe(knocking, 120, "left_forearm")]
    warped = warp_poses(knocking, keys, reach=0.5)
    joint = knocking.skeleton.roles["left_forearm"]
    change = angle_between(warped.rotations[:, joint], knocking.rotations[:, joint])
    np.testing.assert_allclose(change[[120, 150]], 0.5, atol=1e-7)
    assert change[:90].max() < 1e-7
    assert change[181:].max() < 1e-7
    assert np.abs(np.diff(change)).max() < 0.05
    others = [j for j in range(len(knocking.skeleton)) if j != joint]
    np.testing.assert_array_equal(warped.rotations[:, others], knocking.rotations[:, others])
    np.testing.assert_allclose(bone_lengths(warped), bone_lengths(knocking), atol=1e-9)


def test_a_keyframe_moves_the_root(knocking):
    place = knocking.root_positions[60] + [0.0, -0.2, 0.1]
    warped = warp_poses(knocking, [Keyframe(60, root=place)])
    np.testing.assert_allclose(warped.root_positions[60], place, atol=1e-12)
    np.testing.assert_array_equal(warped.root_positions[:30], knocking.root_positions[:30])


@pytest.mark.parametrize("amount", [0.0, 0.25, 1.0, 1.5])
def test_the_amount_scales_the_change(knocking, amount):
    warped = warp_poses(knocking, [keyframe(knocking, 100, "head")], amount)
    joint = knocking.skeleton.roles["head"]
    change = angle_between(warped.rotations[100, joint], knocking.rotations[100, joint])
    assert change == pytest.approx(0.5 * amount, abs=1e-7)


def test_a_moment_is_moved_and_the_ends_stay(knocking):
    warped = warp_time(knocking, [(2.0, 3.0)])
    assert warped.frames == knocking.frames
    for now, was in ((0, 0), (180, 120), (-1, -1)):
        turned = angle_between(warped.rotations[now], knocking.rotations[was])
        np.testing.assert_allclose(turned, 0.0, atol=1e-6)
        np.testing.assert_allclose(warped.root_positions[now], knocking.root_positions[was])
    np.testing.assert_allclose(bone_lengths(warped), bone_lengths(knocking), atol=1e-9)
    assert np.isfinite(forward_kinematics(warped).positions).all()


def test_nothing_asked_changes_nothing(knocking):
    assert warp_poses(knocking, []) is knocking
    assert warp_poses(knocking, [keyframe(knocking, 5, "head")], 0.0) is knocking
    assert warp_time(knocking, [(1.0, 2.0)], 0.0) is knocking


def test_what_cannot_be_is_refused(knocking):
    with pytest.raises(MotionError, match="once"):
        warp_poses(knocking, [Keyframe(3), Keyframe(3)])
    with pytest.raises(MotionError, match="within frames"):
        warp_poses(knocking, [Keyframe(knocking.frames)])
    with pytest.raises(MotionError, match="same order"):
        warp_time(knocking, [(1.0, 2.5), (2.0, 2.4)])
    with pytest.raises(MotionError, match="within"):
        warp_time(knocking, [(1.0, 99.0)])
    for near in (
        [(1e-310, 0.5)],
        [(1.0, 2.0), (1.0 + 1e-9, 2.5)],
        [(2.0, knocking.duration - 1e-300)],
    ):
        with pytest.raises(MotionError, match="1 ms apart"):
            warp_time(knocking, near)
