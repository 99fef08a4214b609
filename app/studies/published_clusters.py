"""The pairs that Oshita's participants kept, and the four clusters that Ward's method made of them.

Source: M. Oshita et al., motion interpolation with adjectives, table 2 (motion set A, 27 pairs) and
table 3 (motion set B, 29 pairs).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from app.studies.adjectives import PRIMARY, SCALES

NONE = -1  # the cluster of a pair that was dropped

# Set → primary parameter → pairs, by the ids of the questionnaire's scales.
CLUSTERS: dict[str, dict[str, tuple[str, ...]]] = {
    "set_a": {
        "quickness": ("slow_fast", "dull_quick", "blunt_sharp"),
        "clearness": (
            "weak_strong", "dirty_clean", "uncool_cool", "ugly_cute", "old_young",
            "unstable_stable", "artificial_natural", "vague_distinct", "poor_rich", "drab_clear",
        ),
        "activeness": (
            "calm_excited", "mild_violent", "quiet_noisy", "dormant_brisk", "unpleasant_pleasant",
            "sad_happy", "dark_bright", "simple_gaudy", "heavy_light",
        ),
        "largeness": (
            "small_large", "closed_open", "narrow_broad", "tight_free", "gloomy_cheerful",
        ),
    },
    "set_b": {
        "quickness": ("slow_fast", "dull_quick"),
        "clearness": (
            "drab_clear", "ugly_beautiful", "bumpy_smooth", "uncool_cool", "unstable_stable",
            "ugly_cute", "artificial_natural",
        ),
        "activeness": (
            "simple_gaudy", "closed_open", "lonely_bustling", "sad_happy", "old_young",
            "dim_sharp", "dark_bright", "gloomy_cheerful", "unpleasant_pleasant", "poor_rich",
            "dormant_brisk", "heavy_light",
        ),
        "largeness": (
            "small_large", "narrow_wide", "blunt_sharp", "adult_childish", "calm_excited",
            "quiet_noisy", "mild_violent", "edgy_round",
        ),
    },
}  # fmt: skip


def published(motion_set: str) -> NDArray[np.intp]:
    """The cluster of each of the 41 pairs (41,), by its place in `PRIMARY`; −1 where dropped."""
    names = list(PRIMARY)
    of_pair = {
        pair: names.index(name) for name, pairs in CLUSTERS[motion_set].items() for pair in pairs
    }
    return np.array([of_pair.get(scale["id"], NONE) for scale in SCALES])
