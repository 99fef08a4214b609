"""What legs and pelvis do in a step cycle, as published means in a few Fourier terms.

Phase 0 is the contact of the own foot, 1 its next contact. Pelvis signals are for the left cycle.

Source of the curves: Schwartz, Rozumalski, Trost (2008), J Biomech 41:1639, free walking speed.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# mean, then (harmonic, amplitude, phase of its first peak in %), degrees.
# Foot: toe up positive, flat 0. Knee: 0 straight. Yaw: left side forward. Roll: left side up.
_PUBLISHED: dict[str, tuple[float, tuple[tuple[int, float, float], ...]]] = {
    "pelvis_yaw": (0.0, ((1, 4.3, 8), (3, 0.5, 29), (5, 0.3, 19))),
    "pelvis_roll": (0.0, ((1, 2.8, 14), (3, 1.2, 16))),
    "knee": (22.9, ((1, 18.8, 73), (2, 15.3, 21), (3, 4.4, 9))),
    "foot": (-15.3, ((1, 30.6, 13), (2, 18.6, 42), (3, 4.4, 19), (4, 2.8, 24), (5, 1.9, 15))),
}

TOE_OFF = 0.61  # phase at which the published foot leaves the ground


def signal(name: str, phase: Array) -> Array:
    """A published signal in degrees at ``phase`` (...), counted in cycles."""
    mean, terms = _PUBLISHED[name]
    value = np.full(np.shape(phase), mean)
    for harmonic, amplitude, peak in terms:
        value += wave(phase, amplitude, peak, harmonic)
    return value


def wave(phase: Array, amplitude: float, peak: float, harmonic: int = 1) -> Array:
    """One harmonic at ``phase`` (...) in cycles, highest at ``peak`` % of the cycle."""
    value: Array = amplitude * np.cos(2.0 * np.pi * harmonic * (phase - peak / 100.0))
    return value


def smooth_step(x: Array) -> Array:
    """From 0 at x ≤ 0 to 1 at x ≥ 1 with no corner in speed or acceleration."""
    t = np.clip(x, 0.0, 1.0)
    value: Array = t**3 * (t * (6.0 * t - 15.0) + 10.0)
    return value
