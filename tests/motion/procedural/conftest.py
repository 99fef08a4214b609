"""The sample library, made once for all of its tests."""

from __future__ import annotations

import pytest

from motion.procedural.bodies import BODIES
from motion.procedural.library import sample_clips
from tests.support.gait import Gait


@pytest.fixture(scope="session")
def library():
    """Name of each sample clip to the clip."""
    return {sample.name: sample for sample in sample_clips()}


@pytest.fixture(scope="session")
def gaits(library):
    """Name of each sample clip to its measures."""
    return {
        name: Gait(sample.clip, BODIES[sample.tags["body"]]) for name, sample in library.items()
    }


@pytest.fixture(scope="session")
def neutral(gaits):
    return gaits["set_a_neutral"]
