"""Operations describe their parameters as JSON Schema, and keep to what they say."""

import pytest
from hypothesis import given, settings
from jsonschema import Draft202012Validator

from motion.errors import RecipeError
from motion.recipe import OPERATIONS, PRESETS, Recipe
from tests.motion.recipe.strategies import documents, steps

SCHEMAS = {key: operation.to_schema() for key, operation in OPERATIONS.items()}


def parts(schema):
    """A schema and everything inside it."""
    yield schema
    for inner in [*schema.get("properties", {}).values(), *schema.get("anyOf", [])]:
        yield from parts(inner)
    if "items" in schema:
        yield from parts(schema["items"])


@pytest.mark.parametrize("key", OPERATIONS)
def test_a_schema_is_one(key):
    Draft202012Validator.check_schema(SCHEMAS[key])
    assert SCHEMAS[key]["$schema"] == "https://json-schema.org/draft/2020-12/schema"


@pytest.mark.parametrize("key", OPERATIONS)
def test_every_number_tells_its_range_and_every_list_its_length(key):
    for part in parts(SCHEMAS[key]):
        kinds = part.get("type", [])
        if "number" in kinds or "integer" in kinds:
            assert part["minimum"] < part["maximum"]
        if "array" in kinds:
            assert part["maxItems"] <= 64
        if "object" in kinds:
            assert part["additionalProperties"] is False
        if "default" in part and part["default"] is not None and "minimum" in part:
            assert part["minimum"] <= part["default"] <= part["maximum"]


@pytest.mark.parametrize("key", OPERATIONS)
def test_every_parameter_has_a_title_and_says_what_it_does(key):
    for part in SCHEMAS[key]["properties"].values():
        assert part["title"]
        assert part["description"].endswith(".")


def read(document):
    """The recipe, or the error."""
    try:
        return Recipe.parse(document)
    except RecipeError as error:
        return error


@given(steps())
@settings(max_examples=150)
def test_what_a_schema_allows_is_read_and_keeps_to_it(step):
    found = read([step])
    if isinstance(found, RecipeError):
        # Only for what holds between parameters, which a schema cannot say.
        assert found.where[:2] == (0, "parameters")
        assert "out of range" not in found.message
        return
    canonical = found.to_list()[0]
    Draft202012Validator(SCHEMAS[canonical["operation"]]).validate(canonical["parameters"])


@given(documents())
@settings(max_examples=300)
def test_any_json_is_read_or_refused_with_place_and_mend(document):
    found = read(document)
    if isinstance(found, RecipeError):
        assert found.message
        assert found.mend
        str(found).encode()
        return
    for step, canonical in zip(document, found.to_list(), strict=True):
        schema = SCHEMAS[canonical["operation"]]
        Draft202012Validator(schema).validate(step.get("parameters", {}))


def test_presets_keep_to_the_schemas():
    for preset in PRESETS.values():
        for step in preset.operations.to_list():
            Draft202012Validator(SCHEMAS[step["operation"]]).validate(step["parameters"])
