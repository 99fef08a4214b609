"""Impressions predicted from motion features, for clips that nobody has rated.

One ridge regression an adjective, from standardised features. The penalty is chosen by leaving out
one example after the other, and so is the error measured: each example is predicted by a model that
has not seen it, whose scales and penalty were found without it as well (nested leave-one-out). An
adjective is refused whose error is not clearly less than that of predicting the others' mean.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.statistics.intervals import Samples

Flags = NDArray[np.bool_]

LEAST_EXAMPLES = 8
"""Below, nothing is predicted."""

# An adjective is predicted if this over N of the mean's squared error is spared. Without a margin
# one in six is predicted although its ratings are drawn by lot; with it, three in a hundred.
_MARGIN = 5.0

PENALTIES = (*np.geomspace(1e-4, 1e1, 16).tolist(), np.inf)
"""What a model may be penalised by: shares of the features' whole variance, from next to nothing
to so much that only the mean is left."""

_NOTHING = 1e-9  # a spread that rounding leaves
_REFUSED = "Not predicted"


@dataclass(frozen=True, eq=False)
class Models:
    """Linear models of K adjectives, or several of each.

    Attributes:
        constant: (..., K).
        slopes: (..., F, K) a unit of each feature.
    """

    constant: Samples
    slopes: Samples

    def of(self, features: Samples) -> Samples:
        """Impressions (..., M, K) of M clips' features (M, F), not yet kept within 0 … 1."""
        return np.asarray(self.constant[..., None, :] + features @ self.slopes)


@dataclass(frozen=True, eq=False)
class Prediction:
    """What was learnt from N examples about K adjectives.

    Attributes:
        centre: (F,) mean of the examples' features.
        scale: (F,) their standard deviations; 0 for a feature that does not vary.
        models: from all examples.
        left_out: (N, …) the models that have not seen one of the examples.
        residuals: (N, K) how far each example is from its own left-out model's value, absolute.
        penalties: (K,) as a share of the features' whole variance; infinite: the mean alone.
        error: (K,) root mean square of the left-out errors.
        mean_error: (K,) the same of predicting the mean of the other examples.
        explained: (K,) share of the mean's squared error that the models spare; may be negative.
        needed: the share from which on an adjective is predicted.
        refused: (K,) adjectives that are not predicted.
        notes: (K,) a sentence for each adjective.
        level: of the intervals: the share of new clips like the examples that they hold.
    """

    centre: Samples
    scale: Samples
    models: Models
    left_out: Models
    residuals: Samples
    penalties: Samples
    error: Samples
    mean_error: Samples
    explained: Samples
    needed: float
    refused: Flags
    notes: tuple[str, ...]
    level: float

    def predict(self, features: Samples) -> tuple[Samples, Samples, Samples]:
        """Impressions (M, K) of clips with features (M, F), and their intervals' low and high ends.

        All are kept within 0 … 1; refused adjectives are NaN. The interval is the jackknife+ of
        Barber, Candès, Ramdas & Tibshirani (2021, Ann Stat 49:486): from what the left-out models
        say of the clip and how far off they were. It assumes no distribution, only that the clip is
        one like the examples (see ``deviations``).
        """
        values = self.models.of(features)
        others = self.left_out.of(features)  # (N, M, K)
        off = self.residuals[:, None, :]
        rank = round(self.level * (len(others) + 1))
        low = np.sort(others - off, axis=0)[len(others) - rank]
        high = np.sort(others + off, axis=0)[rank - 1]
        # The models' own value may lie beside an interval that other models gave.
        ends = values, np.minimum(low, values), np.maximum(high, values)
        one, two, three = (np.where(self.refused, np.nan, np.clip(x, 0.0, 1.0)) for x in ends)
        return one, two, three

    def deviations(self, features: Samples) -> Samples:
        """(M, F) how many standard deviations a clip's features are from the examples' means.

        Beyond three or four, nothing is known about the adjectives of such a motion.
        """
        away = np.asarray(features) - self.centre
        return np.divide(away, self.scale, out=np.zeros_like(away), where=self.scale > 0)


def fit(features: Samples, impressions: Samples, level: float = 0.95) -> Prediction:
    """Learn adjectives from examples.

    Args:
        features: (N, F) of the rated clips, any units; one that does not vary tells nothing.
        impressions: (N, K) in 0 … 1.
        level: of the intervals, in (0, 1). With few examples it is what their number allows:
            N/(N + 1).

    Raises:
        ValueError: if there are fewer than 3 examples, or any number is missing.
    """
    x, y = np.asarray(features, dtype=np.float64), np.asarray(impressions, dtype=np.float64)
    if len(x) != len(y) or len(x) < 3:
        raise ValueError(f"Prediction needs 3 or more rated clips: {len(x)} features, {len(y)}.")
    if not (np.isfinite(x).all() and np.isfinite(y).all()):
        raise ValueError("Every feature and impression of an example must be a number.")
    count = len(x)
    models, penalties = _fit(x, y)
    apart = [_fit(np.delete(x, i, axis=0), np.delete(y, i, axis=0))[0] for i in range(count)]
    left_out = Models(np.array([m.constant for m in apart]), np.array([m.slopes for m in apart]))
    own = np.stack([model.of(x[i : i + 1])[0] for i, model in enumerate(apart)])
    error = np.sqrt(np.mean((own - y) ** 2, axis=0))
    mean_error = y.std(axis=0) * count / (count - 1)  # of each by the mean of the others
    varies = mean_error > _NOTHING
    explained = np.where(varies, 1.0 - (error / np.where(varies, mean_error, 1.0)) ** 2, 0.0)
    notes = [_note(count, *numbers) for numbers in zip(error, mean_error, explained, strict=True)]
    centre, scale = _scales(x)
    return Prediction(
        centre=centre,
        scale=scale,
        models=models,
        left_out=left_out,
        residuals=np.abs(own - y),
        penalties=penalties,
        error=error,
        mean_error=mean_error,
        explained=explained,
        needed=_MARGIN / count,
        refused=np.array([note.startswith(_REFUSED) for note in notes]),
        notes=tuple(notes),
        level=min(count, int(np.ceil(level * (count + 1)))) / (count + 1),
    )


def _note(count: int, error: float, mean_error: float, explained: float) -> str:
    """Whether an adjective is predicted, and why or why not."""
    if count < LEAST_EXAMPLES:
        return f"{_REFUSED}: {count} rated clips are too few, {LEAST_EXAMPLES} are needed."
    if mean_error <= _NOTHING:
        return f"{_REFUSED}: all rated clips make the same impression."
    off = f"a clip left out is missed by {error:.2f}"
    if explained <= 0.0:
        return f"{_REFUSED}: {off}, no better than the mean does with {mean_error:.2f}."
    if explained < _MARGIN / count:
        return f"{_REFUSED}: {off}, by the mean by {mean_error:.2f}; that may be chance."
    return f"Predicted: {off}, by the mean by {mean_error:.2f}; {explained:.0%} explained."


def _scales(x: Samples) -> tuple[Samples, Samples]:
    """Mean (F,) and standard deviation (F,) of features (n, F); 0 for rounding errors."""
    centre, scale = x.mean(axis=0), x.std(axis=0)
    return centre, np.where(scale > _NOTHING * np.maximum(np.abs(centre), 1.0), scale, 0.0)


def _fit(x: Samples, y: Samples) -> tuple[Models, Samples]:
    """Ridge models of (n, F) and (n, K), and the penalty (K,) chosen for each."""
    centre, scale = _scales(x)
    per_unit = np.divide(1.0, scale, out=np.zeros_like(scale), where=scale > 0)
    u, s, vt = np.linalg.svd((x - centre) * per_unit, full_matrices=False)
    mean = y.mean(axis=0)
    seen = u.T @ (y - mean)  # (r, K)
    total = float(np.sum(s**2)) or 1.0
    chosen, least = np.full(y.shape[1], np.inf), np.full(y.shape[1], np.inf)
    for penalty in PENALTIES[::-1]:  # of equal ones the strongest
        kept = _kept(s, penalty * total)
        # Without example i, its residual grows by 1/(1 − h_ii), the constant's 1/n included.
        leverage = (u**2) @ kept + 1.0 / len(x)
        errors = (y - mean - u @ (kept[:, None] * seen)) / (1.0 - leverage)[:, None]
        squares = np.sum(errors**2, axis=0)
        better = squares < least * (1.0 - 1e-12)
        chosen, least = np.where(better, penalty, chosen), np.where(better, squares, least)
    shrunk = _kept(s[:, None], chosen * total) * seen / np.where(s > 0, s, 1.0)[:, None]
    slopes = per_unit[:, None] * (vt.T @ shrunk)
    return Models(mean - centre @ slopes, slopes), chosen


def _kept(s: Samples, strength: Samples | float) -> Samples:
    """Share of each singular direction that a penalty leaves."""
    return np.asarray(s**2 / (s**2 + strength))
