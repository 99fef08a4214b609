"""Emotion learned from one pair of clips and put onto others."""

import numpy as np
import pytest

from motion import MotionError
from motion.editing.emotion_transform import apply_emotion, learn_emotion
from motion.rotations import angle_between
from tests.motion.editing.measures import bone_lengths, hands_path


def like(clip, other):
    return np.degrees(angle_between(clip.rotations, other.rotations)).max()


def test_nothing_is_learned_from_a_clip_and_itself(knocking):
    nothing = learn_emotion(knocking, knocking)
    assert nothing.pace == 1.0
    np.testing.assert_allclose(nothing.timing, np.linspace(0, 1, 101), atol=1e-9)
    assert set(nothing.amplitude.values()) == {1.0}
    assert like(apply_emotion(knocking, nothing), knocking) < 1e-4


def test_no_amount_is_the_clip_and_little_is_little(samples):
    clip = samples["acted_female_neutral"]
    angry = learn_emotion(samples["acted_male_neutral"], samples["acted_male_angry"])
    assert apply_emotion(clip, angry, 0.0) is clip
    assert like(apply_emotion(clip, angry, 1e-5), clip) < 0.1


@pytest.mark.parametrize("emotion", ["angry", "sad"])
def test_a_man_s_emotion_makes_a_woman_s_action_as_quick_and_as_wide(samples, emotion):
    man, his = samples["acted_male_neutral"], samples[f"acted_male_{emotion}"]
    woman = samples["acted_female_neutral"]
    learned = learn_emotion(man, his)
    hers = apply_emotion(woman, learned)
    assert hers.duration / woman.duration == pytest.approx(his.duration / man.duration, rel=0.01)
    # Wide as well as quick: the hands' mean speed moves to where his went.
    speed = [hands_path(clip) / clip.duration for clip in (woman, hers)]
    assert (speed[1] > speed[0]) == (emotion == "angry")
    assert set(learned.amplitude) <= set(man.skeleton.roles)


def test_joints_swing_as_much_wider_as_learned(samples):
    clip = samples["set_b_neutral_normal"]
    learned = learn_emotion(clip, samples["set_b_excitement_normal"])
    joint = clip.skeleton.roles["left_thigh"]
    done = apply_emotion(clip, learned).rotations[:, joint]
    before = clip.rotations[:, joint]
    wide = [np.ptp(2 * np.arcsin(turn[:, 1] * np.sign(turn[:, 0]))) for turn in (before, done)]
    assert wide[1] / wide[0] == pytest.approx(learned.amplitude["left_thigh"], rel=0.05)


@pytest.mark.parametrize("amount", [-1.0, 0.5, 1.0, 2.0])
def test_bones_and_ends_stay_at_any_amount(samples, amount):
    clip = samples["acted_female_neutral"]
    learned = learn_emotion(samples["acted_male_neutral"], samples["acted_male_excited"])
    done = apply_emotion(clip, learned, amount)
    lengths = np.broadcast_to(bone_lengths(clip)[0], (done.frames, len(done.skeleton) - 1))
    np.testing.assert_allclose(bone_lengths(done), lengths, atol=1e-9)
    np.testing.assert_allclose(done.root_positions[[0, -1]], clip.root_positions[[0, -1]])
    assert np.degrees(angle_between(done.rotations[1:], done.rotations[:-1])).max() < 60


def test_a_single_pose_teaches_nothing(samples):
    clip = samples["set_a_proud"]
    pose = type(clip)(clip.skeleton, clip.root_positions[:2], clip.rotations[:2], clip.frame_time)
    with pytest.raises(MotionError, match="4 frames"):
        learn_emotion(clip, pose)
