"""Blenders of the sample sets and of real walks, and what tests measure on blends."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from motion import Clip
from motion.blending import Blender
from motion.editing.cycle_cut import cut_cycle
from motion.keytimes import find_keytimes
from motion.procedural.library import set_a, set_b
from motion.retargeting import retarget
from tests.motion.editing.conftest import WALKS, read


@pytest.fixture(scope="session")
def walks_a() -> tuple[Clip, ...]:
    return tuple(sample.clip for sample in set_a())


@pytest.fixture(scope="session")
def walks_b() -> tuple[Clip, ...]:
    return tuple(sample.clip for sample in set_b())


@cache
def real_cycles(folder: Path) -> tuple[Clip, ...]:
    """One cycle of each Bandai walk, and one of a CMU walk on their skeleton."""
    cycles = [cut_cycle(read(folder / f"bandai-namco/walk_{style}_001.bvh")) for style in WALKS]
    other = cut_cycle(read(folder / "cmu/12_01_walk.bvh"))
    return (*cycles, retarget(other, cycles[WALKS.index("normal")]).clip)


@pytest.fixture(scope="session")
def walks_real(motions_dir: Path) -> tuple[Clip, ...]:
    return real_cycles(motions_dir)


@pytest.fixture(params=["walks_a", "walks_b", "walks_real"])
def walks(request: pytest.FixtureRequest) -> tuple[Clip, ...]:
    """Set A, set B and the real walks in turn."""
    found: tuple[Clip, ...] = request.getfixturevalue(request.param)
    return found


def blender_of(clips: tuple[Clip, ...]) -> Blender:
    return Blender(clips, [find_keytimes(clip) for clip in clips])


@pytest.fixture
def blender(walks: tuple[Clip, ...]) -> Blender:
    return blender_of(walks)


@pytest.fixture(scope="session")
def blender_a(walks_a: tuple[Clip, ...]) -> Blender:
    return blender_of(walks_a)


@pytest.fixture(scope="session")
def blender_b(walks_b: tuple[Clip, ...]) -> Blender:
    return blender_of(walks_b)


def mixtures(count: int, examples: int, seed: int = 1) -> np.ndarray:
    """Weights (count, examples) between two examples and among many, in turn."""
    generator = np.random.default_rng(seed)
    found = []
    for number in range(count):
        if number % 2:
            found.append(generator.dirichlet(np.full(examples, generator.choice([0.1, 0.3, 1.0]))))
        else:
            pair = np.zeros(examples)
            share = generator.uniform(0.1, 0.9)
            pair[generator.choice(examples, 2, replace=False)] = share, 1.0 - share
            found.append(pair)
    return np.array(found)


def only(index: int, examples: int) -> np.ndarray:
    """All weight on one example."""
    return np.eye(examples)[index]
