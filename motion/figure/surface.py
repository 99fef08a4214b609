"""The body's skin as a mesh: grown on the grid, settled on the field, put in a compact order."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from motion.figure.body import Body
from motion.figure.field import Shape, gradient
from motion.figure.grid import make_grid
from motion.figure.surface_nets import sample, surface_nets

Array = NDArray[np.float64]
Indices = NDArray[np.intp]

# Metres by which the body is swollen while it meets the grid, so that thin tips reach into a cell;
# the Newton steps bring the vertices back.
_SWELL = 0.002
_ROUNDS = 3  # of evening out, each followed by a Newton step
_EVEN = 0.4  # share of the way to the neighbours' middle
_LAST_STEPS = 2
_LONGEST_STEP = 0.006  # metres; a Newton step at a sharp edge may not leap across it
_RING = 0.0165  # metres: vertices are numbered ring by ring of this height


def grow_surface(body: Body) -> tuple[Array, Array, Indices]:
    """Vertices (V, 3), unit normals (V, 3) and triangles (F, 3) of a body's closed surface."""
    grid = make_grid(body)
    swell = _SWELL * body.trunk.scale
    values = sample(lambda q: body.whole.distance(grid.to_body(q)) - swell, grid.axes, grid.stretch)
    places, quads = surface_nets(values, grid.axes)
    positions = _settled(body.whole, grid.to_body(places), quads)
    normals = gradient(body.whole, positions)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
    triangles = _split(positions, normals, quads)
    order = _ring_order(positions, _RING * body.trunk.scale)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return positions[order], normals[order], _sorted(rank[triangles])


def _settled(shape: Shape, positions: Array, quads: Indices) -> Array:
    """Vertices spread evenly over the surface and lying on it."""
    neighbours = _neighbours(quads, len(positions))
    for _ in range(_ROUNDS):
        slope, lift = _newton(shape, positions)
        away = neighbours @ positions - positions
        normal = slope / np.maximum(np.linalg.norm(slope, axis=1, keepdims=True), 1e-9)
        along = away - np.sum(away * normal, axis=1, keepdims=True) * normal
        flat = np.clip(np.sum(normal * (neighbours @ normal), axis=1, keepdims=True), 0.0, 1.0)
        # At a fingertip's sharp turn, evening out would slide the vertices off the tip.
        positions = positions + lift + _EVEN * flat**6 * along
    for _ in range(_LAST_STEPS):
        positions = positions + _newton(shape, positions)[1]
    return positions


def _newton(shape: Shape, positions: Array) -> tuple[Array, Array]:
    """The field's slope and the step (V, 3) that leads to its zero."""
    slope = gradient(shape, positions)
    square = np.maximum(np.sum(slope * slope, axis=1, keepdims=True), 0.05)
    step = -shape.distance(positions)[:, None] / square * slope
    length = np.linalg.norm(step, axis=1, keepdims=True)
    return slope, step * np.minimum(1.0, _LONGEST_STEP / np.maximum(length, 1e-12))


def _neighbours(quads: Indices, count: int) -> csr_array:
    """(V, V) mean over the vertices at the other ends of a vertex's edges."""
    ends = np.concatenate(
        [np.stack([quads[:, i], quads[:, (i + 1) % 4]], axis=1) for i in range(4)]
    )
    # Every edge of a closed mesh lies in two quads and is listed once in each direction.
    table = csr_array((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(count, count))
    degree: Array = np.asarray(table.sum(axis=1)).ravel()
    table.data /= np.repeat(degree, np.diff(table.indptr))
    return table


def _split(positions: Array, normals: Array, quads: Indices) -> Indices:
    """Triangles (2Q, 3) of quads (Q, 4), along the diagonal that bends the surface less."""
    cost = []
    for a, c in ((0, 2), (1, 3)):
        span = positions[quads[:, c]] - positions[quads[:, a]]
        length = np.linalg.norm(span, axis=1)
        rise = np.abs(np.sum((normals[quads[:, c]] - normals[quads[:, a]]) * span, axis=1))
        cost.append(length + 2.0 * rise)
    turned = np.where((cost[0] <= cost[1] + 1e-9)[:, None], quads, np.roll(quads, -1, axis=1))
    return np.concatenate([turned[:, [0, 1, 2]], turned[:, [0, 2, 3]]], axis=1).reshape(-1, 3)


def _ring_order(positions: Array, height: float) -> Indices:
    """An order in which neighbours in the file are neighbours on the body: it compresses well."""
    ring = np.floor(positions[:, 1] / height)
    round_the_body = np.arctan2(positions[:, 2], positions[:, 0])
    return np.lexsort((round_the_body, ring))


def _sorted(triangles: Indices) -> Indices:
    """The same triangles, each from its lowest vertex on, in rising order."""
    lowest = np.argmin(triangles, axis=1)[:, None]
    turned = np.concatenate(
        [np.take_along_axis(triangles, (lowest + i) % 3, axis=1) for i in range(3)], axis=1
    )
    return turned[np.lexsort(turned.T[::-1])]
