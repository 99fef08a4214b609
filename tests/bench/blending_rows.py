"""Blending: weights from parameters, and the motion between 27 examples."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from motion.blending import Blender, WeightMap
from motion.keytimes import find_keytimes
from motion.procedural.library import set_b
from tests.bench.measure import Row, durations

PARAMETERS = 10


def rows(_: Path) -> list[Row]:
    """All rows about blending; set B, all of its examples mixed."""
    clips = [sample.clip for sample in set_b()]
    keytimes = [find_keytimes(clip) for clip in clips]
    generator = np.random.default_rng(1)
    examples = generator.uniform(size=(len(clips), PARAMETERS))
    weights, blender = WeightMap.fit(examples), Blender(clips, keytimes)
    point, even = generator.uniform(size=PARAMETERS), np.ones(len(clips))
    what = f"{len(clips)} examples"
    return [
        *durations(
            f"Coefficients, {what} × {PARAMETERS} parameters",
            {"Manner": lambda: WeightMap.fit(examples)},
            aim="≤ 5",
        ),
        *durations(f"Weights at a point, {what}", {"Manner": lambda: weights.weights(point)}),
        *durations(f"Blend of {what}", {"Manner": lambda: blender.blend(even)}, aim="≤ 6"),
    ]
