"""Offsets from standing poses, added to every frame."""

import numpy as np
import pytest

from motion.editing.posture import PostureOffset, add_posture, capture_pose
from motion.kinematics import forward_kinematics
from motion.procedural.stances import STANCES, stance
from motion.rotations import angle_between, from_axis_angle
from motion.standing import Standing
from tests.motion.editing.conftest import read
from tests.motion.editing.measures import bone_lengths


def offset(name: str) -> PostureOffset:
    return PostureOffset.between(stance("neutral"), stance(name))


def nose_down(clip):
    """Mean forward lean of the way from neck to head, rad; clips walk towards +z."""
    positions, roles = forward_kinematics(clip).positions, clip.skeleton.roles
    way = positions[:, roles["head"]] - positions[:, roles["neck"]]
    return float(np.arctan2(way[:, 2], way[:, 1]).mean())


def hands_apart(clip):
    positions, roles = forward_kinematics(clip).positions, clip.skeleton.roles
    return float(
        np.linalg.norm(
            positions[:, roles["left_hand"]] - positions[:, roles["right_hand"]], axis=1
        ).mean()
    )


@pytest.fixture
def neutral(samples):
    return samples["acted_female_neutral"]


@pytest.mark.parametrize("name", STANCES)
def test_an_amount_of_zero_changes_nothing(neutral, name):
    assert add_posture(neutral, [(offset(name), 0.0)]) is neutral


def test_offsets_add_before_they_are_normalised_so_order_does_not_matter(neutral):
    head, hands = offset("head_down"), offset("hands_away_and_feet_apart")
    once = add_posture(neutral, [(head, 0.7), (hands, 0.4)])
    other = add_posture(neutral, [(hands, 0.4), (head, 0.7)])
    np.testing.assert_allclose(once.rotations, other.rotations, atol=1e-12)
    halves = add_posture(neutral, [(head, 0.35), (hands, 0.4), (head, 0.35)])
    np.testing.assert_allclose(once.rotations, halves.rotations, atol=1e-12)


@pytest.mark.parametrize("name", ["head_down", "head_a_little_down"])
def test_the_head_goes_down_and_the_opposite_lifts_it(neutral, name):
    assert nose_down(add_posture(neutral, [(offset(name), 1.0)])) > nose_down(neutral) + 0.1
    more = nose_down(add_posture(neutral, [(offset(name), 1.5)]))
    assert more > nose_down(add_posture(neutral, [(offset(name), 1.0)]))


@pytest.mark.motions
@pytest.mark.parametrize("path", ["bandai-namco/walk_normal_001", "cmu/12_01_walk"])
def test_an_offset_carries_over_to_other_skeletons(motions_dir, path):
    """The same offset does the same to bodies whose joints have other axes."""
    clip = read(motions_dir / f"{path}.bvh")
    bowed = add_posture(clip, [(offset("head_down"), 1.0)])
    assert nose_down(bowed) > nose_down(clip) + 0.1
    wide = add_posture(clip, [(offset("hands_away_and_feet_apart"), 1.0)])
    assert hands_apart(wide) > hands_apart(clip) + 0.05
    close = add_posture(clip, [(offset("hands_and_feet_closer"), 1.0)])
    assert hands_apart(close) < hands_apart(clip)
    np.testing.assert_allclose(bone_lengths(wide), bone_lengths(clip), atol=1e-9)


def test_a_pose_captured_from_a_clip_is_found_again(neutral):
    """What one frame has beyond another, added to that other frame, gives the first."""
    pose = {frame: capture_pose(neutral, frame) for frame in (0, 90)}
    change = PostureOffset.between(pose[0], pose[90])
    reached = add_posture(neutral, [(change, 1.0)])
    trunk = [neutral.skeleton.roles[role] for role in ("spine", "chest", "neck", "head")]
    apart = angle_between(reached.rotations[0, trunk], neutral.rotations[90, trunk])
    np.testing.assert_allclose(apart, 0, atol=1e-6)


def test_a_far_reaching_arm_is_left_as_it_is(neutral):
    """Stretched forward, a limb's end is more than 0.9 of its length from where it hangs."""
    roles, skeleton = neutral.skeleton.roles, neutral.skeleton
    local = np.zeros((5, len(skeleton), 4))
    local[..., 0] = 1.0  # the sample skeleton rests in a T-pose: arms straight out to the sides
    up = from_axis_angle(np.array([0.0, 0.0, 1.0]), np.array(np.pi / 3))
    local[:, roles["left_upper_arm"]] = up
    reaching = type(neutral)(skeleton, np.zeros((5, 3)), local, 1 / 60)
    edited = add_posture(reaching, [(offset("elbows_away"), 1.0)])
    arm = roles["left_upper_arm"]
    apart = angle_between(edited.rotations[:, arm], reaching.rotations[:, arm])
    np.testing.assert_allclose(apart, 0, atol=1e-7)


def test_an_offset_touches_its_own_joints_only(neutral):
    bowed = add_posture(neutral, [(offset("head_down"), 1.0)])
    touched = [neutral.skeleton.roles[role] for role in ("chest", "neck", "head")]
    others = [joint for joint in range(len(neutral.skeleton)) if joint not in touched]
    np.testing.assert_array_equal(bowed.rotations[:, others], neutral.rotations[:, others])
    turned = angle_between(bowed.rotations[:, touched], neutral.rotations[:, touched])
    assert turned.min() > np.radians(3)


def test_axes_may_be_those_of_the_motion_before_other_edits(neutral):
    """They are the same unless the other edit hides them."""
    offsets = [(offset("elbows_away"), 1.0)]
    own = add_posture(neutral, offsets)
    known = add_posture(neutral, offsets, Standing.of(neutral))
    np.testing.assert_array_equal(own.rotations, known.rotations)
    assert Standing.of(neutral) is Standing.of(neutral)


def test_offsets_of_both_bodies_keep_the_other_s_bones(samples):
    """A pose captured from one body, put onto the other, in both ways."""
    bodies = {sex: samples[f"acted_{sex}_neutral"] for sex in ("female", "male")}
    for giver, taker in (("female", "male"), ("male", "female")):
        bowed = samples[f"acted_{giver}_sad"]
        change = PostureOffset.between(capture_pose(bodies[giver], 0), capture_pose(bowed, 0))
        changed = add_posture(bodies[taker], [(change, 1.0)])
        assert nose_down(changed) > nose_down(bodies[taker])
        np.testing.assert_allclose(bone_lengths(changed), bone_lengths(bodies[taker]), atol=1e-9)
