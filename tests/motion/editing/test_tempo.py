"""The whole body in other time: faster, slower, at another frame rate, or only a part."""

import numpy as np
import pytest

from motion import MotionError
from motion.editing.tempo import change_tempo, cut, resample_rate
from motion.rotations import angle_between
from tests.motion.editing.measures import bone_lengths


@pytest.fixture
def cycle(samples):
    return samples["set_a_proud"]


def apart(clip, other):
    """Largest angle between two clips' joints, degrees."""
    return np.degrees(angle_between(clip.rotations, other.rotations)).max()


def seam(clip):
    """Largest angle from the last frame to the first, degrees."""
    return np.degrees(angle_between(clip.rotations[0], clip.rotations[-1])).max()


@pytest.mark.parametrize("factor", [0.5, 0.8, 1.3, 2.0, 3.7])
def test_a_factor_divides_the_time_and_nothing_else(knocking, factor):
    clip = change_tempo(knocking, factor)
    assert clip.frame_time == knocking.frame_time
    assert clip.duration == pytest.approx(knocking.duration / factor, abs=clip.frame_time)
    shown = np.arange(clip.frames) * factor
    whole = np.flatnonzero(np.isclose(shown, np.round(shown)))
    assert len(whole) > 3
    before = np.round(shown[whole]).astype(int)
    turned = angle_between(clip.rotations[whole], knocking.rotations[before])
    np.testing.assert_allclose(turned, 0.0, atol=1e-6)
    np.testing.assert_allclose(clip.root_positions[whole], knocking.root_positions[before])
    np.testing.assert_allclose(bone_lengths(clip)[0], bone_lengths(knocking)[0], atol=1e-9)


def test_twice_as_fast_and_back_is_the_clip(knocking):
    slow = change_tempo(knocking, 0.5)
    assert slow.frames == 2 * knocking.frames - 1
    assert apart(change_tempo(slow, 2.0), knocking) < 1e-4


def test_a_tempo_of_one_and_the_clip_s_own_rate_change_nothing(knocking):
    assert change_tempo(knocking, 1.0) is knocking
    np.testing.assert_array_equal(resample_rate(knocking, 60.0).rotations, knocking.rotations)


@pytest.mark.parametrize("rate", [24.0, 30.0, 100.0, 120.0])
def test_a_rate_keeps_the_pace(knocking, rate):
    clip = resample_rate(knocking, rate)
    assert clip.frame_time == 1.0 / rate
    assert 0.0 <= knocking.duration - clip.duration < clip.frame_time
    common = np.arange(0.0, clip.duration, 0.5)
    now, was = (np.round(common / c.frame_time).astype(int) for c in (clip, knocking))
    np.testing.assert_allclose(
        angle_between(clip.rotations[now], knocking.rotations[was]), 0.0, atol=1e-6
    )


def test_a_cycle_stays_seamless_and_travels_as_far(cycle):
    edits = (change_tempo(cycle, 1.4), change_tempo(cycle, 0.7), resample_rate(cycle, 47.0))
    for clip in edits:
        assert clip.cyclic
        assert seam(clip) < 1e-5
        np.testing.assert_allclose(clip.travel, cycle.travel, atol=1e-9)
        steps = np.degrees(angle_between(clip.rotations[1:], clip.rotations[:-1])).max(axis=1)
        assert steps[[0, -1]].max() <= steps.max()


def test_a_cut_has_the_frames_in_between(knocking):
    part = cut(knocking, 1.0, 2.5)
    assert part.duration == pytest.approx(1.5)
    np.testing.assert_array_equal(part.rotations, knocking.rotations[60:151])
    np.testing.assert_array_equal(part.root_positions, knocking.root_positions[60:151])


def test_a_part_of_a_cycle_is_no_cycle(cycle):
    assert not cut(cycle, 0.0, 0.5).cyclic
    assert cut(cycle, 0.0, cycle.duration).cyclic


@pytest.mark.parametrize("span", [(-0.1, 1.0), (1.0, 1.0), (2.0, 1.0), (0.0, 99.0), (1.0, 1.001)])
def test_what_cannot_be_cut_out_is_refused(knocking, span):
    with pytest.raises(MotionError, match=r"cut out|one frame"):
        cut(knocking, *span)


@pytest.mark.parametrize("number", [0.0, -1.0, float("nan"), float("inf")])
def test_impossible_tempos_and_rates_are_refused(knocking, number):
    with pytest.raises(MotionError, match="tempo"):
        change_tempo(knocking, number)
    with pytest.raises(MotionError, match="frame rate"):
        resample_rate(knocking, number)
