"""Tests of differences between means, and the price of making many of them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy import special

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
    of_x, of_y = x.var(ddof=1) / x.size, y.var(ddof=1) / y.size
    # The degrees of freedom of Welch (1947) and Satterthwaite (1946).
    df = (of_x + of_y) ** 2 / (of_x**2 / (x.size - 1) + of_y**2 / (y.size - 1))
    return _two_sided(float(x.mean() - y.mean()), float(np.sqrt(of_x + of_y)), float(df))


def paired(a: ArrayLike, b: ArrayLike) -> TTest | None:
    """Paired t-test of a[i] against b[i]; pairs with a missing half (NaN) are left out.

    Returns:
        None below two pairs, or where all the differences are equal: t is undefined.
    """
    differences = present(np.asarray(a, dtype=np.float64) - np.asarray(b, dtype=np.float64))
    if differences.size < 2 or np.ptp(differences) < 1e-12:
        return None
    error = float(differences.std(ddof=1) / np.sqrt(differences.size))
    return _two_sided(float(differences.mean()), error, float(differences.size - 1))


def _two_sided(difference: float, error: float, df: float) -> TTest:
    # Not by SciPy's own tests: they warn of every group whose answers are all the same.
    t = difference / error
    return TTest(t=t, df=df, p=float(2 * special.stdtr(df, -abs(t))), difference=difference)


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
