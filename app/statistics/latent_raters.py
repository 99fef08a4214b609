"""Simulated raters whose impressions have known factors, to see whether an analysis finds them.

The size of each part is set by the thresholds of Oshita et al. (equation 3), before any result:

- A pair that says something has its strongest clip between the least that is kept (1) and the end
  of the scale (2), so between 1.2 and 2 steps from neutral.
- A pair that says little has its strongest clip at half the threshold.
- A pair about which people disagree has personal opinions with twice the spread that is kept.
- Noise: an answer spreads by rater's bias, momentary noise and rounding. The noisiest answers that
  the paper keeps have σ = 0.85; less the 1/12 of rounding to whole steps that leaves `PAPER_NOISE`.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

import numpy as np

from app.statistics.agreement import adjusted_rand
from app.statistics.intervals import Samples
from app.statistics.quantification import Chosen, impressions, kept, quantify
from app.statistics.raters import rated
from app.statistics.ward import Labels, cut, ward

REACH = 2.0  # steps from neutral to the scale's ends
LEAST_PEAK, MOST_SPREAD = 1.0, 0.85
PAPER_NOISE = sqrt(MOST_SPREAD**2 - 1 / 12)
LOADS = (0.6, 1.0)
NEUTRAL_LOAD = LEAST_PEAK / 2 / REACH
TASTE = 2 * MOST_SPREAD


@dataclass(frozen=True)
class Pairs:
    """What each pair of adjectives measures (pairs,).

    Attributes:
        factor: which factor of the clips.
        load: how strongly, 1 being the whole scale.
        taste: standard deviation of personal opinions about each clip, in steps.
    """

    factor: Labels
    load: Samples
    taste: Samples


@dataclass(frozen=True)
class Recovery:
    """How much of the known structure an analysis finds.

    Attributes:
        kept: share of the pairs with a factor that are kept.
        dropped: share of the others that are dropped.
        rand: adjusted Rand index over the kept pairs with a factor; NaN where fewer pairs are kept
            than there are clusters.
        exact: everything as it was put in.
    """

    kept: float
    dropped: float
    rand: float
    exact: bool


def draw_pairs(factors: Labels, generator: np.random.Generator) -> Pairs:
    """Pairs of adjectives of which the factors are known, and nothing else.

    Args:
        factors: of each pair (pairs,); −1 for those that shall be dropped: one half, at random,
            says little, people disagree about the other half; which factor they have is random.
        generator: of all draws.
    """
    dropped = np.flatnonzero(factors < 0)
    factor = factors.copy()
    factor[dropped] = generator.integers(factors.max() + 1, size=len(dropped))
    load = generator.uniform(*LOADS, size=len(factors))
    taste = np.zeros(len(factors))
    neutral, disputed = np.array_split(generator.permutation(dropped), 2)
    load[neutral] = NEUTRAL_LOAD
    taste[disputed] = TASTE
    return Pairs(factor, load, taste)


def simulate(
    latent: Samples,
    pairs: Pairs,
    participants: int,
    generator: np.random.Generator,
    noise: float = PAPER_NOISE,
) -> Samples:
    """Answers −2 … 2 (participants, clips, pairs).

    Args:
        latent: of each clip on each factor (clips, factors), within −1 … 1.
        pairs: what they measure.
        participants: how many answer.
        generator: of all draws.
        noise: standard deviation of an answer about the common opinion, in steps; half of the
            variance is the rater's bias on the pair, half of it the moment's.
    """
    clips, count = len(latent), len(pairs.load)
    common = REACH * latent[:, pairs.factor] * pairs.load
    opinions = pairs.taste * generator.normal(size=(participants, clips, count))
    biases = generator.normal(0.0, noise / sqrt(2), (participants, 1, count))
    meant = common + opinions + biases
    return rated(meant, noise / sqrt(2), generator, lowest=-REACH, highest=REACH)


def shuffle_answers(ratings: Samples, generator: np.random.Generator) -> Samples:
    """Of each pair all answers change places among raters and clips: no clip differs any more."""
    flat = ratings.reshape(-1, ratings.shape[-1])
    return generator.permuted(flat, axis=0).reshape(ratings.shape)


def shuffle_clips(ratings: Samples, generator: np.random.Generator) -> Samples:
    """Of each pair the clips change places: pairs are kept as before but have nothing in common."""
    order = generator.permuted(np.indices(ratings.shape[1:])[0], axis=0)
    return np.take_along_axis(ratings, order[None], axis=1)


def recover(ratings: Samples, factors: Labels, *, thresholds: bool = True) -> Recovery:
    """Quantify, drop and cluster the ratings, and compare with what was put in.

    Args:
        ratings: (participants, clips, pairs).
        factors: the pairs' factors (pairs,), −1 for those that shall be dropped.
        thresholds: whether pairs are dropped by equation 3; else those with a factor are kept.
    """
    quantified = quantify(ratings)
    has = factors >= 0
    stays = kept(quantified, LEAST_PEAK, MOST_SPREAD) if thresholds else has
    rand = _rand(impressions(quantified, stays, REACH), stays, factors)
    right = bool((stays == has).all())
    return Recovery(
        float(stays[has].mean()), float((~stays[~has]).mean()), rand, right and rand == 1
    )


def _rand(matrix: Samples, stays: Chosen, factors: Labels) -> float:
    clusters = factors.max() + 1
    if matrix.shape[1] < clusters:
        return np.nan
    has = factors[stays] >= 0
    return adjusted_rand(cut(ward(matrix.T), clusters)[has], factors[stays][has])
