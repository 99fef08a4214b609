"""Ridge regression of several values from the same features, each with its own penalty.

Features are standardised; the penalty is chosen by leaving out one example after the other, in
closed form. Source: Hastie, Tibshirani & Friedman, The Elements of Statistical Learning, 2nd ed.,
sections 3.4.1 and 7.10.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.statistics.intervals import Samples

PENALTIES = (*np.geomspace(1e-4, 1e1, 16).tolist(), np.inf)
"""What a model may be penalised by: shares of the features' whole variance, from next to nothing
to so much that only the mean is left."""

_ROUNDING = 1e-9


@dataclass(frozen=True, eq=False)
class Ridge:
    """Linear models of K values, learnt from n examples with F features.

    Attributes:
        count: n.
        centre: (F,) mean of the features.
        scale: (F,) what counts as one of each feature; 0 for one that does not count.
        directions: (r, F) orthonormal, of the standardised features.
        sizes: (r,) of the examples along them: singular values.
        mean: (K,) of the examples' values.
        weights: (r, K) of the directions.
        penalties: (K,) one of PENALTIES each.
    """

    count: int
    centre: Samples
    scale: Samples
    directions: Samples
    sizes: Samples
    mean: Samples
    weights: Samples
    penalties: Samples

    def of(self, features: Samples) -> Samples:
        """Values (M, K) at features (M, F)."""
        return np.asarray(
            self.mean + self.standardised(features) @ self.directions.T @ self.weights
        )

    def standardised(self, features: Samples) -> Samples:
        """(M, F) how many scales features (M, F) are from the examples' mean."""
        away = np.asarray(features, dtype=np.float64) - self.centre
        return np.divide(away, self.scale, out=np.zeros_like(away), where=self.scale > 0)

    def uncertainty(self, features: Samples) -> Samples:
        """How much farther off than the noise the values (M, K) at features (M, F) may be, ≥ 1.

        The predictive standard deviation, in units of the noise's, of the Bayesian model whose mean
        a ridge regression is: it grows with the distance from the examples, most where they do not
        vary.
        """
        away = self.standardised(features)
        along = (away @ self.directions.T) ** 2  # (M, r)
        beside = np.maximum(np.sum(away**2, axis=1) - along.sum(axis=1), 0.0)
        strength = self.penalties * _total(self.sizes)
        known = along @ (1.0 / (self.sizes[:, None] ** 2 + strength))
        return np.sqrt(1.0 + 1.0 / self.count + known + beside[:, None] / strength)


def fit_ridge(x: Samples, y: Samples, least: Samples | float = 0.0) -> Ridge:
    """The models of values (n, K) from features (n, F).

    Args:
        x: features; one that does not vary counts for nothing, unless ``least`` is above 0.
        y: values.
        least: (F,) the least that counts as one of each feature, however little it varies.
    """
    centre, scale = x.mean(axis=0), x.std(axis=0)
    scale = np.where(scale > _ROUNDING * np.maximum(np.abs(centre), 1.0), scale, 0.0)
    scale = np.maximum(scale, least)
    away = np.divide(x - centre, scale, out=np.zeros_like(x), where=scale > 0)
    u, sizes, directions = np.linalg.svd(away, full_matrices=False)
    mean = y.mean(axis=0)
    seen = u.T @ (y - mean)  # (r, K)
    penalties = _best_penalties(u, sizes, y - mean)
    strength = penalties * _total(sizes)
    weights = sizes[:, None] / (sizes[:, None] ** 2 + strength) * seen
    return Ridge(len(x), centre, scale, directions, sizes, mean, weights, penalties)


def _best_penalties(u: Samples, sizes: Samples, y: Samples) -> Samples:
    """(K,) the penalties with the least error of leaving one out; the strongest of equal ones."""
    chosen, least = np.full(y.shape[1], np.inf), np.full(y.shape[1], np.inf)
    for penalty in PENALTIES[::-1]:
        kept = sizes**2 / (sizes**2 + penalty * _total(sizes))
        # Without an example its residual grows by 1/(1 − leverage), the mean's 1/n included.
        leverage = (u**2) @ kept + 1.0 / len(u)
        errors = (y - u @ (kept[:, None] * (u.T @ y))) / (1.0 - leverage)[:, None]
        squares = np.sum(errors**2, axis=0)
        better = squares < least * (1.0 - 1e-12)
        chosen, least = np.where(better, penalty, chosen), np.where(better, squares, least)
    return chosen


def _total(sizes: Samples) -> float:
    """The features' whole variance, over all examples; 1 where nothing varies."""
    return float(np.sum(sizes**2)) or 1.0
