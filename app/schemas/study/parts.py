"""The parts that a study goes through: trials about clips, and pages between them."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, ValidationInfo, field_validator, model_validator

from app.schemas.study.stimuli import ClipRef, Stimulus
from app.schemas.study.tasks import OF_ONE, OF_TWO, Match, Task
from app.schemas.study.words import Name, Part, Words

MOST_TRIALS = 10_000  # of one part; a plan lists them all
ALIKE = 1.0  # step; who answers anything at all is 1.6 of five steps off on average
ALIKE_ON_SLIDERS = 20.0  # points; who answers anything at all is 33 of 100 off: as strict as a step


class Instructed(Part):
    """An attention check that says what to answer: a trial like the others, with this text on it.

    Attributes:
        answers: scale or item id to the step that the text asks for.
    """

    kind: Literal["instructed"] = "instructed"
    id: Name
    text: Words
    answers: Annotated[dict[str, int], Field(min_length=1)]


class Repeated(Part):
    """An attention check by clips that come again: how alike are the two answers?

    Attributes:
        count: how many clips come again, drawn at random.
        within: the check holds if the mean difference per scale, in steps (of a slider: points of
            its 100), is at most this; left out, one step or 20 points. A choice must be the same.
    """

    kind: Literal["repeated"] = "repeated"
    id: Name
    count: Annotated[int, Field(ge=1, le=20)] = 1
    within: Annotated[float, Field(ge=0, le=100)] | None = None


class Catch(Part):
    """An attention check by a clip whose answer nobody who looks can miss.

    Attributes:
        answers: scale or item id to the lowest and the highest step that count as seen.
    """

    kind: Literal["catch"] = "catch"
    id: Name
    stimulus: Stimulus
    answers: Annotated[dict[str, tuple[float, float]], Field(min_length=1)]


Check = Annotated[Instructed | Repeated | Catch, Field(discriminator="kind")]


class Shown(Part):
    """What every part has: an identity, and the groups that see it (all, where none is named)."""

    id: Name
    groups: tuple[Name, ...] | None = None


class Trials(Shown):
    """The same question about one clip after another, or about several at once.

    Attributes:
        practice: how many clips come first, drawn at random, unannounced and not analysed.
        order: a shuffle of each participant's own, a balanced Latin square over participants, or
            as listed.
        block_by: clips of one body or style come together; the blocks change places as well.
        subset: how many of the stimuli each participant sees, every clip equally often in all.
        sets: for kinds with several figures, which stand together, by the stimuli's names; left
            out, all of them at once, and for `ab` and `abx` every pair.
        break_every: a pause is offered after so many trials.
    """

    kind: Literal["trials"] = "trials"
    task: Task
    stimuli: Annotated[tuple[Stimulus, ...], Field(min_length=1, max_length=1000)]
    practice: Annotated[int, Field(ge=0)] = 0
    order: Literal["shuffle", "latin_square", "fixed"] = "shuffle"
    block_by: Literal["body", "style"] | None = None
    subset: Annotated[int, Field(ge=1)] | None = None
    sets: (
        Annotated[
            tuple[Annotated[tuple[str, ...], Field(min_length=2)], ...],
            Field(max_length=MOST_TRIALS),
        ]
        | None
    ) = None
    checks: tuple[Check, ...] = ()
    break_every: Annotated[int, Field(ge=1)] | None = None

    @field_validator("checks")
    @classmethod
    def _say_what_is_alike(
        cls, checks: tuple[Check, ...], info: ValidationInfo
    ) -> tuple[Check, ...]:
        """A version says it itself, so that another default changes no study that was published."""
        kind = getattr(info.data.get("task"), "kind", None)
        within = ALIKE_ON_SLIDERS if kind in ("analogue", "parallel") else ALIKE
        return tuple(
            one.model_copy(update={"within": within})
            if isinstance(one, Repeated) and one.within is None
            else one
            for one in checks
        )

    @model_validator(mode="after")
    def _fits_its_clips(self) -> Self:
        number = len(self.stimuli)
        if self.practice > number:
            raise ValueError("practice: more clips than the part has")
        if self.subset is not None and self.subset > number:
            raise ValueError("subset: more clips than the part has")
        if self.task.kind not in OF_ONE and number < 2:
            raise ValueError(f"stimuli: {self.task.kind} compares; give at least two")
        if isinstance(self.task, Match) and self.practice:
            raise ValueError("practice: matching has practice targets of its own; name them there")
        if self.sets is not None and self.task.kind in OF_ONE:
            raise ValueError(f"sets: {self.task.kind} shows one figure at a time")
        pairs = number * (number - 1) // 2
        if self.sets is None and self.task.kind in OF_TWO and pairs > MOST_TRIALS:
            raise ValueError(f"stimuli: they make {pairs:,} pairs; list in sets which to show")
        if self.sets is not None and self.task.kind in OF_TWO:
            wrong = [one for one in self.sets if len(one) != 2]
            if wrong:
                raise ValueError(f"sets: {self.task.kind} compares two, not {len(wrong[0])}")
        return self


class Option(Part):
    """One answer to choose from; `screens_out` ends the study for who chooses it."""

    id: Name
    label: Words
    screens_out: bool = False


class FormField(Part):
    """One question of a form."""

    id: Name
    label: Words
    type: Literal["text", "long_text", "number", "choice", "choices"] = "text"
    required: bool = True
    minimum: float | None = None
    maximum: float | None = None
    unit: Words | None = None
    options: tuple[Option, ...] = ()

    @model_validator(mode="after")
    def _has_options_if_it_needs_them(self) -> Self:
        if self.type.startswith("choice") == (len(self.options) < 2):
            raise ValueError("options: give two or more for a choice, and none for other types")
        return self


class Form(Shown):
    """Questions about the person."""

    kind: Literal["form"] = "form"
    heading: Words
    text: Words | None = None
    fields: Annotated[tuple[FormField, ...], Field(min_length=1, max_length=100)]


class Example(Part):
    """A moving figure on a page of instructions."""

    clip: ClipRef
    caption: Words | None = None


class Instructions(Shown):
    """A page to read, with figures that move; an empty line parts its paragraphs."""

    kind: Literal["instructions"] = "instructions"
    heading: Words
    text: Words
    figures: Annotated[tuple[Example, ...], Field(max_length=6)] = ()


class Break(Shown):
    """A pause, for as long as one likes."""

    kind: Literal["break"] = "break"
    heading: Words
    text: Words


class CommentPage(Shown):
    """Free text about the whole."""

    kind: Literal["comment"] = "comment"
    question: Words
    placeholder: Words | None = None
    required: bool = False


class Debriefing(Shown):
    """What it was about, at the end."""

    kind: Literal["debriefing"] = "debriefing"
    heading: Words
    text: Words


AnyPart = Annotated[
    Trials | Form | Instructions | Break | CommentPage | Debriefing, Field(discriminator="kind")
]
