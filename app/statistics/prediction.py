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
from app.statistics.ridge import Ridge, fit_ridge

Flags = NDArray[np.bool_]

LEAST_EXAMPLES = 8
"""Below, nothing is predicted."""

# An adjective is predicted if this over N of the mean's squared error is spared. Without a margin
# one in six is predicted although its ratings are drawn by lot; with it, three in a hundred.
_MARGIN = 5.0

_NOTHING = 1e-9  # a spread that rounding leaves


@dataclass(frozen=True, eq=False)
class Prediction:
    """What was learnt from N examples about K adjectives.

    Attributes:
        model: of all adjectives, from all examples.
        left_out: N models, each of which has not seen one of the examples.
        scores: (N, K) how far each example is from its own left-out model's value, absolute, over
            that model's uncertainty there.
        error: (K,) root mean square of the left-out errors.
        mean_error: (K,) the same of predicting the mean of the other examples.
        explained: (K,) share of the mean's squared error that the models spare; may be negative.
        needed: the share from which on an adjective is predicted.
        refused: (K,) adjectives that are not predicted.
        notes: (K,) a sentence for each adjective.
        level: of the intervals: the share of new clips that they hold.
    """

    model: Ridge
    left_out: tuple[Ridge, ...]
    scores: Samples
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
        Barber, Candès, Ramdas & Tibshirani (2021, Ann Stat 49:486), with errors scaled by the
        models' uncertainty: from what the left-out models say of the clip and how far off they
        were, without assuming a distribution. A clip unlike all examples gets a wide one.
        """
        x = np.asarray(features, dtype=np.float64)
        values = self.model.of(x)
        others = np.stack([model.of(x) for model in self.left_out])  # (N, M, K)
        reach = np.stack([model.uncertainty(x) for model in self.left_out])
        reach *= self.scores[:, None, :]
        rank = round(self.level * (len(others) + 1))
        low = np.sort(others - reach, axis=0)[len(others) - rank]
        high = np.sort(others + reach, axis=0)[rank - 1]
        # The model's own value may lie beside an interval that other models gave.
        ends = values, np.minimum(low, values), np.maximum(high, values)
        one, two, three = (np.where(self.refused, np.nan, np.clip(end, 0.0, 1.0)) for end in ends)
        return one, two, three


def fit(
    features: Samples,
    impressions: Samples,
    level: float = 0.95,
    least: Samples | float = 0.0,
) -> Prediction:
    """Learn adjectives from examples.

    Args:
        features: (N, F) of the rated clips, in any units.
        impressions: (N, K) in 0 … 1.
        level: of the intervals, in (0, 1). With few examples it is what their number allows:
            N/(N + 1).
        least: (F,) differences of each feature that are too small to mean anything. Without them,
            a feature that the examples hardly vary in decides about clips that do.

    Raises:
        ValueError: if there are fewer than 3 examples, or any number is missing.
    """
    x, y = _checked(features, impressions)
    count = len(x)
    left_out = tuple(
        fit_ridge(np.delete(x, i, axis=0), np.delete(y, i, axis=0), least) for i in range(count)
    )
    own = list(zip(left_out, x[:, None, :], strict=True))
    off = np.stack([model.of(row)[0] for model, row in own]) - y
    unsure = np.stack([model.uncertainty(row)[0] for model, row in own])
    error = np.sqrt(np.mean(off**2, axis=0))
    mean_error = y.std(axis=0) * count / (count - 1)  # of each by the mean of the others
    varies = mean_error > _NOTHING
    explained = np.where(varies, 1.0 - (error / np.where(varies, mean_error, 1.0)) ** 2, 0.0)
    numbers = list(zip(error, mean_error, explained, strict=True))
    reasons = [_refusal(count, *row) for row in numbers]
    return Prediction(
        model=fit_ridge(x, y, least),
        left_out=left_out,
        scores=np.abs(off) / unsure,
        error=error,
        mean_error=mean_error,
        explained=explained,
        needed=_MARGIN / count,
        refused=np.array([reason is not None for reason in reasons]),
        notes=tuple(_note(why, *row) for why, row in zip(reasons, numbers, strict=True)),
        level=min(count, int(np.ceil(level * (count + 1)))) / (count + 1),
    )


def _checked(features: Samples, impressions: Samples) -> tuple[Samples, Samples]:
    x, y = np.asarray(features, dtype=np.float64), np.asarray(impressions, dtype=np.float64)
    if len(x) != len(y) or len(x) < 3:
        raise ValueError(
            f"Prediction needs 3 or more rated clips: got features of {len(x)}, "
            f"impressions of {len(y)}."
        )
    if not (np.isfinite(x).all() and np.isfinite(y).all()):
        raise ValueError("Every feature and impression of an example must be a number.")
    return x, y


def _refusal(count: int, error: float, mean_error: float, explained: float) -> str | None:
    """Why an adjective is not predicted; None if it is."""
    if count < LEAST_EXAMPLES:
        return f"{count} rated clips are too few, {LEAST_EXAMPLES} are needed."
    if mean_error <= _NOTHING:
        return "all rated clips make the same impression."
    if explained <= 0.0:
        return f"{_missed(error)}, no better than the mean does with {mean_error:.2f}."
    if explained < _MARGIN / count:
        return f"{_missed(error)}, by the mean by {mean_error:.2f}; that may be chance."
    return None


def _note(refusal: str | None, error: float, mean_error: float, explained: float) -> str:
    if refusal:
        return f"Not predicted: {refusal}"
    return (
        f"Predicted: {_missed(error)}, by the mean by {mean_error:.2f}; {explained:.0%} explained."
    )


def _missed(error: float) -> str:
    return f"a clip left out is missed by {error:.2f}"
