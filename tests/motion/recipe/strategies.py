"""Recipes at random: from the operations' JSON Schemas, and documents that are none."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st

from motion.recipe import OPERATIONS

POSE, CYCLE, OTHER_CYCLE, SHORT = (letter * 64 for letter in "abcd")
_IDS = {"pose": [POSE], "clip": [CYCLE, OTHER_CYCLE, SHORT]}
_LITTLE = 1.5  # s: within the clips that tests use


def from_schema(schema: dict[str, Any]) -> st.SearchStrategy[Any]:
    """Values that a schema allows; ids are those of the constants above."""
    if "anyOf" in schema:
        return st.one_of(*(from_schema(part) for part in schema["anyOf"]))
    if "enum" in schema:
        return st.sampled_from(schema["enum"])
    if isinstance(schema["type"], list):
        rest = {**schema, "type": schema["type"][0]}
        return st.one_of(from_schema(rest), st.none())
    return _OF_TYPE[schema["type"]](schema)


def steps() -> st.SearchStrategy[dict[str, Any]]:
    """One step of a recipe, its parameters within their ranges."""
    return st.one_of(
        *(
            st.fixed_dictionaries(
                {"operation": st.just(key), "parameters": from_schema(operation.to_schema())}
            )
            for key, operation in OPERATIONS.items()
        )
    )


def documents() -> st.SearchStrategy[Any]:
    """Any JSON, much of it like a recipe."""
    names = st.sampled_from(
        ["operation", "parameters", "path", "timing", "offsets", "pose", "amount", *OPERATIONS]
    )
    numbers = st.one_of(st.floats(), st.integers(), st.sampled_from([10**400, -0.0, True]))
    leaves = st.one_of(st.none(), st.booleans(), numbers, st.text(), names)
    anything = st.recursive(
        leaves,
        lambda inner: st.one_of(
            st.lists(inner, max_size=4),
            st.dictionaries(st.one_of(names, st.text()), inner, max_size=4),
        ),
        max_leaves=20,
    )
    steps_with_faults = st.fixed_dictionaries(
        {"operation": names},
        optional={"parameters": st.dictionaries(names, anything, max_size=4)},
    )
    return st.one_of(anything, st.lists(st.one_of(anything, steps_with_faults, steps())))


def _number(schema: dict[str, Any]) -> st.SearchStrategy[Any]:
    whole = st.floats(schema["minimum"], schema["maximum"])
    if schema.get("unit") == "s":
        return st.one_of(st.floats(schema["minimum"], min(_LITTLE, schema["maximum"])), whole)
    return whole


def _array(schema: dict[str, Any]) -> st.SearchStrategy[Any]:
    fewest = schema["minItems"]
    most = min(schema["maxItems"], fewest + 2)
    return st.lists(from_schema(schema["items"]), min_size=fewest, max_size=most)


def _object(schema: dict[str, Any]) -> st.SearchStrategy[Any]:
    parts = {name: from_schema(part) for name, part in schema["properties"].items()}
    needed = schema.get("required", [])
    return st.fixed_dictionaries(
        {name: parts[name] for name in needed},
        optional={name: part for name, part in parts.items() if name not in needed},
    )


def _id(schema: dict[str, Any]) -> st.SearchStrategy[Any]:
    return st.sampled_from(_IDS[schema["refers"]])


_OF_TYPE = {
    "number": _number,
    "integer": lambda schema: st.integers(schema["minimum"], schema["maximum"]),
    "boolean": lambda _: st.booleans(),
    "array": _array,
    "object": _object,
    "string": _id,
    "null": lambda _: st.none(),
}
