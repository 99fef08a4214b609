"""Whether an answer fits what was asked, and whether an attention check held.

Every fault is one sentence; none means that the answer fits.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import inf
from typing import Any

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
    Instructed,
    Likert,
    Match,
    Parallel,
    Ranking,
    Repeated,
    SemanticDifferential,
    Task,
    Trials,
    Unipolar,
)

Answers = Mapping[str, Any]


def faults_of(part: AnyPart | None, answers: Answers, figures: int) -> list[str]:
    """What is wrong with the answer to a step of this part.

    Args:
        part: of the definition; None for a pause between trials.
        answers: as sent.
        figures: how many figures the step shows.
    """
    if isinstance(part, Trials):
        return _of_task(part.task, answers, figures)
    if isinstance(part, Form):
        return _of_form(part, answers)
    if isinstance(part, CommentPage):
        return _of_text(answers, required=part.required)
    return [f"“{_short(name)}” is not asked here" for name in answers]


def _of_task(task: Task, answers: Answers, figures: int) -> list[str]:
    match task:
        case Ranking():
            return _ranks(answers, figures)
        case FreeText():
            return _of_text(answers, required=task.required)
        case Analogue():
            return _numbers([scale.id for scale in task.scales], answers, 0, 100)
        case Parallel():
            return _numbers([str(place) for place in range(figures)], answers, 0, 100)
        case Choose() | AB() | ABX():
            lowest = -1 if _may_decline(task) else 0
            return _numbers(["choice"], answers, lowest, figures - 1, whole=True)
        case SemanticDifferential() | Unipolar() | Likert():
            return _steps(task, answers)
        case Match():
            return _of_match(answers)


def _of_match(answers: Answers) -> list[str]:
    """Sliders from 0 to 1, and how long it took; which sliders there are, the space knows."""
    sliders = {name: value for name, value in answers.items() if name != "seconds"}
    faults = _numbers(list(sliders) or ["a slider"], sliders, 0, 1)
    return faults + _numbers(
        ["seconds"], {k: v for k, v in answers.items() if k == "seconds"}, 0, inf
    )


def _may_decline(task: Choose | AB | ABX) -> bool:
    return getattr(task, "allow_none", False) or getattr(task, "allow_same", False)


def _steps(task: SemanticDifferential | Unipolar | Likert, answers: Answers) -> list[str]:
    if isinstance(task, SemanticDifferential):
        names = [scale.id for scale in task.scales]
        return _numbers(names, answers, -task.reach, task.reach, whole=True)
    lowest = 1 if isinstance(task, Likert) else 0
    names = [item.id for item in task.items]
    return _numbers(names, answers, lowest, lowest + len(task.steps) - 1, whole=True)


def _ranks(answers: Answers, figures: int) -> list[str]:
    names = [str(place) for place in range(figures)]
    faults = _numbers(names, answers, 1, figures, whole=True)
    if not faults and len(set(answers.values())) < figures:
        faults = ["two figures have the same rank"]
    return faults


def _numbers(
    names: Sequence[str], answers: Answers, low: float, high: float, *, whole: bool = False
) -> list[str]:
    """Each of the names has a number from low to high, and no other has one."""
    faults = [f"“{name}” is not answered" for name in names if name not in answers]
    known = set(names)
    for name, value in answers.items():
        if name not in known:
            faults.append(f"“{_short(name)}” is not asked here")
        elif not _is_number(value) or (whole and value != int(value)):
            faults.append(f"“{name}” is no {'step' if whole else 'number'}")
        elif not low <= value <= high:
            faults.append(f"“{name}” is {value}, not within {low} … {high}")
    return faults


def _of_text(answers: Answers, *, required: bool) -> list[str]:
    faults = [f"“{_short(name)}” is not asked here" for name in answers if name != "text"]
    text = answers.get("text", "")
    if not isinstance(text, str):
        faults.append("“text” is no text")
    elif required and not text.strip():
        faults.append("“text” is not answered")
    return faults


def _of_form(form: Form, answers: Answers) -> list[str]:
    fields = {field.id: field for field in form.fields}
    faults = [f"“{_short(name)}” is not asked here" for name in answers if name not in fields]
    for field in form.fields:
        value = answers.get(field.id)
        if value is None or value in ("", []):
            if field.required:
                faults.append(f"“{field.id}” is not answered")
        elif fault := _of_field(field, value):
            faults.append(f"“{field.id}” {fault}")
    return faults


def _of_field(field: FormField, value: object) -> str | None:
    options = {option.id for option in field.options}
    if field.type == "number":
        if not _is_number(value):
            return "is no number"
        low = -inf if field.minimum is None else field.minimum
        high = inf if field.maximum is None else field.maximum
        return None if low <= float(str(value)) <= high else f"is {value}, not within its limits"
    if field.type == "choices":
        fits = isinstance(value, list) and set(value) <= options
        return None if fits else "is none of its options"
    if field.type == "choice":
        return None if isinstance(value, str) and value in options else "is none of its options"
    return None if isinstance(value, str) else "is no text"


def screens_out(part: AnyPart | None, answers: Answers) -> bool:
    """Whether the answer to a form ends the study for this person."""
    if not isinstance(part, Form):
        return False
    chosen: set[str] = set()
    for field in part.fields:
        value = answers.get(field.id)
        given = set(value) if isinstance(value, list) else {value}
        chosen |= {option.id for option in field.options if option.screens_out} & given
    return bool(chosen)


def held(
    check: Instructed | Repeated | Catch,
    answers: Answers,
    earlier: Answers | None,
    *,
    chosen: bool = False,
) -> bool | None:
    """Whether an attention check held.

    Args:
        check: of the part.
        answers: to the check's trial.
        earlier: the answer to the trial that a repeated one repeats; None where there is none.
        chosen: the answer is a figure, which is chosen again or is not: places are no steps.

    Returns:
        None where there is nothing to compare with.
    """
    match check:
        case Instructed():
            return all(answers.get(name) == value for name, value in check.answers.items())
        case Catch():
            return all(
                _is_number(answers.get(name)) and low <= answers[name] <= high
                for name, (low, high) in check.answers.items()
            )
        case Repeated():
            within = 0 if chosen or check.within is None else check.within
            return _alike(answers, earlier or {}, within)


def _alike(answers: Answers, earlier: Answers, within: float) -> bool | None:
    both = [
        abs(answers[name] - earlier[name])
        for name in answers
        if _is_number(answers[name]) and _is_number(earlier.get(name))
    ]
    return sum(both) / len(both) <= within if both else None


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _short(name: str) -> str:
    return name[:60]
