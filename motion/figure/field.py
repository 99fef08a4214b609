"""Shapes as distance fields: below zero inside, near the surface the distance in metres.

Every shape answers ``distance(points (N, 3)) -> (N,)`` and knows the box around it. Away from the
surface an ellipse-like shape's value is a first-order estimate, which is what smooth unions and
Newton steps need; far away, beyond any blend, only the box counts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator
from scipy.ndimage import gaussian_filter1d

from motion.figure.profile import FootRing, Ring

Array = NDArray[np.float64]

REACH = 0.12  # metres: beyond this a shape's value is its box's distance; above any blend's radius
_SAMPLES = 1000
_TINY = 1e-9


class Shape(Protocol):
    """Anything with a distance."""

    def distance(self, points: Array) -> Array:
        """Signed distances (N,) of points (N, 3), metres."""
        ...


def smooth_min(a: Array, b: Array, radius: float) -> Array:
    """Union whose crease is filled over ``radius`` (polynomial smooth minimum)."""
    if radius <= 0:
        return np.minimum(a, b)
    h = np.maximum(radius - np.abs(a - b), 0.0)
    return np.minimum(a, b) - h * h / (4.0 * radius)


@dataclass(frozen=True, eq=False)
class Frame:
    """A place and axes (columns of a rotation matrix) in which a shape is described."""

    origin: Array
    axes: Array

    def local(self, points: Array) -> Array:
        """World points (N, 3) in this frame."""
        x, y, z = (points - self.origin).T
        # Spelled out: a matrix product this small costs more in threads than in arithmetic.
        return np.stack([x * a + y * b + z * c for a, b, c in self.axes.T.tolist()], axis=1)

    def world(self, points: Array) -> Array:
        """Points (N, 3) of this frame in the world."""
        return self.origin + points @ self.axes.T


class _Box:
    """The world's axis-aligned box around a box of a frame."""

    def __init__(self, frame: Frame, low: Array, high: Array) -> None:
        self.frame = frame
        middle = frame.world((low + high)[None] / 2.0)[0]
        half = np.abs(frame.axes) @ (high - low) / 2.0
        self.low, self.high = middle - half, middle + half

    def split(self, points: Array) -> tuple[Array, NDArray[np.intp], Array]:
        """Distances to the box (N,), which points are within reach, and those, in the frame."""
        square = np.zeros(len(points))
        for axis in range(3):
            values = points[:, axis]
            gap = np.maximum(np.maximum(self.low[axis] - values, values - self.high[axis]), 0.0)
            square += gap * gap
        near = np.flatnonzero(square < REACH * REACH)
        return np.sqrt(square), near, self.frame.local(points[near])


def _handed_over(box: Array, found: Array) -> Array:
    """A shape's distances, turning into its box's where they leave its reach: no step is felt."""
    share = np.clip(2.0 * box / REACH - 1.0, 0.0, 1.0)
    return found + share * share * (3.0 - 2.0 * share) * (box - found)


class Loft:
    """A stack of super-ellipse rings along y of a frame, with rounded caps.

    Local x is sideways, y along (growing from ring to ring), z forward. ``soften`` (metres) is the
    width over which the profiles' curvature evens out.
    """

    def __init__(
        self, frame: Frame, rings: Sequence[Ring], caps: tuple[float, float], soften: float
    ) -> None:
        self.frame = frame
        at = np.array([ring.at for ring in rings])
        values = np.array([[r.w, r.f, r.b, r.x, r.z, r.n] for r in rings])
        self.start, self.end = float(at[0]), float(at[-1])
        even = np.linspace(self.start, self.end, _SAMPLES)
        self.step = (self.end - self.start) / (_SAMPLES - 1)
        monotone = PchipInterpolator(at, values, axis=0)(even)
        # A monotone cubic's curvature jumps at each ring, which light would show as a band.
        smooth = gaussian_filter1d(monotone, soften / self.step, axis=0, mode="nearest")
        # The ends keep their own shape: a fingertip is no longer than the filter is wide.
        to_end = np.minimum(even - self.start, self.end - even) / (3.0 * soften)
        kept = np.clip(to_end - 0.3, 0.0, 1.0)[:, None]
        table = smooth * kept + monotone * (1.0 - kept)
        taper = np.gradient(table[:, :3], self.step, axis=0) / table[:, :3]
        self.table = np.concatenate([table, taper], axis=1)
        self.round = bool(np.all(values[:, 5] == 2.0))
        self.caps = caps
        reach = np.abs(self.table[:, 3]) + self.table[:, 0]
        depth = np.abs(self.table[:, 4]) + self.table[:, 1:3].max(axis=1)
        low = np.array([-reach.max(), self.start - caps[0], -depth.max()])
        high = np.array([reach.max(), self.end + caps[1], depth.max()])
        self.box = _Box(frame, low, high)

    def distance(self, points: Array) -> Array:
        """Signed distances (N,) of points (N, 3), metres."""
        result, near, local = self.box.split(points)
        if len(near):
            result[near] = _handed_over(result[near], self._near(local))
        return result

    def _near(self, local: Array) -> Array:
        inside = np.clip(local[:, 1], self.start, self.end)
        beyond = local[:, 1] - inside
        position = (inside - self.start) / self.step
        index = np.minimum(position.astype(np.intp), _SAMPLES - 2)
        share = (position - index)[:, None]
        values = self.table[index] * (1.0 - share) + self.table[index + 1] * share
        w, front, back, x, z, n, side_taper, front_taper, back_taper = values.T
        across = local[:, 0] - x
        ahead = local[:, 2] - z
        depth = np.where(ahead > 0, front, back)
        cap = np.where(beyond < 0, self.caps[0], self.caps[1])
        taper = side_taper, np.where(ahead > 0, front_taper, back_taper)
        exponent = None if self.round else n
        return _superellipse(across, beyond, ahead, (w, cap, depth), exponent, taper)


def _superellipse(
    x: Array,
    y: Array,
    z: Array,
    radii: tuple[Array, Array, Array],
    n: Array | None = None,
    taper: tuple[Array, Array] | None = None,
) -> Array:
    """First-order distances to |x/a|ⁿ + |y/b|ⁿ + |z/c|ⁿ = 1: (k − 1) / |∇k|, k the norm.

    Args:
        x: (N,) across, from the centre.
        y: how far beyond the loft's end.
        z: ahead, from the centre.
        radii: a, b, c, each (N,).
        n: (N,) exponents, None for 2.
        taper: growth of a and c along y as a share of themselves, per metre.
    """
    # On the axis itself, where no direction leads out, any sideways one will do.
    parts = [np.abs(x) / radii[0] + _TINY, np.abs(y) / radii[1], np.abs(z) / radii[2] + _TINY]
    if n is None:
        norm = np.sqrt(sum(part * part for part in parts))
        slopes = [part / norm for part in parts]
    else:
        norm = sum(part**n for part in parts) ** (1.0 / n)
        slopes = [(part / norm) ** (n - 1.0) for part in parts]
    square = sum((slope / r) ** 2 for slope, r in zip(slopes, radii, strict=True))
    if taper is not None:
        along = slopes[0] * parts[0] * taper[0] + slopes[2] * parts[2] * taper[1]
        # Far from the surface or beyond the end the slope there says nothing.
        trust = np.maximum(1.0 - parts[1], 0.0) / (1.0 + 4.0 * (norm - 1.0) ** 2)
        square = square + (along * trust) ** 2
    return (norm - 1.0) / np.sqrt(square)


class EllipsoidShape:
    """An ellipsoid along the axes of a frame."""

    def __init__(self, frame: Frame, centre: Array, radii: Array) -> None:
        self.radii = radii
        self.box = _Box(Frame(frame.world(centre), frame.axes), -radii, radii)

    def distance(self, points: Array) -> Array:
        """Signed distances (N,) of points (N, 3), metres."""
        result, near, local = self.box.split(points)
        if len(near):
            x, y, z = local.T
            a, b, c = (np.full(len(near), r) for r in self.radii)
            result[near] = _handed_over(result[near], _superellipse(x, y, z, (a, b, c)))
        return result


class RoundCone:
    """A ball that grows or shrinks on its way from one point to another."""

    def __init__(self, start: Array, end: Array, radii: tuple[float, float]) -> None:
        self.start, self.way = start, end - start
        self.radii = radii
        widest = max(radii)
        low, high = np.minimum(start, end) - widest, np.maximum(start, end) + widest
        self.box = _Box(Frame(np.zeros(3), np.eye(3)), low, high)

    def distance(self, points: Array) -> Array:
        """Signed distances (N,) of points (N, 3), metres."""
        result, near, local = self.box.split(points)
        if len(near):
            from_start = local - self.start
            along = np.einsum("ij,j->i", from_start, self.way)
            share = np.clip(along / np.sum(self.way**2), 0.0, 1.0)
            gap = from_start - share[:, None] * self.way
            radius = self.radii[0] + (self.radii[1] - self.radii[0]) * share
            result[near] = _handed_over(
                result[near], np.sqrt(np.einsum("ij,ij->i", gap, gap)) - radius
            )
        return result


def foot_loft(frame: Frame, rings: Sequence[FootRing], exponent: float, edge: float) -> Loft:
    """Rings along z of a frame whose origin lies on the sole, under the ankle.

    It bulges below the sole, for ``Above`` to cut it flat with an edge rounded by ``edge``.
    """
    # The loft runs along its own y, so the foot's forward becomes y and its up −z.
    turn = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    sections = []
    for ring in rings:
        widest = 0.3 * ring.top  # where a section is widest, above the floor
        below = widest + 1.6 * edge
        sections.append(Ring(ring.ahead, ring.w, below, ring.top - widest, 0.0, -widest, exponent))
    ends = 2.2 * edge, 0.7 * edge
    return Loft(Frame(frame.origin, frame.axes @ turn), sections, ends, 0.4 * edge)


class Above:
    """What of a shape lies above y = 0 of a frame, the cut's edge rounded."""

    def __init__(self, shape: Shape, frame: Frame, edge: float) -> None:
        self.shape, self.frame, self.edge = shape, frame, edge

    def distance(self, points: Array) -> Array:
        """Signed distances (N,) of points (N, 3), metres."""
        above = self.frame.local(points)[:, 1]
        return -smooth_min(-self.shape.distance(points), above, self.edge)


def gradient(shape: Shape, points: Array, step: float = 5e-4) -> Array:
    """Central differences (N, 3) of a shape's distance."""
    count = len(points)
    shifts = np.concatenate([np.eye(3), -np.eye(3)]) * step
    values = shape.distance((points[None] + shifts[:, None]).reshape(-1, 3)).reshape(6, count)
    return ((values[:3] - values[3:]) / (2.0 * step)).T


class Union:
    """Shapes joined one after the other, each to all before it, with its own fillet."""

    def __init__(self, first: Shape, *joined: tuple[Shape, float]) -> None:
        self.first = first
        self.joined = joined

    def distance(self, points: Array) -> Array:
        """Signed distances (N,) of points (N, 3), metres."""
        result = self.first.distance(points)
        for shape, radius in self.joined:
            result = smooth_min(result, shape.distance(points), radius)
        return result
