"""Forward kinematics: the same as a chain of SciPy rotations, whatever the whole body does."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from motion.clip import Clip
from motion.ingest import ingest
from motion.kinematics import end_site_positions, forward_kinematics
from motion.rotations import angle_between, multiply, rotate
from motion.skeleton import EndSite, Skeleton


@st.composite
def clips(draw, frames=None):
    joints = draw(st.integers(1, 15))
    frames = draw(st.integers(0, 5)) if frames is None else frames
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    parents = np.array([-1] + [draw(st.integers(0, joint - 1)) for joint in range(1, joints)])
    turns = Rotation.random(max(frames * joints, 1), rng=rng).as_quat(scalar_first=True)
    sites = tuple(EndSite(joint, (0.1, -0.2, 0.05)) for joint in range(0, joints, 3))
    return Clip(
        Skeleton(tuple(map(str, range(joints))), parents, rng.normal(size=(joints, 3)), sites),
        rng.normal(size=(frames, 3)) * 10,
        turns[: frames * joints].reshape(frames, joints, 4),
        1 / 30,
    )


def by_scipy(clip):
    """Positions (T, J, 3) and rotation matrices (T, J, 3, 3), one joint and frame at a time."""
    count = len(clip.skeleton)
    positions, turns = np.empty((clip.frames, count, 3)), np.empty((clip.frames, count, 3, 3))
    for frame in range(clip.frames):
        world = []
        for joint in range(count):
            local = Rotation.from_quat(clip.rotations[frame, joint], scalar_first=True)
            parent = int(clip.skeleton.parents[joint])
            if parent < 0:
                positions[frame, joint] = clip.root_positions[frame]
                world.append(local)
            else:
                offset = world[parent].apply(clip.skeleton.offsets[joint].copy())
                positions[frame, joint] = positions[frame, parent] + offset
                world.append(world[parent] * local)
            turns[frame, joint] = world[joint].as_matrix()
    return positions, turns


@given(clips())
def test_positions_and_rotations_equal_a_chain_of_scipy_rotations(clip):
    pose = forward_kinematics(clip)
    positions, turns = by_scipy(clip)
    assert pose.positions.shape == (clip.frames, len(clip.skeleton), 3)
    assert pose.rotations.shape == (clip.frames, len(clip.skeleton), 4)
    assert pose.positions == pytest.approx(positions, abs=1e-9)
    ours = Rotation.from_quat(pose.rotations.reshape(-1, 4), scalar_first=True).as_matrix()
    assert ours.reshape(turns.shape) == pytest.approx(turns, abs=1e-9)


@given(clips(), st.integers(0, 2**32 - 1))
def test_turning_and_moving_the_whole_body_turns_and_moves_every_joint(clip, seed):
    rng = np.random.default_rng(seed)
    turn = Rotation.random(rng=rng).as_quat(scalar_first=True)
    shift = rng.normal(size=3)
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    moved = Clip(
        clip.skeleton, rotate(turn, clip.root_positions) + shift, rotations, clip.frame_time
    )
    before, after = forward_kinematics(clip), forward_kinematics(moved)
    assert after.positions == pytest.approx(rotate(turn, before.positions) + shift, abs=1e-9)
    assert (angle_between(after.rotations, multiply(turn, before.rotations)) < 1e-7).all()
    ends = end_site_positions(clip.skeleton, before)
    assert end_site_positions(clip.skeleton, after) == pytest.approx(
        rotate(turn, ends) + shift, abs=1e-9
    )


@given(clips())
def test_bones_keep_their_lengths_and_quaternions_theirs(clip):
    pose = forward_kinematics(clip)
    for joint in range(1, len(clip.skeleton)):
        bone = pose.positions[:, joint] - pose.positions[:, clip.skeleton.parents[joint]]
        length = np.linalg.norm(clip.skeleton.offsets[joint])
        assert np.linalg.norm(bone, axis=-1) == pytest.approx(length)
    assert np.linalg.norm(pose.rotations, axis=-1) == pytest.approx(1)


@given(clips(frames=7))
def test_frames_do_not_depend_on_each_other(clip):
    whole = forward_kinematics(clip)
    part = Clip(clip.skeleton, clip.root_positions[2:5], clip.rotations[2:5], clip.frame_time)
    assert forward_kinematics(part).positions == pytest.approx(whole.positions[2:5], abs=1e-12)


def test_clips_longer_than_a_block_are_solved_to_their_last_frame():
    rng = np.random.default_rng(3)
    turns = Rotation.random(5000 * 3, rng=rng).as_quat(scalar_first=True).reshape(5000, 3, 4)
    skeleton = Skeleton(("a", "b", "c"), np.array([-1, 0, 1]), rng.normal(size=(3, 3)))
    clip = Clip(skeleton, rng.normal(size=(5000, 3)), turns, 0.01)
    last = Clip(skeleton, clip.root_positions[-1:], clip.rotations[-1:], 0.01)
    whole, one = forward_kinematics(clip), forward_kinematics(last)
    assert whole.positions[-1:] == pytest.approx(one.positions, abs=1e-12)
    assert whole.rotations[-1:] == pytest.approx(one.rotations, abs=1e-12)


@pytest.mark.motions
def test_a_real_walk_equals_a_chain_of_scipy_rotations(motions_dir):
    clip = ingest((motions_dir / "cmu/12_01_walk.bvh").read_bytes()).clip
    clip = Clip(clip.skeleton, clip.root_positions[::100], clip.rotations[::100], clip.frame_time)
    positions, _ = by_scipy(clip)
    assert forward_kinematics(clip).positions == pytest.approx(positions, abs=1e-9)
