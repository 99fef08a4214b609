"""Clips to measure: the sample library's cycles and real walks."""

from __future__ import annotations

import pytest

from motion import Clip
from motion.procedural.library import set_a, set_b


@pytest.fixture(scope="session")
def cycles() -> dict[str, Clip]:
    """Sets A and B."""
    return {sample.name: sample.clip for sample in (*set_a(), *set_b())}
