"""How far a point of the parameter space lies from what the examples span."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

from motion.errors import MotionError

Array = NDArray[np.float64]

_INSIDE = 1e-9


def outside_hull(examples: Array, point: Array) -> float:
    """Distance of a point (P,) from the convex hull of examples (N, P); 0 inside.

    The hull's nearest point is Σ uᵢ eᵢ / Σ uᵢ for the u ≥ 0 that makes |Σ uᵢ (eᵢ − p)|² +
    (1 − Σ uᵢ)² least (Lawson & Hanson 1974, ch. 23): non-negative least squares, for any set of
    examples, flat ones too.

    Raises:
        MotionError: if the shapes disagree or there is no example.
    """
    if examples.ndim != 2 or not len(examples) or examples.shape[1:] != point.shape:
        raise MotionError(f"Examples {examples.shape} and a point {point.shape} do not agree.")
    towards = (examples - point).T
    system = np.vstack([towards, np.ones(len(examples))])
    wanted = np.append(np.zeros(len(point)), 1.0)
    shares, _ = nnls(system, wanted)
    distance = float(np.linalg.norm(towards @ shares) / shares.sum())
    return distance if distance > _INSIDE else 0.0
