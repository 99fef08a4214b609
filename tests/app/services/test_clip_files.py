"""What the library keeps of a clip."""

from __future__ import annotations

from itertools import chain

import pytest

from app.schemas.library import ImportOptions
from app.services.clip_files import measure_stature
from app.services.imports import read_motion
from motion.clip import Clip
from motion.procedural.bodies import BODIES
from motion.procedural.library import acted, set_a
from tests.support.motions import walk
from tests.support.other_bodies import stranger_bvh


def test_a_body_is_as_tall_as_it_was_built_in_each_of_its_clips() -> None:
    tall: dict[str, set[float]] = {}
    for sample in chain(acted(), set_a()):
        height = round(measure_stature(sample.clip), 2)
        tall.setdefault(sample.clip.skeleton.content_hash, set()).add(height)
    assert all(len(heights) == 1 for heights in tall.values())
    built = sorted(body.stature for body in BODIES.values())
    assert sorted(chain(*tall.values())) == pytest.approx(built, abs=0.02)


def test_the_report_of_an_import_and_its_clip_tell_the_same_height() -> None:
    motion = read_motion(stranger_bvh(), ImportOptions())
    assert motion.files.stature == pytest.approx(motion.report["stature"], abs=1e-9)


def test_a_body_without_roles_is_as_tall_as_it_stands() -> None:
    clip = walk()
    bare = Clip(clip.skeleton.with_roles({}), clip.root_positions, clip.rotations, clip.frame_time)
    assert measure_stature(bare) == pytest.approx(measure_stature(clip), abs=0.1)
