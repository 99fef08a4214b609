"""From answers to numbers: means and spreads of adjective pairs, and which pairs to keep.

Source: M. Oshita et al., motion interpolation with adjectives, section 3.4, equations 1 to 3.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.statistics.intervals import Samples

Chosen = NDArray[np.bool_]


@dataclass(frozen=True)
class Quantified:
    """What the participants' answers say about each pair of adjectives.

    Attributes:
        mean: μ (clips, pairs), in steps; NaN where nobody rated.
        spread: σ (clips, pairs), sample standard deviation (n − 1; the paper says "distribution");
            NaN where fewer than two people rated.
        counts: how many rated (clips, pairs).
        peak: μ* (pairs,), the greatest |μ| over the clips; NaN for a pair that nobody rated.
        mean_spread: σ̄ (pairs,), mean σ over the clips that have one; NaN where none has.
    """

    mean: Samples
    spread: Samples
    counts: NDArray[np.intp]
    peak: Samples
    mean_spread: Samples


def quantify(ratings: Samples) -> Quantified:
    """Means and spreads over the participants.

    Args:
        ratings: (participants, clips, pairs), in steps about the neutral 0; NaN where not rated.
    """
    rated = ~np.isnan(ratings)
    counts = rated.sum(axis=0)
    with np.errstate(invalid="ignore", divide="ignore"):
        mean = np.where(rated, ratings, 0.0).sum(axis=0) / counts
        squares = np.where(rated, (ratings - mean) ** 2, 0.0).sum(axis=0)
        spread = np.sqrt(np.where(counts > 1, squares, np.nan) / (counts - 1))
    return Quantified(mean, spread, counts, peaks(mean), mean_spreads(spread))


def peaks(mean: Samples) -> Samples:
    """μ* (..., pairs) of means (..., clips, pairs), equation 1."""
    greatest = np.where(np.isnan(mean), -1.0, np.abs(mean)).max(axis=-2, initial=-1.0)
    return np.where(greatest < 0, np.nan, greatest)


def mean_spreads(spread: Samples) -> Samples:
    """σ̄ (..., pairs) of spreads (..., clips, pairs), equation 2."""
    known = ~np.isnan(spread)
    with np.errstate(invalid="ignore"):
        return np.asarray(np.where(known, spread, 0.0).sum(axis=-2) / known.sum(axis=-2))


def kept(quantified: Quantified, least_peak: float = 1.0, most_spread: float = 0.85) -> Chosen:
    """Which pairs say something that people agree on (pairs,), equation 3.

    A pair is dropped if μ* < least_peak or σ̄ > most_spread; one that meets a threshold exactly
    stays. An unknown spread (nobody shared a clip) drops no pair, an unknown mean does.
    """
    return within(quantified.peak, quantified.mean_spread, least_peak, most_spread)


def within(peak: Samples, mean_spread: Samples, least_peak: float, most_spread: float) -> Chosen:
    """Equation 3 for any shape of μ* and σ̄."""
    return np.asarray((peak >= least_peak) & ~(mean_spread > most_spread))


def impressions(
    quantified: Quantified, chosen: Chosen | NDArray[np.intp], reach: float = 2.0
) -> Samples:
    """The impression matrix A (clips, chosen pairs), from 0 (left pole) to 1 (right pole).

    Args:
        quantified: of all pairs.
        chosen: mask (pairs,) or places of the pairs, whose order the columns then have.
        reach: the outermost step, whose means become 0 and 1. NaN stays where nobody rated.
    """
    return np.asarray((quantified.mean[:, chosen] / reach + 1.0) / 2.0)
