"""What is wrong with the shape of a study file, in words, with the place and the mend.

The data models find the faults; here they are told: which member is meant, what may stand there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from difflib import get_close_matches
from typing import Any

from pydantic import BaseModel, ValidationError

from app.schemas.studies_api import Problem
from app.schemas.study import LANGUAGES
from app.services import study_schema
from app.services.study_text import Path, short

Bare = Mapping[Path, str]
Context = Mapping[str, Any]

MOST_FAULTS = 100  # told at once; a file with more is mostly one fault seen everywhere
_PATTERNS = {
    r"^[a-z][a-z0-9_]*$": "Use small letters, digits and underscores, a letter first.",
    r"^[a-z0-9]+(-[a-z0-9]+)*$": "Use small letters and digits, with single hyphens between.",
    r"^[^@\s]+@[^@\s]+$": "Write a mail address, such as name@example.org.",
    r"^[A-Za-z0-9_-]{1,64}$": "Use letters, digits, hyphens and underscores, 64 at most.",
    r"^https://[^\s]+$": "Write an address that begins with https://.",
}
_MENDS = {
    "practice": "give a smaller number, or more stimuli",
    "subset": "give a smaller number, or more stimuli",
    "sets": "take “sets” out, or use a task that compares",
    "languages": "keep one of the two",
    "groups": "give each an id of its own",
    "parts": "give each an id of its own, and declare the groups that parts are for",
    "blocks": "name each part of the study once at most",
    "closes_at": "let it close after it opens",
}
_WANTED = {
    "string": ("text", "Write some text."),
    "int": ("whole number", "Give a whole number."),
    "float": ("number", "Give a number."),
    "decimal": ("number", "Give a number."),
    "bool": ("truth value", "Write true or false."),
    "tuple": ("list", "Give a list: one line for each, beginning with “- ”."),
    "list": ("list", "Give a list: one line for each, beginning with “- ”."),
    "dict": ("set of members", "Give members, each as name: value."),
    "model": ("set of members", "Give members, each as name: value."),
    "datetime": ("point in time", "Write it like 2026-05-01T08:00:00+03:00."),
}


def faults(
    model: type[BaseModel], document: object, *, under: Path = (), bare: Bare | None = None
) -> tuple[Any, list[Problem]]:
    """What the model makes of a document, or what hinders it.

    Args:
        model: the definition of a study, or how it is run.
        document: as it was read.
        under: where in the file it stands.
        bare: how values that are no text were written, as `study_text` has found them.

    Returns:
        The model's instance, None if there are faults, and the faults in their order.
    """
    try:
        return model.model_validate(document), []
    except ValidationError as error:
        return None, _told(error, document, under, bare or {})


def _told(error: ValidationError, document: object, under: Path, bare: Bare) -> list[Problem]:
    whole: object = document
    for step in reversed(under):
        whole = {step: whole}
    found: dict[Path, Problem] = {}
    for one in error.errors(include_url=False):
        where = (*under, *_place(document, one["loc"]))
        if _is_of_another_branch(document, one["loc"]):
            continue
        if one["type"] == "too_short" and _has_within(where, found):
            continue  # its items are faulty, and are not counted therefore
        problem = _Fault(whole, where, one["type"], one["msg"], one.get("ctx", {}), bare).told()
        found.setdefault(tuple(problem.where), problem)
        if len(found) == MOST_FAULTS:
            break
    return list(found.values())


def _place(document: Any, location: Sequence[str | int]) -> Path:  # noqa: ANN401 -- any JSON
    """The true steps of pydantic's path, which names the tried branches of unions besides."""
    path: list[str | int] = []
    node, entered = document, False
    for step in location:
        if isinstance(node, Mapping):
            if not entered and step == node.get("kind"):
                entered = True
                continue
            if step in node:
                node, entered = node[step], False
            elif not str(step).isidentifier():  # such as “constrained-str”
                continue
            else:  # a missing member is where it ought to be
                node = None
        elif isinstance(node, list) and isinstance(step, int) and step < len(node):
            node, entered = node[step], False
        elif not (isinstance(node, list) and isinstance(step, int)):
            break
        path.append(step)
    return tuple(path)


def _is_of_another_branch(document: object, location: Sequence[str | int]) -> bool:
    """Whether a text's fault is told of the branch that its author did not take."""
    for index, step in enumerate(location):
        of_one, of_many = step == "constrained-str", str(step).startswith("dict[")
        if of_one or of_many:
            value = study_schema.value_at(document, _place(document, location[:index]))
            return isinstance(value, Mapping) != of_many
    return False


class _Fault:
    """One fault, on its way to words."""

    def __init__(
        self, whole: object, where: Path, kind: str, message: str, context: Context, bare: Bare
    ) -> None:
        self.whole, self.where, self.kind = whole, where, kind
        self.message, self.context, self.bare = message, context, bare
        self.value = _at(whole, where)
        self.name = _name(where)

    def told(self) -> Problem:
        if self.kind == "value_error":
            return self._of_rule()
        wanted = _wanted(self.kind)
        if wanted:
            message, mend = self._of_type(wanted)
        else:
            message, mend = _TOLD.get(self.kind, _as_it_is)(self)
        return Problem(where=list(self.where), message=message, mend=mend)

    def _of_rule(self) -> Problem:
        """What a rule of the models says; one that begins with a member's name is about that."""
        text = self.message.removeprefix("Value error, ")
        name, _, rest = text.partition(": ")
        where = self.where
        if rest and name in study_schema.members(self.whole, where):
            where, text = (*where, name), rest
        problem, _, mend = text.partition("; ")
        if problem.startswith("give "):
            problem, mend = f"{_name(where)} does not fit", problem
        return Problem(
            where=list(where),
            message=_sentence(problem),
            mend=_sentence(mend or _MENDS.get(name, "change it")),
        )

    def _of_type(self, wanted: str) -> tuple[str, str]:
        what, mend = _WANTED[wanted]
        written = self.bare.get(self.where)
        if wanted == "string" and written is not None and self.value is not None:
            kind = {bool: "a truth value", int: "a number", float: "a number"}
            read = kind.get(type(self.value), "a date")
            return (
                f"YAML reads {short(written)} as {read}; text is wanted here.",
                f'Put it in quotes: "{short(written)}".',
            )
        if self.value is None:
            return f"{self.name} is empty.", mend
        return f"{self.name} is {_kind_of(self.value)}, not a {what}.", mend

    def missing(self) -> tuple[str, str]:
        inside = self.where[:-1]
        if inside and isinstance(inside[-1], str) and isinstance(_at(self.whole, inside), list):
            return "There are too few of these.", f"Add number {int(self.where[-1]) + 1}."
        return f"{self.name} is missing.", f"Add {self.where[-1] if self.where else 'it'}."

    def unknown(self) -> tuple[str, str]:
        known = study_schema.members(self.whole, self.where[:-1])
        return f"{self.name} is no member here.", _offer(str(self.where[-1]), known, "Members")

    def kind_is_unknown(self) -> tuple[str, str]:
        given = self.value.get("kind") if isinstance(self.value, Mapping) else None
        self.where = (*self.where, "kind")
        known = study_schema.kinds(self.whole, self.where[:-1])
        if given is None:
            return "The kind is missing.", f"Add kind: {_listed(known)}."
        return f"There is no kind “{short(str(given))}”.", _offer(str(given), known, "Kinds")

    def no_choice(self) -> tuple[str, str]:
        if self.where and self.where[-1] == "manner":
            return "This is a format that this version does not know.", "Write manner: 1."
        known = study_schema.choices(self.whole, self.where)
        parent = _at(self.whole, self.where)
        if not known or isinstance(parent, Mapping):  # a text in a language that is none
            wrong = str(self.where[-1])
            return f"“{short(wrong)}” is no language.", f"Use {_listed(LANGUAGES)}."
        return f"“{short(str(self.value))}” is none of the choices.", _offer(
            str(self.value), known, "Choices"
        )

    def pattern(self) -> tuple[str, str]:
        mend = _PATTERNS.get(str(self.context.get("pattern")), "Look at the description.")
        if not isinstance(self.value, str):  # a key
            return f"{self.name} cannot be a name.", mend
        return f"“{short(self.value)}” is not written as it must be.", mend


def _name(where: Path) -> str:
    """What the fault's place is called: “left”, or number 3 of “scales”."""
    if not where:
        return "The file"
    if isinstance(where[-1], int):
        return f"Number {where[-1] + 1} of “{short(str(where[-2]))}”"
    return f"“{short(where[-1])}”"


def _wanted(kind: str) -> str | None:
    if kind == "model_attributes_type":
        return "model"
    if kind in ("int_from_float", "datetime_object_invalid", "datetime_from_date_parsing"):
        return kind.partition("_")[0]
    name, _, rest = kind.partition("_")
    return name if name in _WANTED and rest in ("type", "parsing", "parsing_size") else None


def _as_it_is(fault: _Fault) -> tuple[str, str]:
    return _sentence(fault.message), "Change it."


_TOLD: Mapping[str, Callable[[_Fault], tuple[str, str]]] = {
    "missing": _Fault.missing,
    "extra_forbidden": _Fault.unknown,
    "union_tag_invalid": _Fault.kind_is_unknown,
    "union_tag_not_found": _Fault.kind_is_unknown,
    "literal_error": _Fault.no_choice,
    "string_pattern_mismatch": _Fault.pattern,
    "string_too_short": lambda fault: (f"{fault.name} is empty.", "Write something here."),
    "string_too_long": lambda fault: (
        f"{fault.name} is longer than {fault.context['max_length']:,} characters.",
        "Shorten it.",
    ),
    "too_short": lambda fault: (
        f"{fault.name} has {fault.context['actual_length'] or 'none'}.",
        f"Give at least {fault.context['min_length']}.",
    ),
    "too_long": lambda fault: (
        f"{fault.name} has more than {fault.context['max_length']}.",
        "Take some out.",
    ),
    "greater_than_equal": lambda fault: (
        f"{short(str(fault.value))} is too small.",
        f"Give at least {fault.context['ge']:g}.",
    ),
    "less_than_equal": lambda fault: (
        f"{short(str(fault.value))} is too large.",
        f"Give at most {fault.context['le']:g}.",
    ),
    "timezone_aware": lambda fault: (
        f"{fault.name} does not say in which time zone.",
        "Write it like 2026-05-01T08:00:00+03:00.",
    ),
}


def _offer(given: str, known: Sequence[str], title: str) -> str:
    near = get_close_matches(given, known, 1, 0.6)
    if near:
        return f"Did you mean “{near[0]}”?"
    return f"{title} here: {', '.join(known)}." if known else "Take it out."


def _listed(words: Sequence[str]) -> str:
    return " or ".join(filter(None, [", ".join(words[:-1]), *words[-1:]]))


def _kind_of(value: object) -> str:
    if isinstance(value, Mapping):
        return "a set of members"
    if isinstance(value, list):
        return "a list"
    return f"“{short(str(value))}”"


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}" + ("" if text.endswith((".", "?")) else ".")


def _has_within(where: Path, found: Mapping[Path, Problem]) -> bool:
    return any(len(one) > len(where) and one[: len(where)] == where for one in found)


def _at(document: Any, path: Path) -> Any:  # noqa: ANN401 -- any JSON
    return study_schema.value_at(document, path)
