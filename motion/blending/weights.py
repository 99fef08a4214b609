"""From a point of the parameter space to the weights of the examples."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.errors import MotionError

Array = NDArray[np.float64]

_SAME = 1e-10  # examples no farther apart than this are one point
# Of the usual distance to the nearest example: a direction in which all examples together spread
# less than this is left to the radial part, or the linear part would be steep along it.
_FLAT = 0.35
_WIDEST, _NARROWEST, _STEPS = 2.0, 1.0, 5  # reach of a radial basis, in nearest distances
_CALM = 2.0  # the greatest sum of a basis' coefficients, up to which its reach is taken


@dataclass(frozen=True, eq=False)
class WeightMap:
    """Weights of N examples at any point of a P-dimensional parameter space.

    At an example's own parameters its weight is 1; examples with equal parameters share it.
    Everywhere else the weights are not negative, sum to 1 and are continuous.

    Oshita et al. (eq. 7), after Rose, Cohen & Bodenheimer (1998):
    wᵢ(p) = Σⱼ lᵢⱼ Lⱼ(p) + Σₖ rᵢₖ Rₖ(p) with L₀ = 1 and Lⱼ(p) = pⱼ. The linear part is the least
    squares fit, the smallest of several, to 1 at example i and 0 at the others; Rₖ(p) is a cubic
    B-spline of the distance from example k, 1 there and 0 from one to two times the distance to its
    nearest neighbour on; r takes out what the linear part leaves. Then wᵢ is clipped to [0, 1] and
    the weights are normalised.

    The clipped weights cannot all vanish: before clipping they sum to 1 everywhere, because the
    linear parts fit a constant exactly and so nothing is left of their sum for the radial parts.
    Clipping at 0 takes away negative ones only, so their sum is at least 1 before it is divided by.

    Attributes:
        notes: what is particular about these examples, in plain sentences.
    """

    notes: tuple[str, ...]
    _places: Array  # (M, P) the distinct examples
    _member: NDArray[np.intp]  # (N,) which of them each example is
    _share: Array  # (N,) of its place's weight
    _middle: Array  # (P,)
    _linear: Array  # (M, 1 + P): a constant, then per parameter from the middle
    _radial: Array  # (M, M)
    _reach: Array  # (M,)

    @classmethod
    def fit(cls, examples: Array) -> WeightMap:
        """The map of examples (N, P) with parameters in [0, 1].

        Raises:
            MotionError: if there is no example or a number is not finite.
        """
        examples = np.asarray(examples, dtype=float)
        if examples.ndim != 2 or not len(examples) or not np.isfinite(examples).all():
            raise MotionError(
                f"Weights need at least one example with finite parameters, as an array "
                f"(examples, parameters); this one has the shape {examples.shape}."
            )
        first, member = _distinct(examples)
        places = examples[first]
        nearest = _nearest(places)
        linear, flat = _linear_part(places, nearest)
        left = np.eye(len(places)) - linear @ _basis(places - places.mean(axis=0)).T
        radial, reach = _radial_part(places, nearest, left)
        share = 1.0 / np.bincount(member)[member]
        notes = _notes(examples, member, flat)
        middle = places.mean(axis=0)
        return cls(notes, places, member, share, middle, linear, radial, reach)

    def weights(self, point: Array) -> Array:
        """Weights (N,) at a point (P,), or (..., N) at points (..., P)."""
        point = np.asarray(point, dtype=float)
        if point.shape[-1:] != self._middle.shape:
            raise MotionError(
                f"The space has {len(self._middle)} parameters; the point has the shape "
                f"{point.shape}."
            )
        distance = np.linalg.norm(point[..., None, :] - self._places, axis=-1)
        raw = _basis(point - self._middle) @ self._linear.T
        raw += _spline(distance / self._reach) @ self._radial.T
        clipped = np.clip(raw, 0.0, 1.0)
        weights = clipped / clipped.sum(axis=-1, keepdims=True)
        return np.asarray(weights[..., self._member] * self._share)


def _distinct(examples: Array) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Which examples (M,) are the first with their parameters, and whose each (N,) shares."""
    far = np.linalg.norm(examples[:, None] - examples, axis=-1) > _SAME
    first, member = np.unique(np.argmin(far, axis=1), return_inverse=True)
    return first.astype(np.intp), member.astype(np.intp)


def _nearest(places: Array) -> Array:
    """Distance (M,) of each place from its nearest neighbour; 1 for a lonely one."""
    if len(places) == 1:
        return np.ones(1)
    distances = np.linalg.norm(places[:, None] - places, axis=-1)
    np.fill_diagonal(distances, np.inf)
    return np.asarray(distances.min(axis=1))


def _linear_part(places: Array, nearest: Array) -> tuple[Array, int]:
    """Coefficients (M, 1 + P) of the smallest least squares fit, and how many directions it lacks.

    Along a direction in which the places spread by σ (the root of their squares' sum) a weight
    changes by at most 1/σ.
    """
    centred = places - places.mean(axis=0)
    u, sigma, v = np.linalg.svd(centred, full_matrices=False)
    kept = sigma > _FLAT * np.median(nearest)
    slopes = (u[:, kept] / sigma[kept]) @ v[kept]
    constant = np.full((len(places), 1), 1.0 / len(places))
    return np.hstack([constant, slopes]), places.shape[1] - int(kept.sum())


def _radial_part(places: Array, nearest: Array, left: Array) -> tuple[Array, Array]:
    """Coefficients (M, M) and reaches (M,) of the radial bases that make up for what is left.

    With the narrowest reach no basis touches another example, and the coefficients are what is
    left itself. Wider ones are smoother, but may need large coefficients that cancel each other.
    """
    distances = np.linalg.norm(places[:, None] - places, axis=-1)
    calm = _CALM * max(float(np.abs(left).sum(axis=0).max()), 0.5)
    for times in np.linspace(_WIDEST, _NARROWEST, _STEPS)[:-1]:
        values = _spline(distances / (times * nearest))  # example, basis
        if np.linalg.cond(values) < 1e3:
            radial = np.asarray(np.linalg.solve(values, left.T).T, dtype=np.float64)
            if np.abs(radial).sum(axis=0).max() <= calm:
                return radial, times * nearest
    return left, _NARROWEST * nearest


def _basis(points: Array) -> Array:
    """(..., 1 + P): one, then the parameters."""
    return np.concatenate([np.ones((*points.shape[:-1], 1)), points], axis=-1)


def _spline(share: Array) -> Array:
    """The cubic B-spline with 1 in its middle and 0 from ``share`` 1 on."""
    x = 2.0 * share
    inner = 1.0 - 1.5 * x**2 + 0.75 * x**3
    outer = 0.25 * np.maximum(2.0 - x, 0.0) ** 3
    return np.where(x < 1.0, inner, outer)


def _notes(examples: Array, member: NDArray[np.intp], flat: int) -> tuple[str, ...]:
    count, parameters = examples.shape
    notes = []
    if count == 1:
        notes.append("There is only one example: it has all the weight everywhere.")
    same = count - len(np.unique(member))
    if same and count > 1:
        notes.append(
            "Some examples have equal parameters: they share one weight, and no setting tells "
            "them apart."
        )
    constant = int((np.ptp(examples, axis=0) <= _SAME).sum())
    if constant and same < count - 1:
        what = "One parameter is" if constant == 1 else f"{constant} parameters are"
        notes.append(f"{what} equal for all examples and can only lead away from them.")
    if count > 1 and parameters >= count:
        notes.append(
            f"There are {parameters} parameters but only {count} examples: many settings lie far "
            "from every example."
        )
    elif count > 1 and flat > constant:
        notes.append(
            "Some parameters go together in all examples: settings that part them lie far from "
            "every example."
        )
    if 0 < same == count - 1:
        notes.append("All examples have the same parameters: the weights are equal everywhere.")
    return tuple(notes)
