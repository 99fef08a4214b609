"""From a distance field to a closed mesh: surface nets on a grid of uneven steps.

One vertex in every cell that the surface crosses, at the mean of the crossings of its edges, and
one quad around every crossed edge (Gibson, "Constrained elastic surface nets", 1998).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Field = Callable[[Array], Array]

_COARSE = 4  # fine steps in a coarse one
_CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
_EDGES = [
    (a, b)
    for a in range(8)
    for b in range(a + 1, 8)
    if int(np.abs(_CORNERS[a] - _CORNERS[b]).sum()) == 1
]


def sample(field: Field, axes: tuple[Array, Array, Array], slope: float = 1.0) -> Array:
    """A field's values (X, Y, Z) on a grid, exact near the surface, right in sign elsewhere.

    Args:
        field: distances (N,) of points (N, 3).
        axes: coordinates along x, y and z; each has a multiple of four steps.
        slope: how fast the field can change per metre of the grid.
    """
    coarse = tuple(axis[::_COARSE] for axis in axes)
    values = field(_points(coarse)).reshape([len(axis) for axis in coarse])
    steps = [np.diff(axis) for axis in coarse]
    half = 0.5 * np.sqrt(
        steps[0][:, None, None] ** 2 + steps[1][None, :, None] ** 2 + steps[2] ** 2
    )
    nearest = np.min(np.abs(_corners(values)), axis=0)
    active = nearest < 1.25 * slope * half
    fine = _spread(values)
    mask = np.zeros(fine.shape, bool)
    blocks = _blow_up(active)
    for x, y, z in _CORNERS:
        shape = blocks.shape
        mask[x : x + shape[0], y : y + shape[1], z : z + shape[2]] |= blocks
    where = np.nonzero(mask)
    fine[where] = field(np.stack([axis[i] for axis, i in zip(axes, where, strict=True)], axis=1))
    return fine


def _points(axes: tuple[Array, ...]) -> Array:
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)


def _corners(values: NDArray[np.generic]) -> NDArray[np.generic]:
    """(8, X − 1, Y − 1, Z − 1) the values at the corners of every cell."""
    x, y, z = (size - 1 for size in values.shape)
    return np.stack([values[i : i + x, j : j + y, k : k + z] for i, j, k in _CORNERS])


def _blow_up(blocks: NDArray[np.generic]) -> NDArray[np.generic]:
    for axis in range(3):
        blocks = np.repeat(blocks, _COARSE, axis=axis)
    return blocks


def _spread(values: Array) -> Array:
    """Coarse values on the fine grid: each fine node takes the coarse node before it."""
    blown = _blow_up(values)
    x, y, z = ((size - 1) * _COARSE + 1 for size in values.shape)
    return np.ascontiguousarray(blown[:x, :y, :z])


def surface_nets(values: Array, axes: tuple[Array, Array, Array]) -> tuple[Array, NDArray[np.intp]]:
    """Vertices (V, 3) and quads (Q, 4), counter-clockwise from outside, of the zero surface.

    The result is a closed manifold: grid nodes whose signs would pinch it are flipped first.
    """
    values = _without_pinches(values)
    inside = values < 0
    corners = _corners(inside)
    crossed = corners.any(axis=0) & ~corners.all(axis=0)
    cells = np.argwhere(crossed)
    ids = np.full(crossed.shape, -1, np.intp)
    ids[crossed] = np.arange(len(cells))
    return _vertices(values, axes, cells), _quads(inside, ids)


def _vertices(values: Array, axes: tuple[Array, Array, Array], cells: NDArray[np.intp]) -> Array:
    nodes = cells[:, None] + _CORNERS
    level = values[tuple(np.moveaxis(nodes, -1, 0))]
    places = np.stack([axis[nodes[..., i]] for i, axis in enumerate(axes)], axis=-1)
    total = np.zeros((len(cells), 3))
    count = np.zeros((len(cells), 1))
    for a, b in _EDGES:
        crossing = ((level[:, a] < 0) != (level[:, b] < 0))[:, None]
        gap = level[:, a] - level[:, b]
        share = (level[:, a] / np.where(gap == 0, 1.0, gap))[:, None]
        total += np.where(crossing, places[:, a] + share * (places[:, b] - places[:, a]), 0.0)
        count += crossing
    return total / count


def _quads(inside: Flags, ids: NDArray[np.intp]) -> NDArray[np.intp]:
    faces = []
    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        sign = np.moveaxis(inside, (axis, b, c), (0, 1, 2))[:, 1:-1, 1:-1]
        cell = np.moveaxis(ids, (axis, b, c), (0, 1, 2))
        around = np.stack(
            [cell[:, :-1, :-1], cell[:, 1:, :-1], cell[:, 1:, 1:], cell[:, :-1, 1:]], axis=-1
        )
        leaving = sign[:-1] & ~sign[1:]
        entering = ~sign[:-1] & sign[1:]
        faces += [around[leaving], around[entering][:, ::-1]]
    return np.concatenate(faces)


def _without_pinches(values: Array) -> Array:
    """The field with signs flipped where two sheets would touch in one cell or face."""
    values = values.copy()
    for _ in range(20):
        pinched = _pinched_nodes(values)
        if not pinched.any():
            break
        values[pinched] = 1e-6  # an outside node parts the sheets
    return values


def _pinched_nodes(values: Array) -> Flags:
    """Inside nodes of faces with a checkerboard of signs, and of cells crossed corner to corner."""
    inside = values < 0
    found = np.zeros(values.shape, bool)
    for axis in range(3):
        view = np.moveaxis(inside, axis, 2)
        mark = np.moveaxis(found, axis, 2)
        a, b, c, d = view[:-1, :-1], view[1:, :-1], view[:-1, 1:], view[1:, 1:]
        checker = (a == d) & (b == c) & (a != b)
        for x in (0, 1):
            for y in (0, 1):
                part = mark[x : x + checker.shape[0], y : y + checker.shape[1]]
                part |= checker & view[x : x + checker.shape[0], y : y + checker.shape[1]]
    corners = _corners(inside)
    count = corners.sum(axis=0)
    for first in range(4):
        pair = corners[first] == corners[7 - first]
        lone = pair & (((count == 2) & corners[first]) | ((count == 6) & ~corners[first]))
        for x, y, z in _CORNERS:
            sx, sy, sz = lone.shape
            part = found[x : x + sx, y : y + sy, z : z + sz]
            part |= lone & inside[x : x + sx, y : y + sy, z : z + sz]
    return found
