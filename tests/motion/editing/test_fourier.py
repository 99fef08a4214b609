"""Cycles between and beyond two cycles."""

from dataclasses import replace

import numpy as np
import pytest

from motion import MotionError
from motion.editing.fourier import Series, mix_cycles
from motion.rotations import angle_between, to_directions
from tests.motion.editing.measures import bone_lengths, hands_path


@pytest.fixture
def pair(samples):
    return samples["set_a_neutral"], samples["set_a_sad"]


def test_a_series_gives_its_cycle_back(samples):
    for name in ("set_a_neutral", "set_a_sad", "set_a_childlike"):
        clip = samples[name]
        channels = Series.of(clip).at(np.arange(clip.frames) / (clip.frames - 1))
        np.testing.assert_allclose(channels[:, :3], clip.root_positions, atol=1e-12)
        directions = to_directions(clip.rotations).reshape(clip.frames, -1)
        np.testing.assert_allclose(channels[:, 3:], directions, atol=1e-12)


def test_both_ends_are_the_two_cycles(pair):
    first, second = pair
    assert mix_cycles(first, second, 0.0) is first
    mixed = mix_cycles(first, second, 1.0, align=False)
    assert mixed.frames == second.frames
    np.testing.assert_allclose(angle_between(mixed.rotations, second.rotations), 0, atol=1e-6)
    np.testing.assert_allclose(mixed.root_positions, second.root_positions, atol=1e-9)


def test_little_of_the_second_changes_little(pair):
    first, second = pair
    mixed = mix_cycles(first, second, 1e-6)
    np.testing.assert_allclose(angle_between(mixed.rotations, first.rotations), 0, atol=1e-5)


@pytest.mark.parametrize("amount", [-0.5, 0.5, 1.0, 1.5])
def test_every_mix_is_a_seamless_cycle_with_its_share_of_travel_and_time(pair, amount):
    first, second = pair
    mixed = mix_cycles(first, second, amount)
    assert mixed.cyclic
    np.testing.assert_array_equal(mixed.rotations[0], mixed.rotations[-1])
    np.testing.assert_allclose(mixed.travel, first.travel + amount * (second.travel - first.travel))
    assert mixed.duration == pytest.approx(
        first.duration + amount * (second.duration - first.duration), abs=first.frame_time
    )
    lengths = np.broadcast_to(bone_lengths(first)[0], (mixed.frames, len(mixed.skeleton) - 1))
    np.testing.assert_allclose(bone_lengths(mixed), lengths, atol=1e-9)


def test_sadness_grows_from_its_opposite_to_its_exaggeration(pair):
    """Sad walkers swing their arms less."""
    paths = [hands_path(mix_cycles(*pair, amount)) for amount in (-0.5, 0.0, 0.5, 1.0)]
    assert np.all(np.diff(paths) < 0)


@pytest.fixture
def begun_later(pair):
    """The first cycle, begun a third of the way through, where it is then."""
    clip, _ = pair
    frames = (clip.frames - 1) // 3
    root, travel = clip.root_positions, clip.travel
    return replace(
        clip,
        root_positions=np.concatenate([root[frames:-1], root[: frames + 1] + travel]),
        rotations=np.concatenate([clip.rotations[frames:-1], clip.rotations[: frames + 1]]),
    )


def test_a_shift_of_the_phase_is_a_later_beginning(pair, begun_later):
    first, _ = pair
    phases = np.arange(first.frames) / (first.frames - 1)
    frames = (first.frames - 1) // 3
    shifted = Series.of(first).shifted(frames / (first.frames - 1)).at(phases)
    np.testing.assert_allclose(shifted[:, 3:], Series.of(begun_later).at(phases)[:, 3:], atol=1e-9)


def test_cycles_begun_at_different_phases_are_aligned(pair, begun_later):
    first, _ = pair
    aligned = mix_cycles(first, begun_later, 0.5)
    np.testing.assert_allclose(angle_between(aligned.rotations, first.rotations), 0, atol=1e-6)
    apart = mix_cycles(first, begun_later, 0.5, align=False)
    assert angle_between(apart.rotations, first.rotations).max() > 0.1


def test_what_is_no_cycle_or_another_body_s_is_refused(pair, samples):
    first, second = pair
    with pytest.raises(MotionError, match="cyclic"):
        Series.of(samples["acted_male_sad"])
    with pytest.raises(MotionError, match="skeleton"):
        mix_cycles(first, samples["acted_male_sad"], 0.5)
    with pytest.raises(MotionError, match="last"):
        mix_cycles(first, second, -3.0)
