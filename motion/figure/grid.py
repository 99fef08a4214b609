"""Where the field is sampled: a box of even steps, seen through lenses at hands, feet and head.

A lens magnifies a ball around a small part, so that one even grid resolves a thumb and still
spends few vertices on a thigh. Grid space is what surface nets see; ``to_body`` leads back.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.figure import profile
from motion.figure.body import Body
from motion.figure.reference import SIDES

Array = NDArray[np.float64]

_STEP = np.array([0.0186, 0.0193, 0.0186])  # metres along x, y, z at the profile's stature
_MARGIN = 0.03  # metres of air around the body
_HAND = (0.086, 0.44, 0.35)  # a lens: radius seen large, size of a step in it, radius of effect
_FOOT = (0.118, 0.66, 0.27)
_HEAD = (0.115, 0.8, 0.22)


@dataclass(frozen=True, eq=False)
class Lens:
    """A ball of grid space that maps to a smaller ball of the body.

    Attributes:
        centre: (3,) metres.
        inner: radius on the body of what is magnified, metres.
        size: body metres per grid metre within.
        outer: radius beyond which nothing changes, metres.
    """

    centre: Array
    inner: float
    size: float
    outer: float

    @property
    def stretch(self) -> float:
        """Largest body metres per grid metre, between the inner and the outer ball."""
        return (self.outer - self.inner) / (self.outer - self.inner / self.size)

    def to_body(self, points: Array) -> Array:
        """Points (N, 3) of grid space on the body."""
        away = points - self.centre
        distance = np.sqrt(np.einsum("ij,ij->i", away, away))
        inside = np.minimum(distance, self.outer)
        moved = np.interp(
            inside, [0.0, self.inner / self.size, self.outer], [0.0, self.inner, self.outer]
        )
        ratio = np.where(distance < self.outer, moved / np.maximum(distance, 1e-9), 1.0)
        return self.centre + away * np.where(distance < 1e-9, self.size, ratio)[:, None]


@dataclass(frozen=True, eq=False)
class Grid:
    """Coordinates along x, y, z in grid space (a multiple of four steps each) and the lenses."""

    axes: tuple[Array, Array, Array]
    lenses: tuple[Lens, ...]

    @property
    def stretch(self) -> float:
        """Largest body metres per grid metre anywhere."""
        return max([1.0, *(lens.stretch for lens in self.lenses)])

    def to_body(self, points: Array) -> Array:
        """Points (N, 3) of grid space on the body."""
        for lens in self.lenses:
            points = lens.to_body(points)
        return points


def make_grid(body: Body) -> Grid:
    """A grid around a body, mirrored left and right, with its lenses."""
    scale = body.trunk.scale
    hands, feet = [], []
    for side in SIDES:
        limb = body.arms[side]
        size = profile.HAND_LENGTH * limb.girth[1]
        hands.append(limb.end.world(np.array([-0.04, 0.52, 0.06]) * size))
        foot = body.feet[side]
        middle = (foot.rings[0].ahead + foot.tip) / 2.0
        feet.append(foot.frame.world(np.array([0.0, 0.035 * scale, middle])))
    head = body.pose.place("head") + np.array([0.0, 0.085, 0.005]) * scale
    lenses = (*_pair(hands, _HAND, scale), *_pair(feet, _FOOT, scale), _lens(head, _HEAD, scale))
    low = np.min([lens.centre - lens.inner / lens.size for lens in lenses], axis=0) - _MARGIN
    high = np.max([lens.centre + lens.inner / lens.size for lens in lenses], axis=0) + _MARGIN
    back = min(body.trunk.centre(height)[2] for height in (-0.04, 0.3)) - 0.14 * scale
    low[2] = min(low[2], back)
    reach = max(-low[0], high[0])
    low[0], high[0] = -reach, reach
    return Grid(_axes(low, high, _STEP * scale), lenses)


def _pair(centres: list[Array], shape: tuple[float, float, float], scale: float) -> list[Lens]:
    """Lenses of a left and a right part, kept from reaching into each other."""
    gap = float(np.linalg.norm(centres[0] - centres[1])) / 2.0
    inner, size, outer = shape
    outer = max(min(outer * scale, gap), 1.25 * inner * scale / size) / scale
    return [_lens(centre, (inner, size, outer), scale) for centre in centres]


def _lens(centre: Array, shape: tuple[float, float, float], scale: float) -> Lens:
    inner, size, outer = shape
    return Lens(centre, inner * scale, size, outer * scale)


def _axes(low: Array, high: Array, steps: Array) -> tuple[Array, Array, Array]:
    """Even coordinates over a box; x is symmetric around zero."""
    counts = (np.ceil((high - low) / steps / 4.0) * 4.0).astype(int)
    spare = counts * steps - (high - low)
    start = low - spare * np.array([0.5, 0.0, 0.5])
    x = (np.arange(counts[0] + 1) - counts[0] / 2) * steps[0]
    y, z = (start[i] + np.arange(counts[i] + 1) * steps[i] for i in (1, 2))
    return x, y, z
