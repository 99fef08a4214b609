"""Blends as recipes: read with their faults told, and the same motion as the blender's."""

from __future__ import annotations

import numpy as np
import pytest

from motion.blending import Blender
from motion.errors import RecipeError
from motion.keytimes import EVENTS, find_keytimes
from motion.procedural.library import set_a
from motion.recipe import Materials, Recipe, check_recipe

IDS = [letter * 64 for letter in "0123456789"]


@pytest.fixture(scope="module")
def walks():
    return [sample.clip for sample in set_a()]


@pytest.fixture(scope="module")
def supplied(walks):
    return Materials(clips=dict(zip(IDS, walks, strict=True)))


def blend(*examples, **more):
    listed = [{"clip": IDS[index], "weight": weight} for index, weight in examples]
    for name, values in more.items():
        listed[int(name.removeprefix("keytimes"))]["keytimes"] = values
    return [{"operation": "blend@1", "parameters": {"examples": listed}}]


def fault(document):
    with pytest.raises(RecipeError) as raised:
        Recipe.parse(document)
    return raised.value


def test_a_recipe_gives_what_the_blender_gives(walks, supplied):
    recipe = Recipe.parse(blend((0, 0.3), (4, 0.2), (7, 0.5)))
    chosen = [walks[index] for index in (0, 4, 7)]
    expected = Blender(chosen, [find_keytimes(c) for c in chosen]).blend([0.3, 0.2, 0.5])
    assert recipe.apply(walks[0], supplied).content_hash == expected.content_hash


def test_all_examples_are_asked_for(walks):
    recipe = Recipe.parse(blend((0, 0.3), (4, 0.2), (7, 0.0)))
    assert recipe.clips == {IDS[0], IDS[4], IDS[7]}
    with pytest.raises(RecipeError, match="is not there"):
        recipe.apply(walks[0])


def test_an_example_without_weight_changes_nothing(walks, supplied):
    with_it = Recipe.parse(blend((0, 0.5), (4, 0.25), (7, 0.0)))
    without = Recipe.parse(blend((0, 1.0), (4, 0.5)))
    one, other = (recipe.apply(walks[0], supplied) for recipe in (with_it, without))
    assert one.content_hash == other.content_hash
    assert with_it.hash != without.hash


def test_keytimes_that_are_given_count_and_none_mean_even_time(walks, supplied):
    found = find_keytimes(walks[4])
    told = Recipe.parse(blend((0, 0.5), (4, 0.5), keytimes1=found)).apply(walks[0], supplied)
    left_out = Recipe.parse(blend((0, 0.5), (4, 0.5))).apply(walks[0], supplied)
    assert told.content_hash == left_out.content_hash
    shifted = {event: (moment + 0.1) % walks[4].duration for event, moment in found.items()}
    other = Recipe.parse(blend((0, 0.5), (4, 0.5), keytimes1=shifted)).apply(walks[0], supplied)
    assert other.content_hash != told.content_hash
    even = Recipe.parse(blend((0, 0.5), (4, 0.5), keytimes0={}, keytimes1={}))
    expected = Blender([walks[0], walks[4]]).blend([0.5, 0.5])
    assert even.apply(walks[0], supplied).content_hash == expected.content_hash


def test_what_a_blend_is_made_of_is_read_and_bounded():
    read = Recipe.parse(blend((0, 1), keytimes0={"left_strike": 1})).to_list()
    example = read[0]["parameters"]["examples"][0]
    assert example["keytimes"] == dict.fromkeys(EVENTS) | {"left_strike": 1.0}
    assert fault(blend()).message == "“Examples” has 0 entries."
    assert "65 entries" in fault(blend(*[(0, 1.0)] * 65)).message
    assert fault(blend((0, 1.5))).where == (0, "parameters", "examples", 0, "weight")
    assert "All weights are 0" in fault(blend((0, 0.0), (1, 0.0))).message
    wrong = fault(blend((0, 1.0), keytimes0={"left_heel": 0.1}))
    assert "Did you mean" in wrong.mend or "Choose from" in wrong.mend


def test_clips_that_do_not_fit_are_refused_with_the_step(walks, short, supplied):
    recipe = Recipe.parse(blend((0, 0.5), (1, 0.5)))
    with pytest.raises(RecipeError, match="different ones: retarget") as raised:
        recipe.apply(short, supplied)
    assert raised.value.where == (0,)
    late = Recipe.parse(blend((0, 0.5), (1, 0.5), keytimes1={"left_strike": 30.0}))
    with pytest.raises(RecipeError, match="left strike at 30 s is not within"):
        late.apply(walks[0], supplied)


def test_a_blend_can_be_edited_further_and_is_judged_in_its_own_time(walks, supplied):
    steps = blend((0, 0.4), (6, 0.6))
    assert check_recipe(walks[0], Recipe.parse(steps), supplied).clean
    steps.append({"operation": "tempo@1", "parameters": {"factor": 1.25}})
    edited = Recipe.parse(steps).apply(walks[0], supplied)
    plain = Recipe.parse(steps[:1]).apply(walks[0], supplied)
    assert edited.duration == pytest.approx(plain.duration / 1.25, abs=edited.frame_time)
    assert np.isfinite(edited.rotations).all()


def test_a_blend_that_would_be_too_long_is_refused_before_it_is_made(walks, supplied, monkeypatch):
    monkeypatch.setattr("motion.recipe.operation.MAX_FRAMES", 20)
    with pytest.raises(RecipeError, match="at most 20"):
        Recipe.parse(blend((0, 0.4), (6, 0.6))).apply(walks[0], supplied)
