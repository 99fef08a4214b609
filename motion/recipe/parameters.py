"""Parameters of operations: each reads a JSON value, describes itself and can be eased off.

What a parameter reads is canonical: numbers are floats (whole ones integers), an absent value is
the default, a pose's or clip's name stays a name. Every fault names its place and the mend.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import TypeAlias

from motion.errors import RecipeError

Value: TypeAlias = "bool | int | float | str | list[Value] | dict[str, Value] | None"
Where: TypeAlias = tuple[str | int, ...]

HEX_ID = "^[0-9a-f]{64}$"
LATEST = 36_000.0  # s: no recipe names a later moment
_SHOWN = 40  # characters of a faulty value that are told


@dataclass(frozen=True, kw_only=True)
class Parameter(ABC):
    """What all parameters have.

    Attributes:
        title: its name on screen.
        description: what it does, in a sentence.
        default: what an absent value means, as it would be read; None for none.
        optional: it may be left out, or be null where it has no default.
    """

    title: str
    description: str = ""
    default: Value = None
    optional: bool = False

    @property
    def required(self) -> bool:
        """Whether a recipe must give it."""
        return self.default is None and not self.optional

    def read(self, value: object, where: Where) -> Value:
        """The canonical value of what stands in a recipe.

        Raises:
            RecipeError: naming the place and what is allowed there.
        """
        if value is None and self.optional:
            return self.default
        return self._read(value, where)

    def to_schema(self) -> dict[str, Value]:
        """JSON Schema (2020-12), with ``unit``, ``neutral`` and ``refers`` besides."""
        schema = {"title": self.title, **self._schema()}
        if self.optional and self.default is None:
            if "type" in schema:
                schema["type"] = [schema["type"], "null"]
            else:
                schema = {"title": self.title, "anyOf": [self._schema(), {"type": "null"}]}
        if self.description:
            schema["description"] = self.description
        if not self.required:
            schema["default"] = self.default
        return schema

    def eased(self, value: Value, share: float) -> Value:
        """The value, ``share`` of the way from where it does nothing; a setting stays."""
        return value

    def references(self, value: Value) -> Iterator[tuple[str, str]]:
        """Kind ("pose" or "clip") and name of everything that a value refers to."""
        return iter(())

    @abstractmethod
    def _read(self, value: object, where: Where) -> Value:
        """The canonical value of one that is there."""

    @abstractmethod
    def _schema(self) -> dict[str, Value]:
        """What is particular to this kind of parameter."""


@dataclass(frozen=True, kw_only=True)
class Number(Parameter):
    """A number in a range.

    Attributes:
        minimum, maximum: both allowed.
        unit: "" for a plain ratio.
        neutral: where the number does nothing; None for a setting, which is no amount.
        whole: only whole numbers.
    """

    minimum: float
    maximum: float
    unit: str = ""
    neutral: float | None = None
    whole: bool = False

    def eased(self, value: Value, share: float) -> Value:
        """The number between neutral and its value."""
        if self.neutral is None or not isinstance(value, int | float):
            return value
        return self.neutral + share * (value - self.neutral) + 0.0

    def _read(self, value: object, where: Where) -> Value:
        allowed = f"Give a {'whole ' if self.whole else ''}number from {self._range()}."
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise RecipeError(f"“{self.title}” is {shown(value)}, not a number.", where, allowed)
        # Compared before it is converted: a huge integer has no float.
        if not self.minimum <= value <= self.maximum:
            raise RecipeError(f"“{self.title}” is {shown(value)}: out of range.", where, allowed)
        if self.whole and value != int(value):
            raise RecipeError(f"“{self.title}” is {shown(value)}: not whole.", where, allowed)
        return int(value) if self.whole else float(value) + 0.0  # no minus before a zero

    def _range(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        return f"{self.minimum:g} to {self.maximum:g}{unit}"

    def _schema(self) -> dict[str, Value]:
        kind = "integer" if self.whole else "number"
        schema: dict[str, Value] = {"type": kind, "minimum": self.minimum, "maximum": self.maximum}
        if self.unit:
            schema["unit"] = self.unit
        if self.neutral is not None:
            schema["neutral"] = self.neutral
        return schema


@dataclass(frozen=True, kw_only=True)
class Flag(Parameter):
    """Yes or no."""

    def _read(self, value: object, where: Where) -> Value:
        if not isinstance(value, bool):
            problem = f"“{self.title}” is {shown(value)}, neither true nor false."
            raise RecipeError(problem, where, "Give true or false.")
        return value

    def _schema(self) -> dict[str, Value]:
        return {"type": "boolean"}


@dataclass(frozen=True, kw_only=True)
class Choice(Parameter):
    """One of several names."""

    options: Sequence[str]

    def _read(self, value: object, where: Where) -> Value:
        if not isinstance(value, str) or value not in self.options:
            problem = f"“{self.title}” is {shown(value)}, which is no choice."
            raise RecipeError(problem, where, offer(value, self.options))
        return value

    def _schema(self) -> dict[str, Value]:
        return {"type": "string", "enum": list(self.options)}


@dataclass(frozen=True, kw_only=True)
class Reference(Parameter):
    """The id of a pose or a clip that is supplied with the recipe.

    Attributes:
        kind: "pose" or "clip".
        names: what is always there and needs no supply.
    """

    kind: str
    names: Sequence[str] = ()

    def references(self, value: Value) -> Iterator[tuple[str, str]]:
        """The value itself, unless it is always there."""
        if isinstance(value, str) and value not in self.names:
            yield self.kind, value

    def _read(self, value: object, where: Where) -> Value:
        if isinstance(value, str) and (value in self.names or _is_id(value)):
            return value
        problem = f"“{self.title}” is {shown(value)}, which names no {self.kind}."
        named = f"{offer(value, self.names)} Or give" if self.names else "Give"
        raise RecipeError(problem, where, f"{named} the {self.kind}'s id: 64 characters 0–9, a–f.")

    def _schema(self) -> dict[str, Value]:
        by_id: dict[str, Value] = {"type": "string", "pattern": HEX_ID, "refers": self.kind}
        if not self.names:
            return by_id
        return {"anyOf": [{"type": "string", "enum": list(self.names)}, by_id]}


@dataclass(frozen=True, kw_only=True)
class ListOf(Parameter):
    """A bounded list of one kind of parameter."""

    item: Parameter
    shortest: int = 0
    longest: int = 32

    def eased(self, value: Value, share: float) -> Value:
        """Every entry eased."""
        if not isinstance(value, list):
            return value
        return [self.item.eased(item, share) for item in value]

    def references(self, value: Value) -> Iterator[tuple[str, str]]:
        """Those of every entry."""
        for item in value if isinstance(value, list) else ():
            yield from self.item.references(item)

    def _read(self, value: object, where: Where) -> Value:
        allowed = f"Give a list of {self.shortest} to {self.longest} entries."
        if not isinstance(value, list | tuple):
            raise RecipeError(f"“{self.title}” is {shown(value)}, not a list.", where, allowed)
        if not self.shortest <= len(value) <= self.longest:
            raise RecipeError(f"“{self.title}” has {len(value)} entries.", where, allowed)
        return [self.item.read(item, (*where, place)) for place, item in enumerate(value)]

    def _schema(self) -> dict[str, Value]:
        return {
            "type": "array",
            "items": self.item.to_schema(),
            "minItems": self.shortest,
            "maxItems": self.longest,
        }


Rule: TypeAlias = Callable[[Mapping[str, Value]], tuple[str, str] | None]


@dataclass(frozen=True, kw_only=True)
class Group(Parameter):
    """Named parameters that belong together.

    Attributes:
        members: name to parameter.
        rule: what must hold between them; returns the problem and its mend, or None.
    """

    members: Mapping[str, Parameter]
    rule: Rule | None = None

    def eased(self, value: Value, share: float) -> Value:
        """Every member eased."""
        if not isinstance(value, dict):
            return value
        return {name: part.eased(value[name], share) for name, part in self.members.items()}

    def references(self, value: Value) -> Iterator[tuple[str, str]]:
        """Those of every member."""
        if isinstance(value, dict):
            for name, part in self.members.items():
                yield from part.references(value[name])

    def read_members(self, value: object, where: Where) -> dict[str, Value]:
        """As ``read``, known to be a dictionary."""
        if not isinstance(value, dict):
            names = ", ".join(self.members)
            problem = f"“{self.title}” is {shown(value)}, not an object."
            raise RecipeError(problem, where, f"Give an object with: {names}.")
        for name in value:
            if name not in self.members:
                problem = f"“{self.title}” has no {shown(name)}."
                raise RecipeError(problem, where, offer(name, tuple(self.members)))
        found = {name: self._member(name, value, where) for name in self.members}
        if self.rule is not None and (broken := self.rule(found)):
            raise RecipeError(broken[0], where, broken[1])
        return found

    def _member(self, name: str, values: Mapping[str, object], where: Where) -> Value:
        part = self.members[name]
        if name not in values:
            if part.required:
                problem = f"“{self.title}” needs “{name}”."
                raise RecipeError(problem, (*where, name), f"Add it. {part.description}".rstrip())
            return part.default
        return part.read(values[name], (*where, name))

    def _read(self, value: object, where: Where) -> Value:
        return self.read_members(value, where)

    def _schema(self) -> dict[str, Value]:
        schema: dict[str, Value] = {
            "type": "object",
            "properties": {name: part.to_schema() for name, part in self.members.items()},
            "additionalProperties": False,
        }
        if needed := [name for name, part in self.members.items() if part.required]:
            schema["required"] = list(needed)
        return schema


def offer(value: object, names: Sequence[str]) -> str:
    """A sentence with the names most like a value, or with all of them."""
    near = get_close_matches(value[:_SHOWN], names) if isinstance(value, str) else []
    listed = ", ".join(near or names)
    return f"Did you mean {listed}?" if near else f"Choose from: {listed}."


def shown(value: object) -> str:
    """A faulty value, short enough for a message and safe to print."""
    if isinstance(value, dict):
        return "an object"
    if isinstance(value, list | tuple):
        return "a list"
    if value is None or isinstance(value, bool):
        return {None: "null", True: "true", False: "false"}[value]
    if isinstance(value, int) and abs(value) >= 10**_SHOWN:
        return "a very large number"
    if isinstance(value, float) and not math.isfinite(value):
        return "not a finite number"
    if isinstance(value, int | float):
        return f"{value!r}"
    # Escaped by repr: half a surrogate pair could not be sent in an answer.
    text = repr(value[:_SHOWN])[1:-1] if isinstance(value, str) else type(value).__name__
    return f"“{text}”" if isinstance(value, str) else f"a {text}"


def _is_id(value: str) -> bool:
    return len(value) == 64 and all(letter in "0123456789abcdef" for letter in value)
