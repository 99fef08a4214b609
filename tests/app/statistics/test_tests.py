import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from app.statistics.tests import holm, paired, welch

# Hours of sleep gained with two drugs by ten patients (Student 1908), R's dataset `sleep`.
DRUG_1 = [0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0]
DRUG_2 = [1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4]


def with_moments(n, mean, sd):
    x = np.linspace(-1, 1, n)
    return mean + sd * (x - x.mean()) / x.std(ddof=1)


def test_welch_gives_the_values_published_by_nist():
    # NIST/SEMATECH e-Handbook 1.3.5.3, miles per gallon of US and Japanese cars, unequal variances.
    found = welch(with_moments(249, 20.14458, 6.41470), with_moments(79, 30.48101, 6.10771))
    assert found.t == pytest.approx(-12.94627, abs=1e-4)
    assert found.df == pytest.approx(136.8750, abs=1e-3)


def test_welch_gives_the_values_published_for_students_sleep_data():
    # R manual, ?t.test: t = -1.8608, df = 17.776, p-value = 0.07939.
    found = welch(DRUG_1, DRUG_2)
    assert found.t == pytest.approx(-1.8608, abs=5e-5)
    assert found.df == pytest.approx(17.776, abs=5e-4)
    assert found.p == pytest.approx(0.07939, abs=5e-6)
    assert found.difference == pytest.approx(-1.58)


def test_the_paired_test_gives_the_values_published_for_students_sleep_data():
    # R manual, ?t.test with paired data: t = -4.0621, df = 9, p-value = 0.002833.
    found = paired(DRUG_1, DRUG_2)
    assert found.t == pytest.approx(-4.0621, abs=5e-5)
    assert found.df == 9
    assert found.p == pytest.approx(0.002833, abs=5e-7)


samples = st.lists(st.integers(-2, 2), min_size=2, max_size=30).filter(lambda x: len(set(x)) > 1)


@given(samples, samples)
def test_welch_is_scipys(a, b):
    found, expected = welch(a, b), stats.ttest_ind(a, b, equal_var=False)
    assert (found.t, found.df) == pytest.approx((expected.statistic, expected.df), abs=1e-12)
    assert found.p == pytest.approx(expected.pvalue)


@given(st.lists(st.tuples(st.floats(-2, 2), st.floats(-2, 2)), min_size=3, max_size=30))
def test_the_paired_test_is_scipys(pairs):
    a, b = np.array(pairs).T
    if np.ptp(a - b) < 1e-3:
        return  # SciPy warns of differences that are nearly equal
    found, expected = paired(a, b), stats.ttest_rel(a, b)
    assert (found.t, found.df) == pytest.approx((expected.statistic, expected.df), abs=1e-9)
    assert found.p == pytest.approx(expected.pvalue)


def test_one_group_without_spread_still_gives_a_test():
    found = welch([2, 2, 2], [0, 1, 2, 1])
    assert found.df == pytest.approx(3)
    assert found.t == pytest.approx(1 / np.sqrt(2 / 3 / 4))


def test_pairs_with_a_missing_half_are_left_out():
    nan = float("nan")
    assert paired([nan, *DRUG_1, 3.0], [1.0, *DRUG_2, nan]) == paired(DRUG_1, DRUG_2)


def test_missing_answers_are_left_out_of_either_group():
    nan = float("nan")
    assert welch([nan, *DRUG_1], [*DRUG_2, nan]) == welch(DRUG_1, DRUG_2)


@pytest.mark.parametrize(("a", "b"), [([1], [1, 2]), ([], []), ([1, 1], [2, 2])])
def test_welch_is_undefined_without_two_values_or_without_spread(a, b):
    assert welch(a, b) is None


@pytest.mark.parametrize(("a", "b"), [([1], [2]), ([1, 2, 3], [0, 1, 2])])
def test_the_paired_test_is_undefined_for_one_pair_or_equal_differences(a, b):
    assert paired(a, b) is None


def test_holm_gives_the_worked_example():
    # p.adjust(c(.01, .04, .03, .005), "holm") in R.
    assert holm([0.01, 0.04, 0.03, 0.005]) == pytest.approx([0.03, 0.06, 0.06, 0.02])


def test_a_test_that_was_not_made_does_not_count():
    assert holm([0.01, None, 0.04]) == [0.02, None, 0.04]
    assert holm([None, None]) == [None, None]


@given(st.lists(st.floats(0, 1), min_size=1, max_size=15))
def test_holms_adjustment_keeps_order_and_lies_between_none_and_bonferronis(p):
    adjusted = holm(p)
    ranks = np.argsort(p, kind="stable")
    assert (np.diff(np.array(adjusted)[ranks]) >= 0).all()
    for before, after in zip(p, adjusted, strict=True):
        assert before <= after <= min(1.0, before * len(p)) or after == pytest.approx(
            before * len(p)
        )


def test_holm_rejects_what_the_step_down_procedure_rejects():
    # An independent statement: go up the sorted p, stop at the first p > alpha / (tests left).
    p = stats.uniform.rvs(size=200, random_state=7).reshape(20, 10) ** 3
    for row in p:
        limits = 0.05 / np.arange(10, 0, -1)
        passed = np.sort(row) <= limits
        count = 10 if passed.all() else int(np.argmin(passed))
        assert sum(q <= 0.05 for q in holm(list(row))) == count
