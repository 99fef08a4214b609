"""A recipe is read from JSON: canonical, hashed, its faults told with their place."""

import hashlib
import json
import math

import pytest

from motion.errors import RecipeError
from motion.recipe import MAX_STEPS, OPERATIONS, Recipe

ID = "0123456789abcdef" * 4


def step(operation, **parameters):
    return {"operation": operation, "parameters": parameters}


def fault(document):
    with pytest.raises(RecipeError) as raised:
        Recipe.parse(document)
    return raised.value


def test_defaults_are_filled_in_and_numbers_become_floats():
    recipe = Recipe.parse([{"operation": "grid@1"}, step("tempo@1", factor=2)])
    assert recipe.to_list() == [
        {"operation": "grid@1", "parameters": {"path": 1.0, "timing": 1.0}},
        {"operation": "tempo@1", "parameters": {"factor": 2.0}},
    ]
    assert isinstance(recipe.to_list()[1]["parameters"]["factor"], float)


def test_the_same_recipe_written_otherwise_has_the_same_hash():
    one = Recipe.parse([step("grid@1", path=0, timing=2)])
    other = Recipe.parse([{"parameters": {"timing": 2.0, "path": -0.0}, "operation": "grid@1"}])
    assert one.canonical_json == other.canonical_json
    assert one.hash == other.hash
    assert one.hash == hashlib.sha256(one.canonical_json.encode()).hexdigest()
    assert one.hash != Recipe.parse([step("grid@1", path=0, timing=1)]).hash
    assert one.canonical_json == ('[{"operation":"grid@1","parameters":{"path":0.0,"timing":2.0}}]')


def test_the_order_of_steps_matters():
    steps = [step("grid@1", path=2), step("tempo@1", factor=2)]
    assert Recipe.parse(steps).hash != Recipe.parse(steps[::-1]).hash


def test_what_is_given_out_is_a_copy():
    recipe = Recipe.parse([step("bands@1", gains=[{"frequency": 1, "gain": 2}])])
    before = recipe.hash
    recipe.to_list()[0]["parameters"]["gains"].clear()
    assert Recipe.parse(recipe.to_list()).hash == before


@pytest.mark.parametrize(
    "value", [True, "1", None, [1], {}, math.nan, math.inf, -math.inf, -0.01, 2.01, 10**400]
)
def test_a_number_out_of_range_or_of_another_kind_names_its_place_and_range(value):
    error = fault([step("tempo@1"), step("grid@1", path=value)])
    assert error.where == (1, "parameters", "path")
    assert "Path length" in error.message
    assert error.mend == "Give a number from 0 to 2."
    error.message.encode()


@pytest.mark.parametrize("value", [1.5, -1, 2**32, True, "7"])
def test_a_seed_is_a_whole_number(value):
    assert fault([step("vary@1", seed=value)]).where == (0, "parameters", "seed")
    assert Recipe.parse([step("vary@1", seed=7.0)]).to_list()[0]["parameters"]["seed"] == 7


def test_an_unknown_operation_is_told_with_those_like_it():
    error = fault([step("posture@1", offsets=[]), step("pathlength@1", gain=2)])
    assert error.where == (1, "operation")
    assert "Step 2" in error.message
    assert "pathlength@1" in error.message
    assert error.mend == "Did you mean path_length@1?"


def test_a_version_that_does_not_exist_is_unknown():
    assert "grid@1" in fault([step("grid@2")]).mend


def test_an_unknown_parameter_is_told_with_those_like_it():
    error = fault([step("grid@1", timming=1.0)])
    assert "timming" in error.message
    assert error.mend == "Did you mean timing?"


def test_a_missing_parameter_is_named():
    error = fault([step("posture@1")])
    assert error.where == (0, "parameters", "offsets")
    assert fault([step("resample@1")]).where == (0, "parameters", "rate")


def test_a_fault_deep_inside_is_told_with_the_way_to_it():
    offsets = [{"pose": "head_down"}, {"pose": "head_down", "amount": 3}]
    error = fault([step("posture@1", offsets=offsets)])
    assert error.where == (0, "parameters", "offsets", 1, "amount")
    assert error.mend == "Give a number from -2 to 2."


@pytest.mark.parametrize("document", [None, 3, "grid@1", {}, {"operation": "grid@1"}, [[]], [3]])
def test_what_is_no_list_of_steps_is_refused(document):
    assert fault(document).mend.startswith("Give ")


def test_a_step_has_nothing_else():
    assert "note" in fault([{"operation": "grid@1", "note": "x"}]).message
    assert "names no operation" in fault([{"parameters": {}}]).message


def test_a_recipe_that_is_too_long_is_refused():
    steps = [step("grid@1")] * MAX_STEPS
    assert len(Recipe.parse(steps).steps) == MAX_STEPS
    assert str(MAX_STEPS) in fault([*steps, step("grid@1")]).mend


def test_a_list_that_is_too_long_is_refused():
    gains = [{"frequency": 1 + place, "gain": 1} for place in range(25)]
    assert Recipe.parse([step("bands@1", gains=gains[:24])])
    assert fault([step("bands@1", gains=gains)]).where == (0, "parameters", "gains")


@pytest.mark.parametrize(
    ("operation", "parameters"),
    [
        ("cut@1", {"start": 2, "end": 2}),
        ("path_length@1", {"low_edge": 0.7}),
        ("bands@1", {"gains": [{"frequency": 1}, {"frequency": 1}]}),
        ("warp@1", {"keyframes": [{"time": 1}, {"time": 1}]}),
        ("waveshape@1", {"limits": [{"role": "head", "axis": "x", "low": 0, "high": 20}]}),
    ],
)
def test_parameters_that_contradict_each_other_are_refused(operation, parameters):
    error = fault([step(operation, **parameters)])
    assert error.where[:2] == (0, "parameters")
    assert error.mend


def test_poses_and_clips_to_supply_are_listed_and_stances_are_not():
    recipe = Recipe.parse(
        [
            step("posture@1", offsets=[{"pose": "head_down"}, {"pose": ID, "neutral": "b" * 64}]),
            step("warp@1", keyframes=[{"time": 0, "pose": "c" * 64}]),
            step("fourier@1", clip="d" * 64),
            step("emotion@1", neutral="e" * 64, emotional="f" * 64),
        ]
    )
    assert recipe.poses == {ID, "b" * 64, "c" * 64}
    assert recipe.clips == {"d" * 64, "e" * 64, "f" * 64}


@pytest.mark.parametrize("name", ["head_dwn", "A" * 64, "0" * 63, "", 5, None, "clips/../x"])
def test_a_name_that_is_no_pose_is_refused(name):
    error = fault([step("posture@1", offsets=[{"pose": name}])])
    assert error.where == (0, "parameters", "offsets", 0, "pose")
    assert "64 characters" in error.mend


def test_an_error_can_always_be_sent():
    document = json.loads('[{"operation": "\\ud800", "parameters": {}}]')
    fault(document).message.encode()
    fault([{"operation": "grid@1", "\ud800": 1}]).message.encode()
    fault([{"operation": "grid@1", "parameters": {"\ud800" * 500: 1}}]).message.encode()
    assert len(str(fault([{"operation": "x" * 10_000}]))) < 600


def test_every_operation_is_found_by_its_key():
    for key, operation in OPERATIONS.items():
        assert key == f"{operation.name}@{operation.version}"
        assert operation.title
        assert operation.summary.endswith(".")
