"""Recipes at random give a motion or a clear error, and are read back as they are written."""

from __future__ import annotations

import json
import random

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from motion.errors import RecipeError
from motion.recipe import Recipe
from tests.motion.recipe.strategies import steps

PATIENT = [HealthCheck.too_slow, HealthCheck.function_scoped_fixture]


def read(document):
    try:
        return Recipe.parse(document)
    except RecipeError:
        return Recipe()


def outcome(recipe, clip, materials):
    """The edited clip, or the error."""
    try:
        return recipe.apply(clip, materials)
    except RecipeError as error:
        return error


@given(st.lists(steps(), min_size=1, max_size=2), st.booleans())
@settings(max_examples=120, suppress_health_check=PATIENT)
def test_a_random_recipe_gives_a_motion_or_an_error(short, cycle, materials, document, loops):
    recipe = read(document)
    edited = outcome(recipe, cycle if loops else short, materials)
    if isinstance(edited, RecipeError):
        assert edited.where[0] < len(recipe.steps)
        return
    assert np.isfinite(edited.root_positions).all()
    np.testing.assert_allclose(np.linalg.norm(edited.rotations, axis=-1), 1.0, atol=1e-9)
    assert 1 <= edited.frames <= 200_000


@given(st.lists(steps(), max_size=4), st.randoms())
def test_a_recipe_is_read_back_the_same_whatever_the_order_of_keys(document, shuffled):
    recipe = read(document)
    written = json.loads(json.dumps(in_other_order(recipe.to_list(), shuffled)))
    assert Recipe.parse(written).hash == recipe.hash
    assert json.loads(recipe.canonical_json) == recipe.to_list()


@given(st.lists(steps(), max_size=3), st.floats(0, 1))
def test_an_eased_recipe_is_one_as_well(document, share):
    eased = read(document).eased(share)
    assert read(eased.to_list()).hash == eased.hash


def in_other_order(value, shuffled: random.Random):
    if isinstance(value, list):
        return [in_other_order(entry, shuffled) for entry in value]
    if not isinstance(value, dict):
        return value
    names = list(value)
    shuffled.shuffle(names)
    return {name: in_other_order(value[name], shuffled) for name in names}
