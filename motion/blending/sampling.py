"""Weighted sums of many clips' signals, each at moments of its own, in one product."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

Array = NDArray[np.float64]
Whole = NDArray[np.intp]


def weighted_sums(rows: Array, places: Whole, taps: Array) -> Array:
    """(T, C) sums of rows (R, C): at each of T moments, of those at places (A, T, 4) by taps.

    One sparse matrix by one dense: as fast as the rows come from memory.
    """
    count, each = places.shape[1], places.shape[0] * places.shape[2]
    values, columns = (np.ravel(part.transpose(1, 0, 2)) for part in (taps, places))
    pointer = np.arange(0, (count + 1) * each, each)
    return np.asarray(csr_array((values, columns, pointer), shape=(count, len(rows))) @ rows)


def catmull_rom(at: Array) -> tuple[Whole, Array]:
    """Frames (..., 4) around fractional frames (...), and the cubic's weight of each.

    It goes through every frame without a corner there (Catmull & Rom 1974).
    """
    low = np.floor(at)
    f = at - low
    taps = [
        f * (f * (1.0 - 0.5 * f) - 0.5),
        1.0 + f * f * (1.5 * f - 2.5),
        f * (0.5 + f * (2.0 - 1.5 * f)),
        f * f * (0.5 * f - 0.5),
    ]
    return low.astype(np.intp)[..., None] + np.arange(-1, 3), np.stack(taps, axis=-1)
