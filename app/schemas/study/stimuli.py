"""The clips of a study: named, or made from others."""

from __future__ import annotations

from typing import Annotated, Any, Literal, Self

from pydantic import Discriminator, Field, StringConstraints, Tag, model_validator

from app.schemas.study.words import Name, Part, Short, Text, Words

ClipRef = Annotated[str, Field(min_length=1, max_length=200)]
SliderId = Annotated[str, StringConstraints(pattern=r"^[a-z0-9_]{1,64}$")]
SpaceRef = Annotated[str, Field(min_length=1, max_length=200)]
Interface = Literal["adjectives", "features", "weights"]
"""By what a motion is authored in a space: rated adjectives, measured features, bare weights."""


class Made(Part):
    """How a stimulus is made from another clip: by a preset, or by a recipe's operations."""

    source: ClipRef
    preset: Name | None = None
    operations: tuple[dict[str, Any], ...] | None = None

    @model_validator(mode="after")
    def _is_one_of_them(self) -> Self:
        if (self.preset is None) == (self.operations is None):
            raise ValueError("give either preset or operations")
        return self


class Authored(Part):
    """How a stimulus is made in an authoring space: at a point of its sliders.

    Attributes:
        space: the space's name, of which the newest version is taken, or its id.
        values: slider to its position; those not named take no part. Of bare weights, an
            example's clip id to its weight.
    """

    space: SpaceRef
    interface: Interface = "adjectives"
    values: Annotated[dict[SliderId, Annotated[float, Field(ge=0, le=1)]], Field(min_length=1)]


def _made_of(given: object) -> str:
    """Told apart by what it names, so that a fault is told of what its author meant."""
    if isinstance(given, dict):
        return "space" if "space" in given else "clip"
    return "space" if isinstance(given, Authored) else "clip"


class Stimulus(Part):
    """A clip of the study: its identity in the library, and how the results name it.

    In a file, a clip's name alone is enough; publishing looks up its hash and fills in the rest.

    Attributes:
        clip: the clip's name in the library, or its id (64 hexadecimal digits) once published.
        made: instead of `clip`, how to make it: from a clip, or in an authoring space.
    """

    clip: ClipRef | None = None
    made: (
        Annotated[
            Annotated[Made, Tag("clip")] | Annotated[Authored, Tag("space")],
            Discriminator(_made_of),
        ]
        | None
    ) = None
    name: Short | None = None
    label: Words | None = None
    body: Text | None = None
    style: Text | None = None

    @model_validator(mode="before")
    @classmethod
    def _from_a_name(cls, given: object) -> object:
        return {"clip": given} if isinstance(given, str) else given

    @model_validator(mode="after")
    def _says_which(self) -> Self:
        if self.clip is None and self.made is None:
            raise ValueError("give clip, or how it is made")
        return self
