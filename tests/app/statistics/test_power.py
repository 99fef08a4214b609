"""Power by simulation against the exact power of the t-test, from the noncentral t."""

import math

import numpy as np
import pytest
from scipy import stats

from app.statistics.power import about_zero, found_in, power, two_sided


def paired_power(d, n, alpha=0.05):
    """Of a two-sided one-sample t-test for a standardised mean d."""
    critical, away = stats.t.ppf(1 - alpha / 2, n - 1), d * math.sqrt(n)
    return stats.nct.sf(critical, n - 1, away) + stats.nct.cdf(-critical, n - 1, away)


def between_power(d, n, alpha=0.05):
    """Of a two-sided t-test of two groups of n."""
    critical, away = stats.t.ppf(1 - alpha / 2, 2 * n - 2), d * math.sqrt(n / 2)
    return stats.nct.sf(critical, 2 * n - 2, away) + stats.nct.cdf(-critical, 2 * n - 2, away)


@pytest.mark.parametrize(("difference", "n"), [(0.3, 20), (0.6, 28), (0.5, 10), (0.0, 15)])
def test_without_steps_and_ends_it_is_the_t_tests_exact_power(difference, n):
    found = power(
        difference, n, np.random.default_rng(1), noise=0.8, rater_sd=2.0, step=None, runs=4000
    )
    expected = paired_power(difference / (0.8 * math.sqrt(2)), n)
    assert found.share == pytest.approx(expected, abs=4 * math.sqrt(0.25 / 4000))
    assert found.runs == 4000


@pytest.mark.parametrize(("difference", "n"), [(0.5, 30), (1.0, 12)])
def test_between_groups_the_raters_biases_are_noise_as_well(difference, n):
    found = power(
        difference, n, np.random.default_rng(2),
        noise=0.6, rater_sd=0.8, step=None, between=True, runs=4000,
    )  # fmt: skip
    assert found.share == pytest.approx(between_power(difference, n), abs=0.035)


def test_rounding_to_steps_adds_its_variance_of_a_twelfth():
    found = power(0.5, 25, np.random.default_rng(3), noise=0.9, runs=4000)
    expected = paired_power(0.5 / math.sqrt(2 * (0.81 + 1 / 12)), 25)
    assert found.share == pytest.approx(expected, abs=0.035)


def test_a_scales_ends_take_power_away():
    kind = {"noise": 0.8, "rater_sd": 0.0, "runs": 2000, "step": None}
    free = power(1.5, 8, np.random.default_rng(4), **kind)
    ended = power(1.5, 8, np.random.default_rng(4), lowest=-0.5, highest=0.5, **kind)
    assert ended.share < free.share


def test_without_any_spread_nothing_is_found():
    found = power(0.0, 10, np.random.default_rng(5), noise=0.0, lowest=-2, highest=2, runs=50)
    assert (found.share, found.low) == (0, 0)


def test_the_interval_is_of_the_runs():
    found = found_in([True] * 91 + [False] * 9)
    expected = stats.binomtest(91, 100).proportion_ci(method="wilson")
    assert (found.low, found.high) == (pytest.approx(expected.low), pytest.approx(expected.high))
    with pytest.raises(ValueError, match="at least one run"):
        found_in([])


def test_the_tests_are_scipys():
    generator = np.random.default_rng(6)
    a, b = generator.normal(0.3, 1, (5, 12)), generator.normal(0, 2, (5, 9))
    assert about_zero(a) == pytest.approx(stats.ttest_1samp(a, 0, axis=1).pvalue)
    assert two_sided(a, b) == pytest.approx(stats.ttest_ind(a, b, axis=1, equal_var=False).pvalue)
    a[0, 3:] = np.nan
    assert about_zero(a)[0] == pytest.approx(stats.ttest_1samp(a[0, :3], 0).pvalue)
