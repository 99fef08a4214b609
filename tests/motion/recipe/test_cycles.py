"""Cutting cycles and changing bodies by recipe."""

from __future__ import annotations

import numpy as np
import pytest

from motion.editing.cycle_cut import cut_cycle
from motion.errors import RecipeError
from motion.kinematics import forward_kinematics
from motion.recipe import Materials, Recipe, check_recipe
from motion.retargeting import retarget
from motion.rotations import angle_between
from tests.motion.editing.conftest import read
from tests.motion.recipe.strategies import CYCLE, SHORT

ONTO = {"operation": "retarget@1", "parameters": {"clip": CYCLE}}
BOW_HEAD = {"operation": "posture@1", "parameters": {"offsets": [{"pose": "head_down"}]}}


def step(**parameters):
    return [{"operation": "cycle@1", "parameters": parameters}]


@pytest.mark.motions
def test_a_walk_becomes_its_best_cycle(motions_dir):
    walk = read(motions_dir / "bandai-namco/walk_feminine_001.bvh")
    done = Recipe.parse(step()).apply(walk)
    assert done.cyclic
    assert done.content_hash == cut_cycle(walk).content_hash


def test_start_and_end_are_kept_to(knocking):
    done = Recipe.parse(step(start=0.5, end=1.5)).apply(knocking)
    assert done.content_hash == cut_cycle(knocking, 0.5, 1.5).content_hash
    assert done.duration == pytest.approx(1.0, abs=knocking.frame_time)


@pytest.mark.parametrize(
    ("parameters", "told"),
    [
        ({"start": 1.0}, "Only the start"),
        ({"end": 1.0}, "Only the end"),
        ({"start": 2.0, "end": 1.0}, "does not come after"),
    ],
)
def test_one_end_alone_or_ends_in_the_wrong_order_are_refused(parameters, told):
    with pytest.raises(RecipeError, match=told) as raised:
        Recipe.parse(step(**parameters))
    assert raised.value.where[:2] == (0, "parameters")
    assert "neither" in raised.value.mend


def test_what_cannot_be_cut_tells_its_step(samples):
    with pytest.raises(RecipeError, match="give the start and the end") as raised:
        Recipe.parse([BOW_HEAD, *step()]).apply(samples["bow"])
    assert raised.value.where == (1,)


def test_a_motion_is_put_onto_the_other_clip_s_body(knocking, cycle, materials):
    done = Recipe.parse([ONTO]).apply(knocking, materials)
    assert done.skeleton.content_hash == cycle.skeleton.content_hash
    assert done.content_hash == retarget(knocking, cycle).clip.content_hash


def test_edits_go_on_on_the_new_body(knocking, materials):
    """They see how the new body stands, and bow it as deep as its old self."""
    plain = Recipe.parse([ONTO]).apply(knocking, materials)
    after = Recipe.parse([ONTO, BOW_HEAD]).apply(knocking, materials)
    before = Recipe.parse([BOW_HEAD]).apply(knocking, materials)
    turns = []
    for one, other in ((plain, after), (knocking, before)):
        head = [forward_kinematics(c).rotations[:, c.skeleton.roles["head"]] for c in (one, other)]
        turns.append(np.degrees(angle_between(*head)))
    assert turns[0].mean() > 20
    np.testing.assert_allclose(turns[0], turns[1], atol=2)


def test_the_report_compares_bodies_that_are_the_same(knocking, materials):
    recipe = Recipe.parse([ONTO, BOW_HEAD])
    unedited = recipe.unedited(knocking, materials)
    edited = recipe.apply(knocking, materials)
    assert unedited.skeleton.content_hash == edited.skeleton.content_hash
    report = check_recipe(knocking, recipe, materials, edited)
    assert not [finding for finding in report.findings if finding.kind == "foot slip"]


def test_a_cut_on_another_body_is_a_cycle_whichever_comes_first(knocking, cycle):
    materials = Materials(clips={CYCLE: cycle, SHORT: knocking})
    cut = step(start=0.5, end=1.6)
    for steps in ([ONTO, *cut], [*cut, ONTO]):
        done = Recipe.parse(steps).apply(knocking, materials)
        assert done.cyclic
        np.testing.assert_array_equal(done.rotations[0], done.rotations[-1])
