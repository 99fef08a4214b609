import numpy as np
import pytest
from scipy import stats

from app.statistics.quantification import impressions, kept, quantify

NAN = np.nan


def rated(*columns):
    """Ratings (participants, 1 clip, pairs) from each pair's answers."""
    return np.array(columns, dtype=float).T[:, None, :]


def test_means_and_sample_spreads_are_scipys():
    ratings = np.random.default_rng(1).integers(-2, 3, (14, 10, 41)).astype(float)
    ratings[np.random.default_rng(2).random(ratings.shape) < 0.2] = NAN
    found = quantify(ratings)
    np.testing.assert_allclose(found.mean, stats.tmean(ratings, axis=0, nan_policy="omit"))
    np.testing.assert_allclose(found.spread, stats.tstd(ratings, axis=0, nan_policy="omit"))
    np.testing.assert_allclose(found.peak, np.abs(found.mean).max(axis=0))
    np.testing.assert_allclose(found.mean_spread, found.spread.mean(axis=0))
    assert (found.counts == (~np.isnan(ratings)).sum(axis=0)).all()


def test_a_pair_that_meets_a_threshold_exactly_stays():
    ratings = rated([1, 1, 1, 1], [2, 0, 2, 0], [1, 1, 1, 0])
    found = quantify(ratings)
    assert found.peak.tolist() == [1, 1, 0.75]
    spread = found.mean_spread[1]
    assert kept(found, 1.0, spread).tolist() == [True, True, False]
    assert kept(found, 1.0, np.nextafter(spread, 0)).tolist() == [True, False, False]
    assert kept(found, np.nextafter(1.0, 2), spread).tolist() == [False, False, False]


def test_the_papers_thresholds_are_the_default():
    found = quantify(rated([1, 1, 1, 1], [2, 0, 2, 0], [1, 1, 1, 0]))
    assert kept(found).tolist() == kept(found, 1.0, 0.85).tolist() == [True, False, False]


def test_the_strongest_clip_counts_toward_either_pole():
    ratings = np.array([[[0.0], [-2.0], [1.0]], [[0.0], [-1.0], [1.0]]])
    assert quantify(ratings).peak.tolist() == [1.5]


def test_one_answer_has_no_spread_and_is_left_out_of_the_mean_spread():
    ratings = np.array([[[2.0], [1.0]], [[0.0], [NAN]]])
    found = quantify(ratings)
    assert np.isnan(found.spread[1, 0])
    assert found.mean_spread[0] == pytest.approx(np.sqrt(2))


def test_with_one_participant_no_pair_is_dropped_for_its_spread():
    found = quantify(rated([2], [0]))
    assert np.isnan(found.mean_spread).all()
    assert kept(found).tolist() == [True, False]


def test_a_pair_that_nobody_rated_is_dropped():
    found = quantify(rated([2, 2], [NAN, NAN]))
    assert np.isnan(found.peak[1])
    assert kept(found).tolist() == [True, False]


def test_without_participants_nothing_is_known():
    found = quantify(np.empty((0, 3, 2)))
    assert np.isnan(found.mean).all()
    assert not kept(found).any()


def test_impressions_go_from_the_left_pole_to_the_right_one():
    ratings = np.array([[[-2.0, 1.0, 0.0], [2.0, 0.0, 0.0]]])
    found = impressions(quantify(ratings), np.array([True, True, False]))
    assert found.tolist() == [[0, 0.75], [1, 0.5]]


def test_the_columns_of_impressions_stand_in_the_order_asked_for():
    ratings = np.array([[[-3.0, 3.0, 0.0]]])
    assert impressions(quantify(ratings), np.array([2, 0]), reach=3.0).tolist() == [[0.5, 0]]
