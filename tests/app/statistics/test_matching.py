"""Numbers of a matching experiment: against SciPy, against counting by hand, with gaps."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from app.statistics.matching import lasting, of_target, pairwise, signed_rank


@pytest.mark.parametrize("n", [5, 20, 50, 51, 200])
def test_without_ties_and_zeros_it_is_scipys_test(n: int) -> None:
    rng = np.random.default_rng(n)
    one, other = rng.normal(0.3, 1, n), rng.normal(0, 1, n)
    found = signed_rank(one, other)
    wanted = stats.wilcoxon(one, other)
    assert found is not None
    assert (found.statistic, found.p) == pytest.approx((wanted.statistic, wanted.pvalue), abs=1e-12)
    assert (found.n, found.zeros, found.exact) == (n, 0, n <= 50)


def test_with_ties_and_zeros_it_is_scipys_normal_approximation_without_the_zeros() -> None:
    rng = np.random.default_rng(4)
    differences = rng.integers(-3, 5, 40).astype(float)
    found = signed_rank(differences, np.zeros(40))
    kept = differences[differences != 0]
    wanted = stats.wilcoxon(kept, zero_method="wilcox", correction=False, method="asymptotic")
    assert found is not None
    assert not found.exact
    assert (found.n, found.zeros) == (kept.size, 40 - kept.size)
    assert (found.statistic, found.p) == pytest.approx((wanted.statistic, wanted.pvalue), abs=1e-12)


def test_a_missing_half_leaves_its_pair_out_and_order_changes_nothing() -> None:
    one = np.array([1.0, 4.0, np.nan, 2.0, 7.5])
    other = np.array([0.5, 5.0, 3.0, np.nan, 2.5])
    found, swapped = signed_rank(one, other), signed_rank(other, one)
    assert found == swapped
    assert found is not None
    assert found.n == 3


def test_nothing_that_differs_is_no_test() -> None:
    assert signed_rank([1.0, 2.0], [1.0, 2.0]) is None
    assert signed_rank([], []) is None


def test_a_failure_counts_the_whole_time_and_no_more() -> None:
    seconds = np.array([[10.0, 290.0, 340.0, np.nan]])
    solved = np.array([[1.0, 0.0, 0.0, np.nan]])
    assert lasting(seconds, solved, 300.0)[0, :3].tolist() == [10.0, 300.0, 300.0]
    assert np.isnan(lasting(seconds, solved, 300.0)[0, 3])


def test_the_figures_numbers_are_what_one_counts_by_hand() -> None:
    # Three participants, one target; bare weights and adjectives.
    guess = np.array([[[0.10, 0.05]], [[0.20, 0.07]], [[0.06, np.nan]]])
    seconds = np.array([[[100.0, 40.0]], [[299.0, 80.0]], [[120.0, 60.0]]])
    solved = np.array([[[1.0, 1.0]], [[0.0, 1.0]], [[1.0, 1.0]]])
    found = of_target(guess, seconds, solved, threshold=0.06, limit=300.0, reference=0)
    assert [one.mean for one in found.guess] == pytest.approx([0.12, 0.06])
    assert found.guess[0].sd == pytest.approx(np.std([0.10, 0.20, 0.06], ddof=1))
    assert [(one.share, one.n) for one in found.guessed] == [(0.0, 3), (0.5, 2)]
    assert [one.mean for one in found.seconds] == pytest.approx([520 / 3, 60.0])
    assert [one.share for one in found.failed] == pytest.approx([1 / 3, 0.0])
    assert found.saved[0] is None
    saved = np.array([60.0, 220.0, 60.0])
    low, high = stats.t.interval(0.9, 2, saved.mean(), stats.sem(saved))
    assert (found.saved[1].mean, found.saved[1].low, found.saved[1].high) == pytest.approx(
        (saved.mean(), low, high)
    )


def test_every_two_interfaces_are_compared_by_participant_and_target() -> None:
    rng = np.random.default_rng(2)
    guess, seconds = rng.random((13, 5, 3)), 300 * rng.random((13, 5, 3))
    solved = (rng.random((13, 5, 3)) > 0.2).astype(float)
    found = pairwise(guess, seconds, solved, limit=300.0)
    assert [(one.one, one.other) for one in found] == [(0, 1), (0, 2), (1, 2)]
    wanted = stats.wilcoxon(guess[..., 0].ravel(), guess[..., 2].ravel(), method="asymptotic",
                            correction=False)  # fmt: skip
    assert found[1].guess.p == pytest.approx(wanted.pvalue, abs=1e-12)
    assert found[1].guess.n == 65
