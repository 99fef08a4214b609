"""What keeps a draft from being a study: each problem with its place in the study file."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from pydantic import ValidationError

from app.schemas.studies_api import Problem
from app.schemas.study import StudyDefinition

Path = tuple[str | int, ...]

# Pydantic's own words are for programmers; these are the faults that editing makes.
_TOLD: dict[str, tuple[str, str]] = {
    "missing": ("This is missing.", "Fill it in."),
    "string_too_short": ("This is empty.", "Write something here."),
    "string_too_long": ("This is longer than {max_length} characters.", "Shorten it."),
    "too_short": ("There are too few of these.", "Add at least {min_length}."),
    "too_long": ("There are more than {max_length} of these.", "Take some out."),
    "extra_forbidden": ("A study file knows nothing of this name.", "Take it out."),
    "greater_than_equal": ("This is too small.", "Give at least {ge}."),
    "less_than_equal": ("This is too large.", "Give at most {le}."),
    "union_tag_invalid": ("There is no such kind: {tag}.", "Use one of {expected_tags}."),
    "union_tag_not_found": ("The kind is missing.", "Say which kind it is."),
    "string_pattern_mismatch": ("This is not written as it must be.", "It must match {pattern}."),
    "string_type": ("This is no text.", "Write something here."),
    "int_parsing": ("This is no whole number.", "Give one."),
    "int_type": ("This is no whole number.", "Give one."),
    "int_from_float": ("This is no whole number.", "Give one."),
    "float_type": ("This is no number.", "Give one."),
    "float_parsing": ("This is no number.", "Give one."),
    "literal_error": ("This is none of the choices.", "Use {expected}."),
    "tuple_type": ("This is no list.", "Give a list."),
}
_PATTERNS = {
    r"^[a-z][a-z0-9_]*$": "Use small letters, digits and underscores, a letter first.",
    r"^[a-z0-9]+(-[a-z0-9]+)*$": "Use small letters and digits, with single hyphens between.",
    r"^[^\s@]+@[^\s@]+$": "Write a mail address, such as name@example.org.",
    r"^[^@\s]+@[^@\s]+$": "Write a mail address, such as name@example.org.",
}


def read(draft: Mapping[str, Any]) -> tuple[StudyDefinition | None, list[Problem]]:
    """The study that a draft describes, or why it describes none yet."""
    try:
        return StudyDefinition.model_validate(draft), []
    except ValidationError as error:
        return None, problems(draft, error)


def problems(draft: Mapping[str, Any], error: ValidationError) -> list[Problem]:
    """A validation's faults, at the places where the draft has them."""
    found: dict[Path, Problem] = {}
    for fault in error.errors(include_url=False, include_input=False):
        where = place(draft, fault["loc"])
        problem = _problem(where, fault["type"], fault["msg"], fault.get("ctx", {}))
        found.setdefault(tuple(problem.where), problem)
    return [one for one in found.values() if not _has_closer(tuple(one.where), found)]


def place(given: Any, location: Sequence[str | int]) -> Path:  # noqa: ANN401 -- any JSON
    """Where in what was given a fault is.

    Pydantic names the tried branches of a union between the true steps; they are left out.
    """
    path: list[str | int] = []
    node = given
    for step in location:
        if isinstance(node, Mapping):
            if step in node:
                node = node[step]
            elif step == node.get("kind") or not str(step).isidentifier():
                continue
            else:  # a missing member is where it ought to be
                node = None
        elif isinstance(node, list) and isinstance(step, int) and step < len(node):
            node = node[step]
        else:
            break
        path.append(step)
    return tuple(path)


def _problem(where: Path, kind: str, message: str, context: Mapping[str, Any]) -> Problem:
    if kind == "value_error":
        field, _, rest = message.removeprefix("Value error, ").partition(": ")
        if rest and field.isidentifier():
            where, message = (*where, field), rest
        else:
            message = message.removeprefix("Value error, ")
        return Problem(where=list(where), message=_sentence(message))
    told, mend = _TOLD.get(kind, (_sentence(message), None))
    if kind == "string_pattern_mismatch":
        mend = _PATTERNS.get(str(context.get("pattern")), mend)
    known = _Named(context)
    return Problem(
        where=list(where), message=told.format_map(known), mend=mend and mend.format_map(known)
    )


class _Named(dict[str, Any]):
    """What a fault's text refers to; what pydantic leaves out stays visible as a dash."""

    def __missing__(self, _: str) -> str:
        return "–"


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}" + ("" if text.endswith((".", "?")) else ".")


def _has_closer(where: Path, others: Iterable[Path]) -> bool:
    """Whether another fault names a place within this one: then a union's other branch spoke."""
    return any(len(other) > len(where) and other[: len(where)] == where for other in others)
