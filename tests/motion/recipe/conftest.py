"""Clips that recipes are tried on, and materials for every reference that tests make."""

from __future__ import annotations

from dataclasses import replace

import pytest

from motion import Clip
from motion.editing.posture import capture_pose
from motion.editing.tempo import cut
from motion.procedural.library import sample_clips
from motion.recipe import Materials
from tests.motion.recipe.strategies import CYCLE, OTHER_CYCLE, POSE, SHORT


@pytest.fixture(scope="session")
def samples() -> dict[str, Clip]:
    return {sample.name: sample.clip for sample in sample_clips()}


@pytest.fixture(scope="session")
def knocking(samples) -> Clip:
    """Steps up to a door and a knock."""
    return samples["acted_male_neutral"]


@pytest.fixture(scope="session")
def cycle(samples) -> Clip:
    return samples["set_a_neutral"]


@pytest.fixture(scope="session")
def short(knocking) -> Clip:
    """One second of walking."""
    return cut(knocking, 1.0, 2.0)


@pytest.fixture(scope="session")
def materials(samples, short, cycle) -> Materials:
    clips = {CYCLE: cycle, OTHER_CYCLE: samples["set_a_sad"], SHORT: short}
    return Materials({POSE: capture_pose(short, 7)}, clips)


@pytest.fixture(scope="session")
def incomplete(short) -> Clip:
    """A body of which only the arms are known."""
    arms = {role: joint for role, joint in short.skeleton.roles.items() if "arm" in role}
    return replace(short, skeleton=short.skeleton.with_roles(arms))
