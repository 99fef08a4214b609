"""How far a mean or an effect may lie from what was measured.

Distributions come from `scipy.special`: `scipy.stats` has the same and takes a second to import,
which every start of the server would wait for.
"""

from dataclasses import dataclass
from math import sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import special

Samples = NDArray[np.float64]


@dataclass(frozen=True)
class MeanInterval:
    """A mean with its two-sided interval; `sd` is the sample standard deviation."""

    mean: float
    low: float
    high: float
    sd: float
    n: int


@dataclass(frozen=True)
class Effect:
    """A standardised difference of means (Cohen's d) with its two-sided interval."""

    d: float
    low: float
    high: float


def present(values: ArrayLike) -> Samples:
    """The values as a flat array without the missing ones (NaN)."""
    flat = np.asarray(values, dtype=np.float64).ravel()
    kept: Samples = flat[~np.isnan(flat)]
    return kept


def mean_interval(values: ArrayLike, confidence: float = 0.95) -> MeanInterval | None:
    """Mean and t-based interval, n - 1 degrees of freedom; None below two values.

    Args:
        values: any shape; NaN means missing and is left out.
        confidence: probability that such intervals hold the true mean, in (0, 1).
    """
    x = present(values)
    if x.size < 2:
        return None
    mean, sd = float(x.mean()), float(x.std(ddof=1))
    reach = float(special.stdtrit(x.size - 1, (1 + confidence) / 2)) * sd / sqrt(x.size)
    return MeanInterval(mean=mean, low=mean - reach, high=mean + reach, sd=sd, n=x.size)


def cohens_d(a: ArrayLike, b: ArrayLike, confidence: float = 0.95) -> Effect | None:
    """Cohen's d of a over b by the pooled standard deviation, with its exact interval.

    The interval holds every noncentrality of Student's t under which the measured t is not
    in either outer tail (Steiger & Fouladi 1997; Cumming & Finch 2001). None where there are
    fewer than two values in a group or no spread at all.
    """
    x, y = present(a), present(b)
    if x.size < 2 or y.size < 2:
        return None
    df = x.size + y.size - 2
    pooled = sqrt(((x.size - 1) * x.var(ddof=1) + (y.size - 1) * y.var(ddof=1)) / df)
    if pooled == 0:
        return None
    d = float(x.mean() - y.mean()) / pooled
    scale = sqrt(x.size * y.size / (x.size + y.size))
    tail = (1 - confidence) / 2
    return Effect(
        d=d,
        low=_noncentrality(d * scale, df, 1 - tail) / scale,
        high=_noncentrality(d * scale, df, tail) / scale,
    )


def _noncentrality(t: float, df: int, probability: float) -> float:
    """The noncentrality under which values up to t have the given probability."""
    # Mirrored to t >= 0: SciPy's noncentral t is most accurate there.
    if t < 0:
        return -_noncentrality(-t, df, 1 - probability)
    reach = 8 * sqrt(1 + t * t / (2 * df))
    low, high = t - reach, t + reach
    for _ in range(60):  # bisection: the probability falls as the noncentrality grows
        middle = (low + high) / 2
        below = float(special.nctdtr(df, middle, t))
        if np.isnan(below):  # SciPy gives up in the far tails, where the answer is 1 or 0
            below = float(middle < t)
        low, high = (middle, high) if below > probability else (low, middle)
    return (low + high) / 2


@dataclass(frozen=True)
class Proportion:
    """A share of `n` cases, in 0 ... 1, with its two-sided interval."""

    share: float
    low: float
    high: float
    n: int


def wilson(successes: int, n: int, confidence: float = 0.95) -> Proportion | None:
    """A share with Wilson's score interval (Wilson 1927); None without a case.

    Unlike the usual interval it stays within 0 ... 1 and holds its promise near the ends.
    """
    if n == 0:
        return None
    share = successes / n
    z = float(special.ndtri((1 + confidence) / 2))
    shrunk = (share + z * z / (2 * n)) / (1 + z * z / n)
    reach = z / (1 + z * z / n) * sqrt(share * (1 - share) / n + (z / (2 * n)) ** 2)
    low = 0.0 if successes == 0 else shrunk - reach  # exactly, and not a rounding error beside it
    high = 1.0 if successes == n else shrunk + reach
    return Proportion(share, low, high, n)
