"""Sliders of motion features: where every example lies on each of the 51, and on four clusters."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from app.schemas.spaces import Parameter, Primary, Sliders
from app.schemas.study import Words
from app.services.space_clips import DIGITS
from app.statistics.ward import Labels, cluster_means, cut, ward
from motion.features import FEATURE_GROUPS, FEATURES

Array = NDArray[np.float64]

CLUSTERS = 4
_SAME = 1e-9


def feature_sliders(values: Array) -> Sliders:
    """Sliders of the 51 features (examples, 51): each from 0 to 1, and clusters of them.

    A single slider goes from the least to the greatest value of any example; where all are equal
    they stand in the middle. The clusters are Ward's on standardised columns; the slider of one is
    the mean of its members' standardised columns, again from its least to its greatest.
    """
    low, high = values.min(axis=0), values.max(axis=0)
    single = scaled(values)
    columns = standardised(values)
    labels = cut(ward(columns.T), CLUSTERS)
    together = scaled(cluster_means(columns, labels))
    return Sliders(
        primary=tuple(
            Primary(
                id=f"{group}_group",
                title=Words(FEATURE_GROUPS[group]),
                members=tuple(
                    f.id for f, label in zip(FEATURES, labels, strict=True) if label == n
                ),
                values=as_values(together[:, n]),
            )
            for n, group in enumerate(_titles(labels))
        ),
        parameters=tuple(
            Parameter(
                id=feature.id,
                title=Words(feature.title),
                about=feature.description,
                left=Words("less"),
                right=Words("more"),
                unit=feature.unit,
                lowest=round(float(low[n]), DIGITS),
                highest=round(float(high[n]), DIGITS),
                values=as_values(single[:, n]),
            )
            for n, feature in enumerate(FEATURES)
        ),
    )


def scaled(values: Array) -> Array:
    """Columns (examples, n) from 0, the least, to 1, the greatest; equal ones become 0.5."""
    low, span = values.min(axis=0), np.ptp(values, axis=0)
    varies = _varies(values)
    return np.where(varies, (values - low) / np.where(varies, span, 1.0), 0.5)


def standardised(values: Array) -> Array:
    """Columns (examples, n) with mean 0 and standard deviation 1; equal ones become 0."""
    varies = _varies(values)
    spread = np.where(varies, values.std(axis=0), 1.0)
    return np.where(varies, (values - values.mean(axis=0)) / spread, 0.0)


def as_values(column: Array) -> tuple[float, ...]:
    """A column (examples,) as it is stored."""
    return tuple(round(float(value), DIGITS) + 0.0 for value in np.clip(column, 0.0, 1.0))


def rounded(sliders: Sliders) -> Sliders:
    """Sliders with every value as it is stored."""

    def of(one: Primary | Parameter) -> dict[str, object]:
        return {"values": as_values(np.array(one.values))}

    return Sliders(
        primary=tuple(one.model_copy(update=of(one)) for one in sliders.primary),
        parameters=tuple(one.model_copy(update=of(one)) for one in sliders.parameters),
    )


def _varies(values: Array) -> NDArray[np.bool_]:
    return np.asarray(np.ptp(values, axis=0) > _SAME * np.maximum(1.0, np.abs(values).max(axis=0)))


def _titles(labels: Labels) -> list[str]:
    """The paper's group that each cluster overlaps most, no group twice."""
    groups = list(FEATURE_GROUPS)
    ours = np.arange(CLUSTERS)[:, None] == labels
    theirs = np.array([[feature.group == group for feature in FEATURES] for group in groups])
    shared = ours.astype(float) @ theirs.T
    either = ours.sum(axis=1)[:, None] + theirs.sum(axis=1) - shared
    _, chosen = linear_sum_assignment(shared / either, maximize=True)
    return [groups[group] for group in chosen]
