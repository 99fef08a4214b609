"""What an answer holds, kind by kind.

The one place where tables, results, scripts and simulated raters learn what a part asks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from app.schemas.codebook import Kind
from app.schemas.study import (
    AB,
    ABX,
    Analogue,
    AnyPart,
    Catch,
    Choose,
    CommentPage,
    Form,
    FormField,
    FreeText,
    Likert,
    Match,
    Parallel,
    Ranking,
    SemanticDifferential,
    Stimulus,
    Task,
    Trials,
    Unipolar,
    Words,
)

# These give every figure of a trial a number of its own.
EACH_FIGURE = ("parallel", "ranking")
CHOICES = ("choose", "ab", "abx")
NONE, SAME = "none", "same"  # what a choice of no figure is called


@dataclass(frozen=True)
class Measure:
    """One value of an answer.

    Attributes:
        part: the part that asks; trial_type: its kind of trial or page.
        id: under which the answer holds it (for a choice, a rating or a rank: its name here).
        title: what it is about, in words.
        type: as the codebook has it; numbers are "integer" or "number".
        left, right: the words at the ends of its range; lowest, highest: the range.
        levels: each value that can be counted, and what it stands for.
        steps: the words over the steps alone.
        option: of a question with several answers, the one that this column is about.
    """

    part: str
    trial_type: str
    id: str
    title: str
    type: Kind
    left: str = ""
    right: str = ""
    left_more: str = ""
    right_more: str = ""
    lowest: float | None = None
    highest: float | None = None
    levels: tuple[tuple[int | str, str], ...] = ()
    steps: tuple[str, ...] = ()
    unit: str | None = None
    option: str | None = None

    @property
    def numeric(self) -> bool:
        """Whether means over clips make sense: it was asked of clips, and on a scale."""
        return self.lowest is not None

    @property
    def of_clips(self) -> bool:
        """Whether it was asked of clips, and not on a page between them."""
        return self.trial_type not in ("form", "comment")

    @property
    def middle(self) -> float:
        """The value in the middle of the range."""
        return ((self.lowest or 0) + (self.highest or 0)) / 2

    def read(self, answers: dict[str, Any], names: Sequence[str], figure: int | None = None) -> Any:  # noqa: ANN401 -- a cell of any type
        """The value in an answer.

        Args:
            answers: as they are stored.
            names: of the figures of the trial, as they stood on the page; needed for choices.
            figure: for kinds that give each figure a number, which figure.
        """
        if self.trial_type in EACH_FIGURE:
            return answers.get(str(figure))
        if self.trial_type in CHOICES:
            return self._chosen(answers.get("choice"), names)
        if self.option is None:
            return answers.get(self.id)
        given = answers.get(self.id.removesuffix(f"__{self.option}"))
        return None if given is None else int(self.option in given)

    def _chosen(self, choice: int | None, names: Sequence[str]) -> str | int | None:
        if choice is None:
            return None
        if self.id == "correct":
            return int(names[choice] == names[2]) if len(names) > 2 else None
        if choice < 0:
            return SAME if self.trial_type == "ab" else NONE
        return names[choice]


def measures(part: AnyPart) -> list[Measure]:
    """What a part's answers hold, in its order; nothing for pages that are only read."""
    match part:
        case Trials():
            return _of_task(part.id, part.task, len(part.stimuli))
        case Form():
            return [one for field in part.fields for one in _of_field(part.id, field)]
        case CommentPage():
            return [Measure(part.id, part.kind, "text", f"“{part.question}”", "text")]
        case _:
            return []


def shown_in(part: Trials) -> list[Stimulus]:
    """The clips of a part, those for practice and of its attention checks last."""
    practice = getattr(part.task, "practice_targets", ())
    checks = (one.stimulus for one in part.checks if isinstance(one, Catch))
    return [*part.stimuli, *practice, *checks]


def _of_task(part: str, task: Task, clips: int) -> list[Measure]:
    start = Measure(part, task.kind, "", str(task.question), "integer")
    match task:
        case SemanticDifferential():
            return _bipolar(start, task)
        case Unipolar() | Likert():
            first = 0 if isinstance(task, Unipolar) else 1
            levels = tuple(enumerate(map(str, task.steps), first))
            stepped = replace(
                start, lowest=first, highest=levels[-1][0], levels=levels,
                steps=tuple(map(str, task.steps)), unit="steps",
                left=str(task.steps[0]), right=str(task.steps[-1]),
            )  # fmt: skip
            return [replace(stepped, id=one.id, title=f"“{one.label}”") for one in task.items]
        case Analogue():
            slider = replace(start, type="number", lowest=0, highest=100, unit="points")
            return [
                replace(slider, id=one.id, title=f"from {one.left} (0) to {one.right} (100)",
                        left=str(one.left), right=str(one.right))
                for one in task.scales
            ]  # fmt: skip
        case Parallel():
            title = f"“{task.question}”, from {task.low} (0) to {task.high} (100)"
            slider = replace(start, id="rating", title=title, type="number", unit="points")
            ended = replace(slider, left=str(task.low), right=str(task.high))
            return [replace(ended, lowest=0, highest=100)]
        case Ranking():
            title = f"“{task.question}”, from 1 ({task.first}) on ({task.last})"
            place = replace(start, id="rank", title=title, lowest=1, highest=clips)
            return [replace(place, left=str(task.first), right=str(task.last))]
        case FreeText():
            return [replace(start, id="text", title=f"“{task.question}”", type="text")]
        case Choose() | AB() | ABX():
            return _choices(start, task)
        case Match():
            return _of_match(start, task)


def _of_match(start: Measure, task: Match) -> list[Measure]:
    seen = ((0, "a guess, unseen"), (1, "seen"))
    limit = f"{task.threshold:g} m within {task.seconds} s"
    number = replace(start, type="number")
    category = replace(start, type="category")
    return [
        replace(category, id="interface", title="by which sliders the target was made",
                levels=tuple((one, one) for one in task.interfaces)),
        replace(category, id="seen", title="whether the motion was seen meanwhile", levels=seen),
        replace(number, id="distance", unit="m",
                title="mean distance of the joints from the target's at the end"),
        replace(category, id="solved", title=f"whether the distance was below {limit}",
                levels=((0, "no"), (1, "yes"))),
        replace(number, id="seconds", unit="s", title="how long the sliders were moved"),
        replace(start, id="engine", type="text", title="the engine’s version that measured it"),
    ]  # fmt: skip


def _bipolar(start: Measure, task: SemanticDifferential) -> list[Measure]:
    words = tuple(map(str, task.steps))

    def levels(left: Words, right: Words) -> tuple[tuple[int, str], ...]:
        named = enumerate(words, -task.reach)
        poles = {True: f" {right}", False: f" {left}"}
        return tuple((step, word + (poles[step > 0] if step else "")) for step, word in named)

    return [
        replace(
            start, id=one.id, lowest=-task.reach, highest=task.reach, unit="steps", steps=words,
            title=f"from {one.left} to {one.right}; toward {one.right} is positive",
            left=str(one.left), right=str(one.right), levels=levels(one.left, one.right),
            left_more=str(one.left_more or f"more {one.left}"),
            right_more=str(one.right_more or f"more {one.right}"),
        )
        for one in task.scales
    ]  # fmt: skip


def _choices(start: Measure, task: Choose | AB | ABX) -> list[Measure]:
    said = ""
    if isinstance(task, Choose) and task.allow_none:
        said = f", or “{NONE}”"
    if isinstance(task, AB) and task.allow_same:
        said = f", or “{SAME}”"
    if isinstance(task, ABX):
        said = ", the one that the third was taken for"
    title = f"“{task.question}”: the chosen clip’s name{said}"
    found = [replace(start, id="choice", title=title, type="category")]
    if isinstance(task, ABX):
        right = replace(start, id="correct", title="whether the choice was right", type="category")
        found.append(replace(right, levels=((0, "no"), (1, "yes"))))
    return found


def _of_field(part: str, field: FormField) -> list[Measure]:
    start = Measure(
        part, "form", field.id, f"“{field.label}”", "text", unit=str(field.unit or "") or None
    )
    options = tuple((option.id, str(option.label)) for option in field.options)
    if field.type == "choices":
        return [
            replace(start, id=f"{field.id}__{name}", option=name, type="category",
                    title=f"“{field.label}”: {label}", levels=((0, "not chosen"), (1, "chosen")))
            for name, label in options
        ]  # fmt: skip
    if field.type == "choice":
        return [replace(start, type="category", levels=options)]
    return [replace(start, type="number" if field.type == "number" else "text")]
