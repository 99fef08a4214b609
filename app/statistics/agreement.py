"""How far two clusterings of the same items agree."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.statistics.ward import Labels


@dataclass(frozen=True)
class Matched:
    """Which clusters of two solutions correspond, and what is elsewhere.

    Attributes:
        pairs: (cluster of the one, cluster of the other), as many as the fewer have.
        moved: the items (n,) that are not in corresponding clusters.
    """

    pairs: tuple[tuple[int, int], ...]
    moved: NDArray[np.bool_]


def adjusted_rand(one: Labels, other: Labels) -> float:
    """Adjusted Rand index (Hubert & Arabie 1985): 1 for the same groups, 0 on average by chance.

    Args:
        one: clusters of the items (n,).
        other: clusters of the same items in another solution (n,).

    Where chance decides nothing (both put all together, or all apart) it is 1; so it is without
    items.
    """
    table = contingency(one, other)
    both, rows, columns = (
        _couples(counts) for counts in (table, table.sum(axis=1), table.sum(axis=0))
    )
    total = _couples(table.sum())
    chance = rows * columns / total if total else 0.0
    greatest = (rows + columns) / 2
    return (both - chance) / (greatest - chance) if greatest != chance else 1.0


def matching(one: Labels, other: Labels) -> Matched:
    """Pair the clusters of two solutions so that as many items as possible stay together.

    Args:
        one: clusters of the items (n,), from 0.
        other: clusters of the same items in another solution (n,), from 0.
    """
    from scipy.optimize import linear_sum_assignment  # slow to import, as in `ward`

    rows, columns = linear_sum_assignment(contingency(one, other), maximize=True)
    pairs = tuple((int(row), int(column)) for row, column in zip(rows, columns, strict=True))
    stayed = np.zeros(len(one), dtype=bool)
    for row, column in pairs:
        stayed |= (one == row) & (other == column)
    return Matched(pairs, ~stayed)


def contingency(one: Labels, other: Labels) -> NDArray[np.intp]:
    """How many items are in each cluster of the one and each of the other."""
    table = np.zeros((one.max(initial=-1) + 1, other.max(initial=-1) + 1), dtype=np.intp)
    np.add.at(table, (one, other), 1)
    return table


def _couples(counts: NDArray[np.intp] | np.intp) -> float:
    """Pairs of items that can be drawn from groups of these sizes."""
    return float(np.sum(counts * (counts - 1)) / 2)
