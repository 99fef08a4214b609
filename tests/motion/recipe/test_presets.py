"""What presets intend can be measured, and the page that says so is up to date."""

from __future__ import annotations

import re

import numpy as np
import pytest

from app.studies.emotion import SCALES
from motion.editing.tempo import resample_rate
from motion.recipe import PRESETS, check_recipe
from motion.rotations import angle_between
from tests.motion.editing.conftest import read
from tests.support import preset_table
from tests.support.preset_features import measure
from tests.support.preset_table import INTENDED, MORE

FIGURE_29 = {
    "afraid", "angry", "energetic_sadness", "excited", "feminine", "happy", "masculine", "relaxed",
    "sad", "strong", "tired", "weak",
}  # fmt: skip
PROPOSALS = {"angry_at_contacts", "excited_faster", "relaxed_slower", "nervous"}


@pytest.fixture(scope="module")
def table():
    return preset_table.all_rows()


def test_the_presets_are_the_thesis_s_twelve_and_four_proposals():
    assert set(PRESETS) == FIGURE_29 | PROPOSALS
    assert len({preset.operations.hash for preset in PRESETS.values()}) == len(PRESETS)


def test_every_preset_names_a_pole_of_the_questionnaire():
    poles = {scale["id"]: {scale[side]["en"] for side in ("left", "right")} for scale in SCALES}
    for preset in PRESETS.values():
        assert preset.pole in poles[preset.axis]


def test_presets_need_nothing_from_outside():
    for preset in PRESETS.values():
        assert not preset.operations.poses
        assert not preset.operations.clips


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_shows_what_it_intends_on_both_bodies(name, table):
    wrong = [row.text for row in table[name] if not row.shown]
    assert not wrong
    assert len(table[name]) == 7


@pytest.mark.motions
@pytest.mark.parametrize("name", [name for name, way in INTENDED.items() if way])
@pytest.mark.parametrize("walk", ["normal", "feminine"])
def test_a_preset_shows_what_it_intends_on_real_walks(name, walk, motions_dir):
    clip = read(motions_dir / "bandai-namco" / f"walk_{walk}_001.bvh")
    before = measure(clip)
    after = measure(PRESETS[name].operations.apply(clip), clip)
    for feature, way in INTENDED[name].items():
        change = after[feature] - before[feature]
        assert change > 0 if way == MORE else change < 0, (feature, before, after)


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_breaks_next_to_nothing_on_the_neutral_clips(name):
    """At most one fault, and that hardly beyond its limit."""
    for body, clip in preset_table.neutral_clips().items():
        findings = check_recipe(clip, PRESETS[name].operations).findings
        assert len(findings) <= 1, (body, findings)
        assert all(found.size < 1.25 * found.limit for found in findings), (body, findings)


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_is_the_same_motion_at_any_frame_rate(name):
    """At 30, 60 and 120 frames a second, poses within 2° on the mean."""
    slow = resample_rate(preset_table.neutral_clips()["man"], 30.0)
    recipe = PRESETS[name].operations
    expected = recipe.apply(slow)
    for rate in (60.0, 120.0):
        edited = resample_rate(recipe.apply(resample_rate(slow, rate)), 30.0)
        frames = min(edited.frames, expected.frames)
        assert abs(edited.frames - expected.frames) <= 1
        off = angle_between(edited.rotations[:frames], expected.rotations[:frames])
        assert np.degrees(np.sqrt(np.mean(off**2))) < 2.0


def test_the_page_says_what_the_code_gives():
    """Numbers may differ by rounding; a machine's arithmetic is its own."""
    written, made = preset_table.PAGE.read_text(encoding="utf-8"), preset_table.page()
    number = re.compile(r"[-+]?\d+(?:\.\d+)?")
    assert number.sub("#", written) == number.sub("#", made)
    for was, now in zip(number.findall(written), number.findall(made), strict=True):
        digits = len(was.partition(".")[2])
        assert float(was) == pytest.approx(float(now), abs=1.01 * 10**-digits)
