"""Tests of differences between means, and the price of making many of them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy import stats

from app.statistics.intervals import present


@dataclass(frozen=True)
class TTest:
    """A two-sided t-test: `difference` is the first mean less the second."""

    t: float
    df: float
    p: float
    difference: float


def welch(a: ArrayLike, b: ArrayLike) -> TTest | None:
    """Welch's test of two independent groups, which need not have the same variance.

    Args:
        a: first group, any shape; NaN means missing.
        b: second group, likewise.

    Returns:
        None where a group has fewer than two values or neither has any spread: t is undefined.
    """
    x, y = present(a), present(b)
    if min(x.size, y.size) < 2 or (np.ptp(x) == 0 and np.ptp(y) == 0):
        return None
    found = stats.ttest_ind(x, y, equal_var=False)
    return TTest(
        t=float(found.statistic),
        df=float(found.df),
        p=float(found.pvalue),
        difference=float(x.mean() - y.mean()),
    )


def paired(a: ArrayLike, b: ArrayLike) -> TTest | None:
    """Paired t-test of a[i] against b[i]; pairs with a missing half (NaN) are left out.

    Returns:
        None below two pairs, or where all the differences are equal: t is undefined.
    """
    differences = present(np.asarray(a, dtype=np.float64) - np.asarray(b, dtype=np.float64))
    if differences.size < 2 or np.ptp(differences) < 1e-12:
        return None
    found = stats.ttest_1samp(differences, 0.0)
    return TTest(
        t=float(found.statistic),
        df=float(found.df),
        p=float(found.pvalue),
        difference=float(differences.mean()),
    )


def holm(p_values: Sequence[float | None]) -> list[float | None]:
    """P-values adjusted for their number by Holm's step-down method (Holm 1979).

    A test that could not be made (None) stays None and does not count as a test.
    """
    made = sorted((p, index) for index, p in enumerate(p_values) if p is not None)
    adjusted: list[float | None] = [None] * len(p_values)
    highest = 0.0
    for rank, (p, index) in enumerate(made):
        highest = max(highest, min(1.0, (len(made) - rank) * p))
        adjusted[index] = highest
    return adjusted
