"""Simulated raters: what people with stated tastes would answer.

A rater's answer is the latent value, plus the rater's own bias, plus noise, rounded to a step and
kept within the scale; a choice is that of the figure with the highest noisy value (Thurstone 1927).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from app.statistics.intervals import Samples


def rated(
    latent: Samples,
    noise: float,
    generator: np.random.Generator,
    *,
    lowest: float,
    highest: float,
    step: float = 1.0,
) -> Samples:
    """Answers on a scale.

    Args:
        latent: any shape, what would be answered without noise, biases included.
        noise: standard deviation of each answer, in the scale's unit.
        generator: of the noise.
        lowest: the scale's lower end.
        highest: its upper end.
        step: between two neighbouring answers, from `lowest` on.
    """
    noisy = latent + generator.normal(0.0, noise, np.shape(latent))
    steps = np.rint((noisy - lowest) / step) * step + lowest
    return np.asarray(np.clip(steps, lowest, highest))


def felt(utility: Samples, noise: float, generator: np.random.Generator) -> Samples:
    """How good each figure seems at this moment: utility (..., figures) plus noise."""
    return np.asarray(utility + generator.normal(0.0, noise, np.shape(utility)))


def ranked(seeming: Samples) -> Samples:
    """Ranks (..., figures), 1 for the best."""
    order = np.argsort(-seeming, axis=-1, kind="stable")
    return np.asarray(np.argsort(order, axis=-1) + 1.0)


def matched(
    utility: Samples, third: NDArray[np.intp], noise: float, generator: np.random.Generator
) -> NDArray[np.intp]:
    """Which of two figures a third one is taken for: the one that seems nearer at the moment.

    Args:
        utility: of the two, (..., 2).
        third: which of the two the third figure equals, (...).
        noise: standard deviation of each of the three impressions.
        generator: of the noise, and of guesses where both seem equally near.
    """
    seeming = felt(utility, noise, generator)
    equal = np.take_along_axis(utility, third[..., None], axis=-1)
    apart = np.abs(seeming - felt(equal, noise, generator))
    guesses = generator.integers(2, size=np.shape(third))
    nearer = (apart[..., 1] < apart[..., 0]).astype(np.intp)
    return np.where(apart[..., 0] == apart[..., 1], guesses, nearer)
