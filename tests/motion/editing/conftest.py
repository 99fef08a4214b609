"""Clips to edit: real walks and runs, and the sample library's acted ones."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from motion import Clip
from motion.ingest import IngestOptions, ingest
from motion.procedural.library import sample_clips

WALKS = (
    "active", "angry", "childish", "chimpira", "feminine", "giant", "happy", "masculinity",
    "musical", "normal", "not-confident", "old", "proud", "sad", "tired",
)  # fmt: skip
GOING = [f"bandai-namco/{gait}_{style}_001" for gait in ("walk", "run") for style in WALKS]
GOING += ["cmu/12_01_walk", "cmu/131_01_start_walk_stop"]


@cache
def read(path: Path) -> Clip:
    return ingest(path.read_bytes(), IngestOptions()).clip


@pytest.fixture(params=GOING)
def going(request: pytest.FixtureRequest, motions_dir: Path) -> Clip:
    """Every real walk and run in turn."""
    return read(motions_dir / f"{request.param}.bvh")


@pytest.fixture(params=[style for style in WALKS if style != "musical"])
def walk(request: pytest.FixtureRequest, motions_dir: Path) -> Clip:
    """Every Bandai walk but the slow musical one, whose arms are free of the steps."""
    return read(motions_dir / f"bandai-namco/walk_{request.param}_001.bvh")


@pytest.fixture(scope="session")
def samples() -> dict[str, Clip]:
    return {sample.name: sample.clip for sample in sample_clips()}


@pytest.fixture(params=["acted_female_neutral", "acted_male_neutral"])
def knocking(request: pytest.FixtureRequest, samples: dict[str, Clip]) -> Clip:
    """A few steps, then a knock at a door."""
    return samples[request.param]
