"""Clips to judge."""

from __future__ import annotations

from pathlib import Path

import pytest

from motion import Clip
from motion.procedural.library import sample_clips
from tests.motion.editing.conftest import GOING, read


@pytest.fixture(params=GOING)
def going(request: pytest.FixtureRequest, motions_dir: Path) -> Clip:
    """Every real walk and run in turn."""
    return read(motions_dir / f"{request.param}.bvh")


@pytest.fixture(scope="session")
def samples() -> dict[str, Clip]:
    return {sample.name: sample.clip for sample in sample_clips()}


@pytest.fixture
def knocking(samples: dict[str, Clip]) -> Clip:
    """A few steps, then a knock at a door, on both feet."""
    return samples["acted_male_neutral"]
