"""Recipes are judged in their own time, and taken back until they break nothing."""

from __future__ import annotations

import pytest

from motion import MotionError
from motion.quality import check
from motion.recipe import Recipe, check_recipe, ease_off_recipe


def one(operation, **parameters):
    return Recipe.parse([{"operation": operation, "parameters": parameters}])


@pytest.mark.parametrize(
    "recipe",
    [
        one("tempo@1", factor=0.6),
        one("tempo@1", factor=1.7),
        one("cut@1", start=1.3, end=3.1),
        one("resample@1", rate=25),
        one("warp_time@1", moments=[{"was": 2.0, "shall": 2.3}]),
        one("vary@1", rhythm=0.5),
    ],
    ids=lambda recipe: recipe.steps[0].operation.name,
)
def test_another_time_alone_is_no_fault(knocking, recipe):
    assert recipe.apply(knocking).content_hash != knocking.content_hash
    assert check_recipe(knocking, recipe).clean


def test_without_the_recipe_a_faster_clip_is_judged_against_a_faster_original(knocking):
    assert check(knocking, one("tempo@1", factor=1.7).apply(knocking)).clean


def test_a_fault_is_found_at_its_time_in_the_edited_clip(knocking):
    sunk = {"operation": "warp@1", "parameters": {"keyframes": [{"time": 1.0, "up": -0.3}]}}
    cut = {"operation": "cut@1", "parameters": {"start": 2.0, "end": 4.0}}
    finding = check_recipe(knocking, Recipe.parse([cut, sunk])).findings[0]
    assert finding.kind == "floor"
    assert 0.4 < finding.start < finding.end < 1.6


def test_a_clean_recipe_is_left_alone(knocking):
    recipe = one("grid@1", path=1.2)
    eased, share, report = ease_off_recipe(knocking, recipe)
    assert (eased.hash, share, report.clean) == (recipe.hash, 1.0, True)


def test_a_recipe_that_breaks_something_is_eased_as_little_as_possible(knocking):
    recipe = Recipe.parse(
        [
            {"operation": "path_length@1", "parameters": {"gain": 2.6}},
            {"operation": "tempo@1", "parameters": {"factor": 1.2}},
        ]
    )
    assert not check_recipe(knocking, recipe).clean
    eased, share, report = ease_off_recipe(knocking, recipe)
    assert report.clean
    assert check_recipe(knocking, eased).clean
    assert 0.0 < share < 1.0
    assert eased.hash == recipe.eased(share).hash
    assert not check_recipe(knocking, recipe.eased(share + 1 / 64)).clean


def test_the_result_at_hand_is_not_made_again(knocking):
    recipe = one("path_length@1", gain=2.6)
    edited = recipe.apply(knocking)
    assert check_recipe(knocking, recipe, edited=edited) == check_recipe(knocking, recipe)


def test_a_body_whose_joints_are_unknown_is_not_judged(incomplete):
    with pytest.raises(MotionError, match="No joint is the"):
        check_recipe(incomplete, one("tempo@1", factor=2))
