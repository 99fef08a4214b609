"""How far a solution would be another one with other participants: the bootstrap.

Participants are drawn with replacement, pairs are quantified, kept and clustered anew, and each
solution is compared with the one of all participants. Source of cluster stability: C. Hennig,
Cluster-wise assessment of cluster stability, CSDA 52 (2007).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from app.statistics.agreement import adjusted_rand, contingency
from app.statistics.intervals import Samples, present
from app.statistics.quantification import (
    Chosen,
    kept,
    mean_spreads,
    peaks,
    quantify,
    within,
)
from app.statistics.ward import Labels, cut, ward

DROPPED = -1  # the label of a pair that is not kept
_AT_ONCE = 2_000_000  # means held at once, 16 MB; more samples are taken in turn


class BySize(NamedTuple):
    """What so many participants would give.

    Attributes:
        participants: how many are drawn.
        rand: mean adjusted Rand index with the solution of all.
        low: the middle 95 % of the samples begins here.
        high: and ends here.
        kept_alike: mean share of pairs that are kept, or dropped, as by all participants.
    """

    participants: int
    rand: float
    low: float
    high: float
    kept_alike: float


@dataclass(frozen=True)
class Stability:
    """What stays when the participants are drawn anew.

    Attributes:
        labels: the solution of all participants (pairs,); −1 for dropped pairs.
        kept_share: how often each pair is kept (pairs,).
        together: how often two pairs are in one cluster (pairs, pairs), of the samples that keep
            both; NaN where none does.
        cluster_stability: Hennig's, of each cluster: the mean over the samples of the greatest
            Jaccard similarity with a cluster of the sample; pairs that a sample drops are missing
            from its clusters.
        rand: adjusted Rand index of each sample's clusters with the full solution, over the pairs
            that both keep (samples,); NaN where fewer pairs are kept than clusters are wanted.
        by_participants: the same for other numbers of participants.
    """

    labels: Labels
    kept_share: Samples
    together: Samples
    cluster_stability: Samples
    rand: Samples
    by_participants: tuple[BySize, ...]


def stability(
    ratings: Samples,
    *,
    least_peak: float = 1.0,
    most_spread: float = 0.85,
    clusters: int = 4,
    samples: int = 1000,
    generator: np.random.Generator,
    sizes: Sequence[int] | None = None,
) -> Stability:
    """Bootstrap the whole way from ratings to clusters.

    Drawing with replacement makes variances smaller by (n − 1)/n on average, n people having
    rated; the samples' variances are corrected for it, or spreads would seem to keep pairs.

    Args:
        ratings: (participants, clips, pairs), NaN where not rated. Clips of which a sample has no
            rating of a kept pair are left out of its clustering.
        least_peak: of equation 3.
        most_spread: of equation 3.
        clusters: how many the trees are cut into.
        samples: how many are drawn with as many participants as there are; a fifth of it for
            each other number.
        generator: of the draws.
        sizes: other numbers of participants; some up to twice as many as there are, if not given.
            Those, too, are drawn with replacement from the participants there are: beyond their
            number it is told what more of the like would give.

    Raises:
        ValueError: fewer than two participants, or fewer kept pairs than clusters.
    """
    rated = _Rated.of(ratings, least_peak, most_spread, clusters)
    quantified = quantify(ratings)
    full = _solution(quantified.mean, kept(quantified, least_peak, most_spread), clusters)
    if full is None:
        raise ValueError(f"fewer pairs are kept than the {clusters} clusters that are wanted")
    tally = _Tally(full)
    for stays, labels in rated.solutions(len(ratings), samples, generator):
        tally.add(stays, labels)
    wanted = _sizes(len(ratings)) if sizes is None else sizes
    by_size = tuple(rated.by_size(full, n, max(samples // 5, 1), generator) for n in wanted)
    return tally.result(by_size)


class _Tally:
    """Counts over the samples."""

    def __init__(self, full: Labels) -> None:
        pairs = len(full)
        self._full = full
        self._kept = np.zeros(pairs)
        self._both, self._together = np.zeros((2, pairs, pairs))
        self._jaccard: list[Samples] = []
        self._rand: list[float] = []

    def add(self, stays: Chosen, labels: Labels | None) -> None:
        self._kept += stays
        self._rand.append(_rand(self._full, labels))
        if labels is None:  # no cluster is found again
            self._jaccard.append(np.zeros(self._full.max() + 1))
            return
        both = np.outer(stays, stays)
        self._both += both
        self._together += (labels[:, None] == labels) & both
        self._jaccard.append(best_jaccard(self._full, labels))

    def result(self, by_size: tuple[BySize, ...]) -> Stability:
        with np.errstate(invalid="ignore"):
            together = self._together / self._both
        count = len(self._rand)
        return Stability(
            self._full,
            self._kept / count,
            together,
            np.mean(self._jaccard, axis=0),
            np.array(self._rand),
            by_size,
        )


@dataclass(frozen=True)
class _Rated:
    """Ratings as sums over participants need them: three matrices (participants, clips × pairs)."""

    values: Samples
    squares: Samples
    known: Samples
    shape: tuple[int, int]
    least_peak: float
    most_spread: float
    clusters: int

    @staticmethod
    def of(ratings: Samples, least_peak: float, most_spread: float, clusters: int) -> _Rated:
        if len(ratings) < 2:
            raise ValueError("a bootstrap needs at least two participants")
        flat = ratings.reshape(len(ratings), -1)
        known = ~np.isnan(flat)
        values = np.where(known, flat, 0.0)
        clips, pairs = ratings.shape[1:]
        return _Rated(
            values,
            values**2,
            known.astype(np.float64),
            (clips, pairs),
            least_peak,
            most_spread,
            clusters,
        )

    def solutions(
        self, participants: int, samples: int, generator: np.random.Generator
    ) -> Iterator[tuple[Chosen, Labels | None]]:
        """The kept pairs and the solution of each sample of so many participants."""
        there = len(self.values)
        draws = generator.multinomial(participants, np.full(there, 1 / there), samples)
        at_once = max(1, _AT_ONCE // self.values.shape[1])
        for start in range(0, samples, at_once):
            mean, chosen = self._quantified(draws[start : start + at_once].astype(np.float64))
            for of_sample, stays in zip(mean, chosen, strict=True):
                yield stays, _solution(of_sample, stays, self.clusters)

    def by_size(
        self, full: Labels, participants: int, samples: int, generator: np.random.Generator
    ) -> BySize:
        solutions = list(self.solutions(participants, samples, generator))
        alike = float(np.mean([stays == (full >= 0) for stays, _ in solutions]))
        rand = present([_rand(full, labels) for _, labels in solutions])
        if not rand.size:
            return BySize(participants, np.nan, np.nan, np.nan, alike)
        low, high = np.quantile(rand, [0.025, 0.975])
        return BySize(participants, float(rand.mean()), float(low), float(high), alike)

    def _quantified(self, draws: Samples) -> tuple[Samples, Chosen]:
        """Means (samples, clips, pairs) and kept pairs (samples, pairs), people weighted."""
        counts, there = draws @ self.known, self.known.sum(axis=0)
        sums, squares = draws @ self.values, draws @ self.squares
        with np.errstate(invalid="ignore", divide="ignore"):
            mean = sums / counts
            variance = np.maximum(squares - sums * mean, 0.0) / (counts - 1)
            spread = np.sqrt(np.where(counts > 1, variance, np.nan) * (there / (there - 1)))
        mean, spread = (part.reshape(len(draws), *self.shape) for part in (mean, spread))
        chosen = within(peaks(mean), mean_spreads(spread), self.least_peak, self.most_spread)
        return mean, chosen


def best_jaccard(full: Labels, labels: Labels) -> Samples:
    """Of each cluster of the full solution the greatest Jaccard similarity in the other one.

    Args:
        full: clusters of the pairs (pairs,), from 0; −1 for dropped ones.
        labels: those of the other solution, likewise.
    """
    shared = contingency(full + 1, labels + 1)
    of_full, of_other = shared.sum(axis=1)[1:], shared.sum(axis=0)[1:]
    shared = shared[1:, 1:]
    either = of_full[:, None] + of_other - shared
    return np.asarray((shared / either).max(axis=1, initial=0.0))


def _solution(mean: Samples, chosen: Chosen, clusters: int) -> Labels | None:
    """The clusters of the chosen pairs (pairs,), −1 for others; None if there are too few."""
    columns = mean[:, chosen].T
    columns = columns[:, ~np.isnan(columns).any(axis=0)]
    if len(columns) < clusters or not columns.shape[1]:
        return None
    labels = np.full(mean.shape[1], DROPPED)
    labels[chosen] = cut(ward(columns), clusters)
    return labels


def _rand(full: Labels, labels: Labels | None) -> float:
    if labels is None:
        return np.nan
    both = (full >= 0) & (labels >= 0)
    return adjusted_rand(full[both], labels[both])


def _sizes(there: int) -> list[int]:
    """Some numbers of participants, from three to twice as many as there are."""
    return sorted({max(3, round(there * part)) for part in (0.25, 0.4, 0.6, 0.8, 1, 1.5, 2)})
