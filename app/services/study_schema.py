"""The study file's JSON Schema, and what it says of a place in a file."""

from __future__ import annotations

from functools import cache
from typing import Any

from app.schemas.study import Running, StudyDefinition
from app.services.study_text import Path

Schema = dict[str, Any]


@cache
def schema() -> Schema:
    """JSON Schema (2020-12) of a study file: the definition, and `running` beside it."""
    whole = StudyDefinition.model_json_schema()
    running = Running.model_json_schema()
    definitions = {**whole.pop("$defs"), **running.pop("$defs"), "Running": running}
    # A clip's name alone is enough.
    definitions["Stimulus"] = {
        "anyOf": [{"type": "string", "minLength": 1, "maxLength": 200}, definitions["Stimulus"]],
        "description": "A clip by its name alone, or with more about it.",
    }
    whole["properties"]["running"] = {"$ref": "#/$defs/Running"}
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **whole,
        "title": "Study file",
        "$defs": definitions,
    }


def members(document: object, path: Path) -> tuple[str, ...]:
    """The names that the object at this place of a file can have; none if it is no object."""
    return tuple(_at(document, path).get("properties", ()))


def choices(document: object, path: Path) -> tuple[str, ...]:
    """The words that can stand at this place; none if they are not a few."""
    found = _at(document, path)
    return tuple(found.get("enum", [found["const"]] if "const" in found else ()))


def kinds(document: object, path: Path) -> tuple[str, ...]:
    """The kinds that the object at this place can be of; none if there is one only."""
    found: Schema = schema()
    for depth, step in enumerate(path):
        found = _step(_object(found, value_at(document, path[:depth])), step)
    while "$ref" in found:
        found = schema()["$defs"][found["$ref"].rpartition("/")[2]]
    return tuple(found.get("discriminator", {}).get("mapping", ()))


def _at(document: object, path: Path) -> Schema:
    found: Schema = schema()
    for depth, step in enumerate(path):
        found = _step(_object(found, value_at(document, path[:depth])), step)
    return _object(found, value_at(document, path))


def _step(found: Schema, step: str | int) -> Schema:
    if isinstance(step, str):
        known = found.get("properties", {}).get(step)
        more = found.get("additionalProperties")
        return known or (more if isinstance(more, dict) else {})
    prefix = found.get("prefixItems", [])
    return prefix[step] if step < len(prefix) else found.get("items", {})


def _object(found: Schema, value: object) -> Schema:
    """The schema without references and alternatives, as far as the value tells which holds."""
    while True:
        if "$ref" in found:
            found = schema()["$defs"][found["$ref"].rpartition("/")[2]]
        elif "discriminator" in found:
            kind = value.get("kind") if isinstance(value, dict) else None
            mapping = found["discriminator"]["mapping"]
            if not isinstance(kind, str) or kind not in mapping:
                return {}
            found = {"$ref": mapping[kind]}
        elif "anyOf" in found:
            found = _alternative(found["anyOf"], value)
        else:
            return found


def _alternative(options: list[Schema], value: object) -> Schema:
    """The one that fits the kind of value; the richest where none does."""
    names = {dict: "object", list: "array", str: "string"}
    wanted = next((name for kind, name in names.items() if isinstance(value, kind)), None)
    resolved = [_object(option, value) for option in options if option.get("type") != "null"]
    fitting = [option for option in resolved if option.get("type") == wanted]
    return (fitting or resolved or [{}])[0]


def value_at(document: object, path: Path) -> object:
    """What stands at a place of a file, None where nothing does."""
    found: Any = document
    for step in path:
        try:
            found = found[step]
        except (KeyError, IndexError, TypeError):
            return None
    return found
