"""How well targets were matched, by interface: the numbers of Oshita et al., section 6.2.

Arrays are (participants, targets, interfaces); NaN where somebody has no such answer. A target that
was not matched in time counts with the whole time, as in the paper.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.statistics.intervals import (
    MeanInterval,
    Proportion,
    mean_interval,
    present,
    wilson,
)

Samples = NDArray[np.float64]

OF_DIFFERENCES = 0.90  # the paper's interval in figure 10
EXACT_UP_TO = 50  # pairs, as SciPy has it


@dataclass(frozen=True)
class SignedRank:
    """Wilcoxon's signed-rank test of paired differences, two-sided.

    Attributes:
        statistic: the smaller of the two rank sums.
        n: pairs that differ; zeros: pairs that do not, which are left out (Wilcoxon 1945).
        exact: whether p is exact: at most 50 pairs, no tied differences, no zeros. Otherwise it is
            by the normal distribution, its variance corrected for ties, without continuity
            correction.
    """

    statistic: float
    p: float
    n: int
    zeros: int
    exact: bool


@dataclass(frozen=True)
class Spread:
    """A mean with the sample standard deviation; None for a deviation of one value."""

    mean: float
    sd: float | None
    n: int


@dataclass(frozen=True)
class OfTarget:
    """One target, or all of them; lists have one entry for each interface.

    Attributes:
        guess: distance of the first guess from the target, metres (figure 7).
        guessed: share of guesses that were near enough (figure 8).
        seconds: time to match (figure 9).
        failed: share that was not matched in time (figure 11).
        saved: seconds saved against the reference interface, with the 90 % interval of the mean
            (figure 10); None for the reference itself.
    """

    guess: list[Spread | None]
    guessed: list[Proportion | None]
    seconds: list[Spread | None]
    failed: list[Proportion | None]
    saved: list[MeanInterval | None]


@dataclass(frozen=True)
class Pairwise:
    """Two interfaces compared, paired by participant and target; differences are one − other."""

    one: int
    other: int
    guess: SignedRank | None
    seconds: SignedRank | None


def signed_rank(one: ArrayLike, other: ArrayLike) -> SignedRank | None:
    """Wilcoxon's test of one[i] against other[i]; pairs with a missing half are left out.

    Returns:
        None where no pair differs: there is nothing to rank.
    """
    from scipy import stats  # takes a second to import, and few pages need it

    differences = present(np.asarray(one, dtype=float) - np.asarray(other, dtype=float))
    ranked = differences[differences != 0]
    if not ranked.size:
        return None
    zeros = int(differences.size - ranked.size)
    ties = np.unique(np.abs(ranked)).size < ranked.size
    exact = ranked.size <= EXACT_UP_TO and not ties and not zeros
    method: Literal["exact", "approx"] = "exact" if exact else "approx"
    found = stats.wilcoxon(ranked, method=method, correction=False)
    return SignedRank(float(found.statistic), float(found.pvalue), int(ranked.size), zeros, exact)


def of_target(
    guess: Samples,
    seconds: Samples,
    solved: Samples,
    *,
    threshold: float,
    limit: float,
    reference: int | None,
) -> OfTarget:
    """The numbers of some targets together.

    Args:
        guess: (…, interfaces) distance of the first guess, metres.
        seconds: (…, interfaces) time to match.
        solved: (…, interfaces) 1 where the target was matched in time, else 0.
        threshold: metres, below which a guess is near enough.
        limit: seconds that a failure counts.
        reference: index of the interface that times are compared with; None for no comparison.
    """
    each = range(guess.shape[-1])
    time = lasting(seconds, solved, limit)
    return OfTarget(
        guess=[_spread(guess[..., i]) for i in each],
        guessed=[
            _share(np.where(np.isnan(guess), np.nan, guess < threshold)[..., i]) for i in each
        ],
        seconds=[_spread(time[..., i]) for i in each],
        failed=[_share(1.0 - solved[..., i]) for i in each],
        saved=[
            None
            if reference is None or i == reference
            else mean_interval(time[..., reference] - time[..., i], OF_DIFFERENCES)
            for i in each
        ],
    )


def pairwise(guess: Samples, seconds: Samples, solved: Samples, *, limit: float) -> list[Pairwise]:
    """Every two interfaces compared; arguments as in `of_target`."""
    time = lasting(seconds, solved, limit)
    return [
        Pairwise(
            one,
            other,
            signed_rank(guess[..., one].ravel(), guess[..., other].ravel()),
            signed_rank(time[..., one].ravel(), time[..., other].ravel()),
        )
        for one, other in combinations(range(guess.shape[-1]), 2)
    ]


def lasting(seconds: Samples, solved: Samples, limit: float) -> Samples:
    """Times in which a failure counts the whole limit, and nothing more."""
    return np.where(solved == 0, limit, np.minimum(seconds, limit))


def _spread(values: Samples) -> Spread | None:
    known = present(values)
    if not known.size:
        return None
    sd = float(known.std(ddof=1)) if known.size > 1 else None
    return Spread(float(known.mean()), sd, int(known.size))


def _share(flags: Samples) -> Proportion | None:
    known = present(flags)
    return wilson(int(known.sum()), int(known.size))
