"""Authoring spaces: example motions with their places on sliders, frozen, and asked for motion.

A space is content: its id is the hash of its definition, so whatever was made in it can be made
again. A change is a new version beside it.
"""

from __future__ import annotations

import json
from datetime import datetime
from hashlib import sha256
from typing import Annotated, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, JsonValue, model_validator

from app.schemas.study import Interface, Words
from app.schemas.study.words import ContentHash, Name, Part, Title

MOST_EXAMPLES = 64
MOST_PARAMETERS = 100
START = 0.5  # where a slider stands at first

Versions = Literal["one", "all"]
"""Of what is deleted: the space alone, or every version of its name."""
Unit = Annotated[float, Field(ge=0, le=1)]
Seconds = Annotated[float, Field(ge=0, le=1e6)]
Keytimes = Annotated[dict[Name, Seconds], Field(max_length=16)]

_CLIP = "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11"
_OTHER = "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"
_EVENTS: dict[str, JsonValue] = {
    "left_strike": 0.0,
    "left_off": 0.68,
    "right_strike": 0.54,
    "right_off": 0.14,
}
_WEIGHED: dict[str, JsonValue] = {"weights": [0.64, 0.36], "outside": 0.0, "notes": []}
_BLEND: list[JsonValue] = [
    {
        "operation": "blend@1",
        "parameters": {
            "examples": [
                {"clip": _CLIP, "weight": 0.64, "keytimes": _EVENTS},
                {"clip": _OTHER, "weight": 0.36, "keytimes": _EVENTS},
            ]
        },
    }
]


def _asked(**members: JsonValue) -> ConfigDict:
    return ConfigDict(extra="forbid", json_schema_extra={"example": members})


def _told(**members: JsonValue) -> ConfigDict:
    return ConfigDict(json_schema_extra={"example": members})


class Example(Part):
    """An example motion of a space.

    Attributes:
        clip: its id in the library.
        keytimes: event to seconds from the first frame; empty for an even time-warp.
        predicted: nobody rated it; its impressions were predicted from its motion.
    """

    clip: ContentHash
    name: Title
    keytimes: Keytimes = Field(default_factory=dict)
    predicted: bool = False


class Parameter(Part):
    """A pair of adjectives, or a motion feature: where every example lies between its ends.

    Attributes:
        title, about: of a feature, its name and what it measures; a pair is named by its ends.
        left, right: what 0 and 1 look like.
        unit, lowest, highest: of a feature, what 0 and 1 stand for.
        values: one for each example, in their order.
    """

    id: Name
    title: Words | None = None
    about: str | None = None
    left: Words
    right: Words
    unit: str | None = None
    lowest: float | None = None
    highest: float | None = None
    values: tuple[Unit, ...]


class Primary(Part):
    """A cluster of parameters as one slider.

    Attributes:
        members: the parameters that it is the mean of.
        values: one for each example, in their order.
    """

    id: Name
    title: Words
    members: Annotated[tuple[Name, ...], Field(min_length=1)]
    values: tuple[Unit, ...]


class Sliders(Part):
    """What an author can move: the primary sliders, and every single parameter besides."""

    primary: tuple[Primary, ...]
    parameters: Annotated[tuple[Parameter, ...], Field(max_length=MOST_PARAMETERS)]

    @model_validator(mode="after")
    def _hangs_together(self) -> Self:
        known = [one.id for one in self.parameters]
        names = [*known, *(one.id for one in self.primary)]
        if len(set(names)) < len(names):
            raise ValueError("an id is used twice")
        if strangers := {name for one in self.primary for name in one.members} - set(known):
            raise ValueError(f"no parameter is called {min(strangers)}")
        return self


class Origin(Part):
    """What a space's numbers come from.

    Attributes:
        study, part, versions: whose answers; versions by their hashes.
        kind: whose answers: people's, or those of simulated raters.
        participants: how many were analysed.
        least_peak, most_spread: which pairs were kept.
        moved: pairs whose cluster was chosen by hand.
        before: the version of the space that this one was made from.
        note: what else there is to know, in a sentence.
    """

    study: str | None = None
    part: str | None = None
    versions: tuple[ContentHash, ...] = ()
    kind: Literal["participant", "simulated"] | None = None
    participants: int | None = None
    least_peak: float | None = None
    most_spread: float | None = None
    moved: tuple[Name, ...] = ()
    before: ContentHash | None = None
    note: str = ""


class SpaceDefinition(Part):
    """A whole space. Without a questionnaire there are no adjectives."""

    manner: Literal[1] = 1
    title: Title
    examples: Annotated[tuple[Example, ...], Field(min_length=1, max_length=MOST_EXAMPLES)]
    adjectives: Sliders | None = None
    features: Sliders
    origin: Origin = Origin()

    @model_validator(mode="after")
    def _has_a_value_for_each_example(self) -> Self:
        for sliders in filter(None, (self.adjectives, self.features)):
            rows: tuple[Primary | Parameter, ...] = (*sliders.primary, *sliders.parameters)
            for one in rows:
                if len(one.values) != len(self.examples):
                    raise ValueError(f"{one.id}: give one value for each example")
        if len({one.clip for one in self.examples}) < len(self.examples):
            raise ValueError("examples: a clip is there twice")
        return self

    @property
    def content_hash(self) -> str:
        """SHA-256 of the canonical text: the space's id."""
        text = json.dumps(self.model_dump(mode="json"), sort_keys=True, ensure_ascii=False)
        return sha256(text.encode()).hexdigest()

    def sliders(self, interface: Interface) -> Sliders | None:
        """The sliders of an interface; None where it has none: bare weights, or nobody rated."""
        return {"adjectives": self.adjectives, "features": self.features}.get(interface)


class SpaceLine(BaseModel):
    """A space in the list.

    Attributes:
        number: 1, 2, … of the spaces with the same name.
        newest: whether it is the newest of them.
    """

    id: ContentHash
    name: Title
    number: int
    newest: bool
    examples: int
    interfaces: list[Interface]
    simulated: bool
    study: str | None
    made_by: str | None
    created_at: datetime


class ListedSpace(SpaceLine):
    """A space in the list, as who asks may know it.

    Attributes:
        study_title: of the study; None if it is none, or one that is not theirs to see.
        may_delete: whether they may delete it, unless something needs it.
    """

    study_title: str | None
    may_delete: bool


class SpaceList(BaseModel):
    """Every space, newest first."""

    spaces: list[ListedSpace]


class ExampleClip(BaseModel):
    """An example as the studio shows it."""

    clip: ContentHash
    name: str
    glb_url: str
    figure_url: str | None
    duration: float


class SpaceDetail(SpaceLine):
    """A space with all its numbers.

    Attributes:
        clips: the examples' files, in their order.
        notes: of each interface, what there is to know about its examples' places, in sentences.
    """

    definition: SpaceDefinition
    clips: list[ExampleClip]
    notes: dict[Interface, list[str]]


class Point(BaseModel):
    """What an author wants.

    Attributes:
        interface: what the values are about.
        values: slider's or example's id to its value; for adjectives and features, those not named
            take no part: only the named sliders span the space. For weights, an example's clip id
            to its weight; those not named weigh nothing.
    """

    model_config = _asked(interface="adjectives", values={"quickness": 0.8, "largeness": 0.6})

    interface: Interface
    values: Annotated[dict[str, Unit], Field(min_length=1, max_length=MOST_PARAMETERS)]


class Weighed(BaseModel):
    """What a point means.

    Attributes:
        weights: of each example, in the space's order; their sum is 1.
        outside: how far the point lies outside of what the examples span, in slider lengths; 0
            within.
        notes: what there is to know, in sentences.
    """

    model_config = _told(**_WEIGHED)

    weights: list[float]
    outside: float
    notes: list[str]


class SpaceRecipe(Weighed):
    """A point as an ordinary recipe: `source` and `operations` as every edit has them."""

    model_config = _told(**_WEIGHED, source=_CLIP, operations=_BLEND)

    source: ContentHash
    operations: list[dict[str, object]]


class NewSpace(BaseModel):
    """A space made from clips alone, without a questionnaire: its sliders are motion features."""

    model_config = _asked(name="Two walks", clips=[_CLIP, _OTHER])

    name: Title
    clips: Annotated[list[ContentHash], Field(min_length=2, max_length=MOST_EXAMPLES)]
    keytimes: dict[ContentHash, Keytimes] = {}


class NewVersion(BaseModel):
    """What a space's next version changes.

    Attributes:
        keytimes: clip id to its events, all of them.
        join: clips that nobody rated; their impressions are predicted from their motion.
    """

    model_config = _asked(keytimes={_CLIP: _EVENTS}, join=[_OTHER])

    keytimes: dict[ContentHash, Keytimes] = {}
    join: Annotated[list[ContentHash], Field(max_length=MOST_EXAMPLES)] = []


class PredictedParameter(BaseModel):
    """What a pair's impression is predicted to be.

    Attributes:
        value, low, high: the prediction and its 95 % interval, 0 to 1; None where refused.
        error, error_of_mean: root mean square of leaving one out, and of always saying the mean;
            None where too few clips were rated to tell.
        sentence: how good it is, or why it is refused.
    """

    id: Name
    left: Words
    right: Words
    refused: bool
    value: float | None
    low: float | None
    high: float | None
    error: float | None
    error_of_mean: float | None
    sentence: str


class Prediction(BaseModel):
    """The impressions that a clip would have in a space.

    Attributes:
        level: of the intervals: the share of new clips that they hold, as far as the number of
            rated clips allows; None if nothing is learnt.
    """

    clip: ContentHash
    parameters: list[PredictedParameter]
    level: float | None
    can_join: bool
    sentence: str


class KeytimesView(BaseModel):
    """The events found in a clip: name to seconds from its first frame."""

    model_config = _told(keytimes=_EVENTS)

    keytimes: Keytimes


class TargetRequest(BaseModel):
    """Motions to be matched, drawn at random from a space's primary adjectives.

    Attributes:
        count: how many; the drawn ones lie far from each other.
        seed: the same number, the same targets.
    """

    model_config = _asked(count=5, seed=1)

    count: Annotated[int, Field(ge=1, le=50)] = 5
    seed: Annotated[int, Field(ge=0, le=2**32 - 1)] = 1


class Target(SpaceRecipe):
    """A drawn target, and the point that it was drawn at."""

    model_config = _told(
        **_WEIGHED,
        source=_CLIP,
        operations=_BLEND,
        name="Target 1",
        values={"quickness": 0.8, "largeness": 0.6},
    )

    name: str
    values: dict[Name, Unit]


class TargetList(BaseModel):
    """Targets in the order in which they were drawn."""

    targets: list[Target]
