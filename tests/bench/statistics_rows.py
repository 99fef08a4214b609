"""How long a bootstrap over participants takes."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from app.services.impression_bootstrap import Order, whole
from app.studies.simulated_impressions import simulated_ratings
from tests.bench.measure import Row, durations

SAMPLES = 1000


def rows(_: Path) -> list[Row]:
    """A thousand samples of fourteen participants who rated set B on all pairs."""
    ratings = simulated_ratings("set_b", np.random.default_rng(1))

    def run() -> object:
        return whole(Order(ratings, 1.0, 0.85, 4, SAMPLES, 2))

    what = f"{SAMPLES} bootstrap samples, 14 × 27 clips × 41 pairs, and 7 numbers of participants"
    return durations(what, {"one processor": run}, aim="≤ 5000")
