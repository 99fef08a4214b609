import numpy as np
import pytest

from app.statistics.latent_raters import (
    LEAST_PEAK,
    MOST_SPREAD,
    NEUTRAL_LOAD,
    PAPER_NOISE,
    REACH,
    TASTE,
    draw_pairs,
    recover,
    shuffle_answers,
    shuffle_clips,
    simulate,
)
from app.statistics.quantification import kept, quantify

FACTORS = np.array([0] * 3 + [1] * 10 + [2] * 9 + [3] * 5 + [-1] * 14)
LATENT = np.random.default_rng(4).uniform(-1, 1, (12, 4))


def answered(seed=0, noise=PAPER_NOISE, participants=14):
    generator = np.random.default_rng(seed)
    return simulate(LATENT, draw_pairs(FACTORS, generator), participants, generator, noise)


def test_the_papers_noise_spreads_answers_as_much_as_is_just_kept():
    # One pair without opinion, so that neither end of the scale is near: the spread is the
    # threshold, which 4000 raters tell to the second decimal.
    generator = np.random.default_rng(1)
    pairs = draw_pairs(np.array([0, 0]), generator)
    ratings = simulate(np.zeros((1, 1)), pairs, 4000, generator, PAPER_NOISE)
    assert quantify(ratings).mean_spread == pytest.approx(MOST_SPREAD, abs=0.025)


def test_of_the_pairs_to_be_dropped_half_say_little_and_half_divide_people():
    pairs = draw_pairs(FACTORS, np.random.default_rng(2))
    listed = FACTORS >= 0
    assert (pairs.factor[listed] == FACTORS[listed]).all()
    assert (pairs.taste[listed] == 0).all()
    assert (REACH * pairs.load[listed] > LEAST_PEAK).all()
    neutral = ~listed & (pairs.load == NEUTRAL_LOAD)
    assert neutral.sum() == 7
    assert (pairs.taste[~listed & ~neutral] == TASTE).all()
    assert NEUTRAL_LOAD * REACH < LEAST_PEAK
    assert TASTE > MOST_SPREAD


def test_both_reasons_of_the_paper_occur():
    ratings = answered(noise=0.1)
    found = quantify(ratings)
    dropped = FACTORS < 0
    assert (found.peak[dropped] < LEAST_PEAK).sum() >= 7
    assert (found.mean_spread[dropped] > MOST_SPREAD).sum() == 7
    assert (kept(found) == ~dropped).all()


def test_answers_are_steps_of_the_scale():
    assert set(np.unique(answered())) <= {-2, -1, 0, 1, 2}


def test_shuffled_answers_are_the_same_answers_of_each_pair():
    ratings = answered()
    found = shuffle_answers(ratings, np.random.default_rng(3))
    for pair in range(ratings.shape[2]):
        assert sorted(found[..., pair].ravel()) == sorted(ratings[..., pair].ravel())
    assert quantify(found).peak.max() < quantify(ratings).peak.max()


def test_shuffled_clips_keep_the_same_pairs():
    ratings = answered()
    found = shuffle_clips(ratings, np.random.default_rng(3))
    before, after = quantify(ratings), quantify(found)
    np.testing.assert_allclose(after.peak, before.peak)
    np.testing.assert_allclose(after.mean_spread, before.mean_spread)
    np.testing.assert_allclose(np.sort(after.mean, axis=0), np.sort(before.mean, axis=0))
    assert (after.mean != before.mean).any(axis=0).all()


def test_each_raters_answers_to_a_clip_stay_together_when_clips_are_shuffled():
    ratings = np.arange(24.0).reshape(2, 4, 3)  # the second rater's are 12 more
    found = shuffle_clips(ratings, np.random.default_rng(3))
    assert (found[1] - found[0] == 12).all()


def test_a_recovery_tells_what_was_kept_what_was_dropped_and_how_clusters_agree():
    ratings = np.zeros((3, 4, 4))
    ratings[:, :2, 0] = ratings[:, 2:, 1] = 2
    ratings[:, :2, 2] = 1
    factors = np.array([0, 1, -1, 0])
    found = recover(ratings, factors)
    assert found.kept == pytest.approx(2 / 3)
    assert found.dropped == 0
    assert found.rand == 1
    assert not found.exact


def test_fewer_kept_pairs_than_clusters_have_no_clusters():
    found = recover(np.zeros((3, 4, 4)), np.array([0, 1, -1, 0]))
    assert np.isnan(found.rand)
    assert (found.kept, found.dropped, found.exact) == (0, 1, False)
