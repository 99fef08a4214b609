"""Which moment of each example is shown when: piecewise linear between common keytimes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from motion.keytimes import EVENTS

Array = NDArray[np.float64]

_APART = 1e-6  # of the clip: events nearer than this have no order


def common_order(phases: Sequence[Mapping[str, float]]) -> tuple[str, ...]:
    """The most events that come in the same order in all examples.

    A walker's right foot strikes before the left is off, a runner's afterwards: of such a pair one
    stays. Of chains equally long the one with the more important event counts, strikes before the
    rest.

    Args:
        phases: for each example, event to its share of the clip.
    """
    names = sorted(set.intersection(*(set(p) for p in phases)), key=_importance)
    at = np.array([[p[name] for p in phases] for name in names]).reshape(len(names), len(phases))
    best: dict[int, list[int]] = {}
    for index in np.argsort(at.sum(axis=1), kind="stable").tolist():
        before = [chain for last, chain in best.items() if np.all(at[index] - at[last] > _APART)]
        best[index] = [*max(before, key=_worth, default=[]), index]
    return tuple(names[index] for index in max(best.values(), key=_worth, default=[]))


def first_event(phases: Sequence[Mapping[str, float]]) -> str | None:
    """The event of all examples at which cycles begin: the left strike where they have it."""
    shared = set.intersection(*(set(p) for p in phases))
    return min(shared, key=_importance, default=None)


def _importance(name: str) -> tuple[int, str]:
    order = sorted(EVENTS, key=lambda event: not event.endswith("strike"))
    return (order.index(name) if name in order else len(order), name)


def _worth(chain: list[int]) -> tuple[int, list[int]]:
    return len(chain), [-index for index in sorted(chain)]


def warped(shares: Array, events: Array, weights: Array, *, cyclic: bool) -> Array:
    """Share of each example (A, T) that is shown at shares (T,) of the blend.

    The blend's keytimes are the weighted means of the examples'; between two of them time passes
    evenly (Rose et al. 1998; Oshita et al. 4.2).

    Args:
        shares: in [0, 1], ascending.
        events: (A, K) ascending shares at which the events come in each example.
        weights: (A,) of sum 1.
        cyclic: events come again one whole before and after; otherwise the ends meet.
    """
    count = len(events)
    if cyclic and events.shape[1]:
        knots = np.hstack([events - 1.0, events, events + 1.0])
    else:
        knots = np.hstack([np.zeros((count, 1)), events, np.ones((count, 1))])
    ours = weights @ knots
    place = np.clip(np.searchsorted(ours, shares, side="right") - 1, 0, len(ours) - 2)
    part = (shares - ours[place]) / np.maximum(ours[place + 1] - ours[place], 1e-12)
    return np.asarray(knots[:, place] + part * (knots[:, place + 1] - knots[:, place]))
