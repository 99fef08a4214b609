"""Longer and shorter paths by multiresolution filtering."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion import MotionError
from motion.editing.path_length import PathLength, band_centres, change_path_length, scale_bands
from motion.rotations import angle_between, from_axis_angle, multiply, to_directions
from tests.motion.editing.measures import bone_lengths, hands_path


def noise(frames: int, seed: int = 0, channels: int = 3) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=(frames, channels))


@given(st.integers(2, 400), st.booleans(), st.integers(0, 99))
def test_gains_of_one_return_the_signal(frames, cyclic, seed):
    signal = noise(frames, seed)
    same = scale_bands(signal, lambda hertz: np.ones_like(hertz), 100.0, cyclic=cyclic)
    np.testing.assert_allclose(same, signal, atol=1e-12)


@given(st.integers(8, 300), st.floats(0, 3), st.floats(0, 3), st.booleans())
def test_filtering_is_linear_in_the_gains(frames, low, high, cyclic):
    signal = noise(frames)
    gains = [lambda hertz, gain=gain: np.full_like(hertz, gain) for gain in (low, high)]
    a, b = (scale_bands(signal, gain, 60.0, cyclic=cyclic) for gain in gains)
    middle = scale_bands(
        signal, lambda hertz: np.full_like(hertz, (low + high) / 2), 60.0, cyclic=cyclic
    )
    np.testing.assert_allclose(middle, (a + b) / 2, atol=1e-9)


def test_the_bands_sum_as_the_paper_writes_them():
    """G(n) + Σ gain·L(k), each level's kernel spread out with zeros and convolved by NumPy."""
    frames, rate, gain = 64, 100.0, 1.7
    signal = noise(frames, channels=1)
    padded = np.pad(signal[:, 0], (frames // 2, frames // 2), mode="edge")
    low, bands = padded, []
    for level in range(6):  # 2^6 ≤ 64 ≤ 2^7
        kernel = np.zeros(4 * 2**level + 1)
        kernel[:: 2**level] = [1 / 16, 1 / 4, 3 / 8, 1 / 4, 1 / 16]
        reach = len(kernel) // 2
        lower = np.convolve(np.pad(low, reach, mode="edge"), kernel, mode="valid")
        bands.append(low - lower)
        low = lower
    expected = (low + gain * np.sum(bands, axis=0))[frames // 2 : frames // 2 + frames]
    ours = scale_bands(signal, lambda hertz: np.full_like(hertz, gain), rate)
    np.testing.assert_allclose(ours[:, 0], expected, atol=1e-12)


def test_a_cyclic_signal_knows_no_first_frame():
    signal = noise(60)
    gains = PathLength(1.5)
    turned = scale_bands(np.roll(signal, 17, axis=0), gains, 60.0, cyclic=True)
    np.testing.assert_allclose(
        turned, np.roll(scale_bands(signal, gains, 60.0, cyclic=True), 17, 0), atol=1e-12
    )


def test_nothing_shifts_in_phase():
    signal = noise(200)
    gains = PathLength(1.6)
    backwards = scale_bands(signal[::-1], gains, 60.0)[::-1]
    np.testing.assert_allclose(backwards, scale_bands(signal, gains, 60.0), atol=1e-12)


def test_a_band_s_centre_does_not_depend_on_the_frame_rate():
    slow, fast = band_centres(300, 30.0), band_centres(1200, 120.0)
    np.testing.assert_allclose(fast[2:], slow)


def test_an_edit_tones_high_frequencies_down_and_leaves_low_ones():
    gains = PathLength(1.4)(np.array([0.1, 0.35, 0.6, 5.0, 10.0, 16.0, 60.0]))
    np.testing.assert_allclose(gains, [1, 1, 1.4, 1.4, 1.4, 0.25, 0.25])


@pytest.mark.motions
def test_hands_go_a_longer_or_a_shorter_way(walk):
    before = hands_path(walk)
    assert hands_path(change_path_length(walk, PathLength(1.4))) >= 1.2 * before
    assert hands_path(change_path_length(walk, PathLength(0.5))) <= 0.7 * before


@pytest.mark.motions
def test_bones_keep_their_lengths(walk):
    longer = bone_lengths(change_path_length(walk, PathLength(1.6)))
    np.testing.assert_allclose(longer, bone_lengths(walk), atol=1e-9)


def test_a_cycle_stays_seamless(samples):
    clip = change_path_length(samples["set_a_proud"], PathLength(1.6))
    np.testing.assert_allclose(clip.rotations[0], clip.rotations[-1], atol=1e-12)


@pytest.mark.parametrize("representation", ["directions", "quaternions", "angles"])
def test_gains_of_one_return_the_clip_in_any_representation(samples, representation):
    clip = samples["acted_female_neutral"]
    same = change_path_length(clip, PathLength(1.0), representation)
    directions = [to_directions(each.rotations) for each in (same, clip)]
    np.testing.assert_allclose(*directions, atol=1e-12)


@pytest.fixture
def turning(samples):
    """A walker who, meanwhile, turns round on the spot 1.5 times in the whole clip."""
    clip = samples["acted_female_neutral"]
    angle = np.linspace(0.0, 3.0 * np.pi, clip.frames)
    turn = from_axis_angle(np.array([0.0, 1.0, 0.0]), angle)
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    return replace(clip, rotations=rotations)


def strongest_step(clip):
    """Degrees of any joint from one frame to the next."""
    return np.degrees(angle_between(clip.rotations[1:], clip.rotations[:-1])).max()


def test_angles_flip_where_they_wrap_around_and_directions_do_not(turning):
    """Why directions are filtered: at ±180° an angle jumps, and the filter makes a whirl of it."""
    gain = PathLength(1.6)
    flipped = change_path_length(turning, gain, "angles")
    assert strongest_step(flipped) > 60
    smooth = change_path_length(turning, gain)
    assert strongest_step(smooth) < 2 * strongest_step(turning)


@pytest.mark.motions
def test_real_walks_flip_by_their_angles_only(walk):
    """Recorded upper arms and hips pass the angles' borders."""
    steps = {
        representation: strongest_step(change_path_length(walk, PathLength(1.6), representation))
        for representation in ("directions", "quaternions", "angles")
    }
    assert steps["directions"] <= 2 * strongest_step(walk)
    assert steps["quaternions"] <= 2 * strongest_step(walk)  # once their signs are continuous
    assert steps["angles"] > 2 * strongest_step(walk)


def test_quaternions_do_not_close_a_cycle_that_turns_round(samples):
    """After one turn a joint is back, its quaternion has the other sign: the seam opens."""
    cycle = samples["set_a_proud"]
    turn = from_axis_angle(np.array([0.0, 1.0, 0.0]), np.linspace(0.0, 2.0 * np.pi, cycle.frames))
    rotations = cycle.rotations.copy()
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    round_about = replace(cycle, rotations=rotations)
    quaternions = change_path_length(round_about, PathLength(1.6), "quaternions")
    directions = change_path_length(round_about, PathLength(1.6))
    assert strongest_step(quaternions) > 4 * strongest_step(round_about)
    assert strongest_step(directions) < 2 * strongest_step(round_about)


def test_an_unknown_representation_is_refused(samples):
    with pytest.raises(MotionError, match="directions, quaternions, angles"):
        change_path_length(samples["set_a_proud"], PathLength(1.4), "matrices")
