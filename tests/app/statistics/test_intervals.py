import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from app.statistics.intervals import cohens_d, mean_interval


def with_moments(n, mean, sd):
    """n values with exactly this mean and sample standard deviation."""
    x = np.linspace(-1, 1, n)
    return mean + sd * (x - x.mean()) / x.std(ddof=1)


samples = st.lists(st.integers(-2, 2), min_size=2, max_size=40).filter(lambda x: len(set(x)) > 1)


def test_bodenheimers_published_interval_comes_out():
    # Bodenheimer, Shleyfman & Hodgins: n = 50, mean 3.32, SD 2.11.
    found = mean_interval(with_moments(50, 3.32, 2.11))
    assert (found.low, found.high) == (
        pytest.approx(2.720, abs=5e-4),
        pytest.approx(3.920, abs=5e-4),
    )


@given(samples, st.sampled_from([0.5, 0.9, 0.95, 0.99]))
def test_a_mean_interval_is_scipys(values, confidence):
    found = mean_interval(values, confidence)
    low, high = stats.ttest_1samp(values, 0).confidence_interval(confidence)
    assert (found.low, found.high) == (pytest.approx(low), pytest.approx(high))
    assert found.n == len(values)


def test_missing_answers_are_left_out_and_one_answer_gives_no_interval():
    assert mean_interval([1.0, np.nan, 2.0, np.nan]) == mean_interval([1.0, 2.0])
    assert mean_interval([1.0, np.nan]) is None
    assert mean_interval([]) is None


def test_equal_answers_give_an_interval_without_width():
    found = mean_interval([2, 2, 2])
    assert (found.low, found.mean, found.high) == (2, 2, 2)


@given(samples, samples)
def test_at_the_ends_of_the_effects_interval_the_measured_t_is_the_outer_tail(a, b):
    found = cohens_d(a, b)
    scale = np.sqrt(len(a) * len(b) / (len(a) + len(b)))
    student = stats.ttest_ind(a, b)
    df = len(a) + len(b) - 2
    assert found.d * scale == pytest.approx(student.statistic, abs=1e-9)
    assert stats.nct.sf(student.statistic, df, found.low * scale) == pytest.approx(0.025, abs=1e-6)
    assert stats.nct.cdf(student.statistic, df, found.high * scale) == pytest.approx(
        0.025, abs=1e-6
    )


@given(samples, samples)
def test_the_effect_turns_round_when_the_groups_are_swapped(a, b):
    one, other = cohens_d(a, b), cohens_d(b, a)
    assert (one.d, one.low, one.high) == pytest.approx(
        (-other.d, -other.high, -other.low), abs=1e-6
    )


def test_an_effect_without_spread_or_with_one_answer_is_undefined():
    assert cohens_d([1, 1, 1], [2, 2]) is None
    assert cohens_d([1], [2, 3]) is None
