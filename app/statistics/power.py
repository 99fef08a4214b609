"""How often a difference would be found: power by simulation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy import special

from app.statistics.intervals import Samples, wilson
from app.statistics.raters import rated


@dataclass(frozen=True)
class Power:
    """The share of runs in which a difference was found, with Wilson's 95 % interval."""

    share: float
    low: float
    high: float
    runs: int


def power(
    difference: float,
    participants: int,
    generator: np.random.Generator,
    *,
    noise: float,
    rater_sd: float = 0.0,
    lowest: float = -np.inf,
    highest: float = np.inf,
    step: float | None = 1.0,
    between: bool = False,
    alpha: float = 0.05,
    runs: int = 500,
) -> Power:
    """How often the difference between two clips is found by a two-sided t-test.

    Every participant rates both clips, and the test is paired; with `between`, two groups of so
    many participants rate one clip each, and the test is Welch's. Found means p below `alpha`.
    Divide `alpha` by the number of tests for a lower bound under Holm's correction.

    Args:
        difference: between the clips' latent values, which lie evenly about the scale's middle (or
            about 0 where it has no ends), in the scale's unit.
        participants: how many; in each group, with `between`.
        generator: of all draws.
        noise: standard deviation of an answer about what its rater means.
        rater_sd: standard deviation of the raters' biases.
        lowest: the scale's lower end.
        highest: its upper end.
        step: between two neighbouring answers; None for a scale without steps.
        between: whether each participant sees one clip only.
        alpha: the level.
        runs: how many simulated studies.
    """
    ended = np.isfinite(lowest) and np.isfinite(highest)
    middle = (lowest + highest) / 2 if ended else 0.0
    shape = (runs, participants)
    biases = [generator.normal(0.0, rater_sd, shape)] * 2
    if between:
        biases[1] = generator.normal(0.0, rater_sd, shape)
    answers = [
        _answered(middle + sign * difference / 2 + bias, noise, generator, lowest, highest, step)
        for sign, bias in zip((1, -1), biases, strict=True)
    ]
    p = two_sided(*answers) if between else about_zero(answers[0] - answers[1])
    return found_in(p < alpha)


def found_in(found: ArrayLike) -> Power:
    """The share of runs that found something; found (runs,)."""
    hits = np.asarray(found, dtype=bool)
    share = wilson(int(hits.sum()), hits.size)
    if share is None:
        raise ValueError("power needs at least one run")
    return Power(share.share, share.low, share.high, hits.size)


def about_zero(values: Samples) -> Samples:
    """P-values of t-tests against 0 along the last axis; NaN (missing) values are left out.

    1 where there are fewer than two values or no spread: nothing is found there.
    """
    n = np.sum(~np.isnan(values), axis=-1)
    with np.errstate(invalid="ignore", divide="ignore"):
        mean = np.nansum(values, axis=-1) / n
        squares = np.nansum((values - mean[..., None]) ** 2, axis=-1)
        t = mean / np.sqrt(squares / (n - 1) / n)
        p = 2 * special.stdtr(n - 1, -np.abs(t))
    return np.where((n > 1) & (squares > 1e-12), p, 1.0)


def two_sided(a: Samples, b: Samples) -> Samples:
    """P-values of Welch's tests along the last axis; 1 where neither group has any spread."""
    of_a, of_b = a.var(axis=-1, ddof=1) / a.shape[-1], b.var(axis=-1, ddof=1) / b.shape[-1]
    error = of_a + of_b
    with np.errstate(invalid="ignore", divide="ignore"):
        df = error**2 / (of_a**2 / (a.shape[-1] - 1) + of_b**2 / (b.shape[-1] - 1))
        t = (a.mean(axis=-1) - b.mean(axis=-1)) / np.sqrt(error)
        p = 2 * special.stdtr(df, -np.abs(t))
    return np.where(error > 1e-12, p, 1.0)


def _answered(
    latent: Samples,
    noise: float,
    generator: np.random.Generator,
    lowest: float,
    highest: float,
    step: float | None,
) -> Samples:
    if step is not None and np.isfinite(lowest):
        return rated(latent, noise, generator, lowest=lowest, highest=highest, step=step)
    noisy = latent + generator.normal(0.0, noise, latent.shape)
    if step is not None:
        noisy = np.rint(noisy / step) * step
    return np.asarray(np.clip(noisy, lowest, highest))
