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


class Agreement(NamedTuple):
    """Adjusted Rand index over samples; NaN where none has one.

    Attributes:
        mean: of the samples.
        low: the middle 95 % of the samples begins here.
        high: and ends here.
    """

    mean: float
    low: float
    high: float

    @staticmethod
    def of(values: Sequence[float] | Samples) -> Agreement:
        """Of all samples that have one."""
        known = present(np.asarray(values, dtype=np.float64))
        if not known.size:
            return Agreement(np.nan, np.nan, np.nan)
        low, high = np.quantile(known, [0.025, 0.975])
        return Agreement(float(known.mean()), float(low), float(high))


class BySize(NamedTuple):
    """What so many participants would give, against the solution of all.

    Attributes:
        participants: how many are drawn.
        whole: which pairs are kept and how they are grouped: over all pairs that were asked,
            those left out being a group of their own.
        shared: how pairs are grouped, over the pairs that both keep.
        kept_alike: mean share of pairs that are kept, or dropped, as by all participants.
    """

    participants: int
    whole: Agreement
    shared: Agreement
    kept_alike: float


@dataclass(frozen=True)
class Drawn:
    """What stays when as many participants are drawn anew.

    Attributes:
        kept_share: how often each pair is kept (pairs,).
        cluster_stability: Hennig's, of each cluster: the mean over the samples of the greatest
            Jaccard similarity with a cluster of the sample; pairs that a sample drops are missing
            from its clusters.
        whole: adjusted Rand index of each sample with the full solution (samples,), over all pairs
            that were asked, those left out being a group of their own.
        shared: the same over the pairs that both keep; NaN where these are fewer than two, or fewer
            pairs are kept than clusters are wanted.
    """

    kept_share: Samples
    cluster_stability: Samples
    whole: Samples
    shared: Samples


@dataclass(frozen=True)
class Bootstrap:
    """The whole way from ratings to clusters, to be gone again with other participants.

    Drawing with replacement makes variances smaller by (n − 1)/n on average, n people having
    rated; the samples' variances are corrected for it, or spreads would seem to keep pairs.

    Attributes:
        labels: the solution of all participants (pairs,); −1 for dropped pairs.
    """

    labels: Labels
    _rated: _Rated

    @staticmethod
    def of(
        ratings: Samples, *, least_peak: float = 1.0, most_spread: float = 0.85, clusters: int = 4
    ) -> Bootstrap:
        """Prepare it.

        Args:
            ratings: (participants, clips, pairs), NaN where not rated. Clips of which a sample has
                no rating of a kept pair are left out of its clustering.
            least_peak: of equation 3.
            most_spread: of equation 3.
            clusters: how many the trees are cut into.

        Raises:
            ValueError: fewer than two participants, or fewer kept pairs than clusters.
        """
        rated = _Rated.of(ratings, least_peak, most_spread, clusters)
        quantified = quantify(ratings)
        chosen = kept(quantified, least_peak, most_spread)
        labels = _solution(quantified.mean, chosen, clusters)
        if labels is None:
            raise ValueError(f"fewer pairs are kept than the {clusters} clusters that are wanted")
        return Bootstrap(labels, rated)

    def drawn(self, samples: int, generator: np.random.Generator) -> Drawn:
        """So many samples of as many participants as there are."""
        full = self.labels
        found = list(self._rated.solutions(len(self._rated.values), samples, generator))
        nothing = np.zeros(full.max() + 1)  # where no clusters are, none is found again
        jaccard = [nothing if labels is None else best_jaccard(full, labels) for _, labels in found]
        return Drawn(
            np.mean([stays for stays, _ in found], axis=0),
            np.mean(jaccard, axis=0),
            np.array([_whole(full, *one) for one in found]),
            np.array([_shared(full, labels) for _, labels in found]),
        )

    def by_size(self, participants: int, samples: int, generator: np.random.Generator) -> BySize:
        """So many samples of another number of participants.

        They, too, are drawn with replacement from the participants there are: beyond their number
        it is told what more of the like would give.
        """
        full = self.labels
        found = list(self._rated.solutions(participants, samples, generator))
        return BySize(
            participants,
            Agreement.of([_whole(full, *one) for one in found]),
            Agreement.of([_shared(full, labels) for _, labels in found]),
            float(np.mean([stays == (full >= 0) for stays, _ in found])),
        )


def sizes(there: int) -> list[int]:
    """Some numbers of participants to try, from three to twice as many as there are."""
    return sorted({max(3, round(there * part)) for part in (0.25, 0.4, 0.6, 0.8, 1, 1.5, 2)})


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


def _whole(full: Labels, stays: Chosen, labels: Labels | None) -> float:
    """The index over all pairs, those left out being a group; of too few kept, each is one."""
    if labels is None:
        labels = np.where(stays, np.cumsum(stays) - 1, DROPPED)
    return adjusted_rand(full + 1, labels + 1)


def _shared(full: Labels, labels: Labels | None) -> float:
    """The index over the pairs that both keep; one pair alone agrees with everything."""
    if labels is None:
        return np.nan
    both = (full >= 0) & (labels >= 0)
    return adjusted_rand(full[both], labels[both]) if both.sum() > 1 else np.nan
