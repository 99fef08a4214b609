"""The study file: what is shown, asked and promised. Data only, so that it can be hashed."""

from hashlib import sha256
from json import dumps
from typing import Annotated, Self

from pydantic import BaseModel, ConfigDict, Field, StringConstraints, model_validator

Text = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=2000)]
Short = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=64)]
Title = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=200)]
Slug = Annotated[str, StringConstraints(pattern=r"^[a-z0-9]+(-[a-z0-9]+)*$", max_length=100)]
Name = Annotated[str, StringConstraints(pattern=r"^[a-z][a-z0-9_]*$", max_length=60)]

ContentHash = Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{64}$")]


class Part(BaseModel):
    """A part of the study file: never changed once made, and no unknown member is passed over."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Term(Part):
    """One line of what a participant agrees to: a short term and what it means."""

    term: Text
    text: Text


class Consent(Part):
    """What a participant agrees to. A new wording needs a new version."""

    version: Short
    heading: Text
    terms: tuple[Term, ...]
    statement: Text


class Welcome(Part):
    """The first page. The facts: how much there is to do, how long it takes, on what devices.

    `example` is a clip of the library that moves beside the text; best none of the stimuli.
    """

    heading: Text
    lead: Text
    facts: tuple[Text, Text, Text]
    example: ContentHash | None = None


class Thanks(Part):
    """The last page. `{clips}` in the text becomes the number of clips judged."""

    heading: Text
    text: Text


class Scale(Part):
    """A bipolar axis. `left_more` and `right_more` are its poles' comparatives: sadder, happier."""

    id: Name
    left: Text
    right: Text
    left_more: Text
    right_more: Text


class Comment(Part):
    """The box for free text."""

    label: Text
    placeholder: str = ""


class Stimulus(Part):
    """A clip of the study: its identity in the library, and how the results name it."""

    clip: ContentHash
    name: Text
    label: Text
    body: Text
    style: Text


class StudyDefinition(Part):
    """A whole study.

    Attributes:
        steps: words over the steps from the left pole to the right one; their number is odd.
        practice: how many clips come first, drawn at random, unannounced and not analysed.
        stimuli: every participant judges all of them, in an order of his own.
        contact: the researchers' mail address.
    """

    slug: Slug
    title: Title
    welcome: Welcome
    consent: Consent
    question: Text
    hint: Text
    scales: Annotated[tuple[Scale, ...], Field(min_length=1)]
    steps: Annotated[tuple[Text, ...], Field(min_length=3, max_length=11)]
    comment: Comment
    practice: Annotated[int, Field(ge=0)]
    stimuli: Annotated[tuple[Stimulus, ...], Field(min_length=1)]
    thanks: Thanks
    contact: Annotated[str, StringConstraints(pattern=r"^[^@\s]+@[^@\s]+$")] | None = None

    @model_validator(mode="after")
    def _is_consistent(self) -> Self:
        if len(self.steps) % 2 == 0:
            raise ValueError("steps: give an odd number, so that there is a middle")
        if self.practice > len(self.stimuli):
            raise ValueError("practice: more clips than the study has")
        if len({scale.id for scale in self.scales}) < len(self.scales):
            raise ValueError("scales: two have the same id")
        if len({stimulus.clip for stimulus in self.stimuli}) < len(self.stimuli):
            raise ValueError("stimuli: a clip is listed twice")
        return self

    @property
    def reach(self) -> int:
        """The value of the outermost step; answers lie in -reach ... reach."""
        return len(self.steps) // 2

    @property
    def trials(self) -> int:
        """How many clips a participant sees, practice included."""
        return self.practice + len(self.stimuli)

    @property
    def content_hash(self) -> str:
        """SHA-256 of the definition's canonical JSON."""
        canonical = dumps(
            self.model_dump(mode="json"), sort_keys=True, separators=(",", ":"), ensure_ascii=False
        )
        return sha256(canonical.encode()).hexdigest()
