"""The study file: what is shown, asked and promised. Data only, so that it can be hashed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from hashlib import sha256
from json import dumps
from typing import Annotated, Any, Literal, Self

from pydantic import Field, StringConstraints, model_validator

from app.schemas.study.parts import AnyPart, Trials
from app.schemas.study.stimuli import ClipRef
from app.schemas.study.words import Language, Name, Part, Short, Slug, Title, Words


class Term(Part):
    """One line of what a participant agrees to: a short term and what it means."""

    term: Words
    text: Words


class Consent(Part):
    """What a participant agrees to. A new wording needs a new version."""

    version: Short
    heading: Words
    terms: tuple[Term, ...]
    statement: Words


class Welcome(Part):
    """The first page. The facts: how much there is to do, how long it takes, on what devices.

    `example` is a clip of the library that moves beside the text; best none of the stimuli.
    """

    heading: Words
    lead: Words
    facts: tuple[Words, Words, Words]
    example: ClipRef | None = None


class Thanks(Part):
    """The last page. `{clips}` in the text becomes the number of clips judged."""

    heading: Words
    text: Words


class Group(Part):
    """A between-subject group: who is in it sees the parts that name it, or no group at all."""

    id: Name
    label: Title


class StudyDefinition(Part):
    """A whole study.

    Attributes:
        manner: version of this format.
        languages: those it can be taken in; the first is used where a text or browser has none.
        parts: what comes between the consent and the thanks, in order.
        groups: between-subject groups, equally large; none means that all see the same.
        blocks: parts that change places with each other, by chance for each participant.
        back: whether a participant can go back and change an answer.
        contact: the researchers' mail address.
    """

    manner: Literal[1] = 1
    slug: Slug
    title: Title
    languages: Annotated[tuple[Language, ...], Field(min_length=1)] = ("en",)
    welcome: Welcome
    consent: Consent
    parts: Annotated[tuple[AnyPart, ...], Field(min_length=1, max_length=200)]
    groups: tuple[Group, ...] = ()
    blocks: tuple[Annotated[tuple[Name, ...], Field(min_length=2)], ...] = ()
    back: bool = True
    thanks: Thanks
    contact: Annotated[str, StringConstraints(pattern=r"^[^@\s]+@[^@\s]+$")] | None = None

    @model_validator(mode="after")
    def _is_consistent(self) -> Self:
        for what, names in (
            ("languages", self.languages),
            ("parts", [part.id for part in self.parts]),
            ("groups", [group.id for group in self.groups]),
            ("blocks", [name for block in self.blocks for name in block]),
        ):
            if twice := _twice(names):
                raise ValueError(f"{what}: “{twice}” is there twice")
        self._check_references()
        return self

    def _check_references(self) -> None:
        parts = {part.id for part in self.parts}
        groups = {group.id for group in self.groups}
        for block in self.blocks:
            if unknown := set(block) - parts:
                raise ValueError(f"blocks: there is no part “{min(unknown)}”")
        for part in self.parts:
            if unknown := set(part.groups or ()) - groups:
                raise ValueError(f"parts: “{part.id}” is for “{min(unknown)}”, which is no group")

    @property
    def trials(self) -> tuple[Trials, ...]:
        """The parts that ask about clips."""
        return tuple(part for part in self.parts if isinstance(part, Trials))

    def part(self, name: str) -> AnyPart:
        """The part of this name."""
        return next(part for part in self.parts if part.id == name)

    def into(self, language: Language) -> StudyDefinition:
        """The same with every text in one language."""
        return StudyDefinition.model_validate(_into(self, language))

    @property
    def content_hash(self) -> str:
        """SHA-256 of the definition's canonical JSON."""
        canonical = dumps(
            self.model_dump(mode="json"), sort_keys=True, separators=(",", ":"), ensure_ascii=False
        )
        return sha256(canonical.encode()).hexdigest()


def _twice(names: Iterable[str]) -> str | None:
    return next((name for name, times in Counter(names).items() if times > 1), None)


def _into(value: Any, language: Language) -> Any:  # noqa: ANN401 -- any part of the tree
    if isinstance(value, Words):
        return value.into(language).root
    if isinstance(value, Part):
        return {name: _into(getattr(value, name), language) for name in type(value).model_fields}
    if isinstance(value, tuple):
        return tuple(_into(one, language) for one in value)
    return value
