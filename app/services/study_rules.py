"""What a study file can say that no member alone forbids: names that nothing has, missing texts."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from difflib import get_close_matches
from itertools import combinations

from pydantic import BaseModel

from app.schemas.studies_api import Problem
from app.schemas.study import (
    LANGUAGE_NAMES,
    OF_ONE,
    OF_TWO,
    Analogue,
    Catch,
    Form,
    FormField,
    Instructed,
    Likert,
    Repeated,
    Running,
    SemanticDifferential,
    StudyDefinition,
    Task,
    Trials,
    Unipolar,
    Words,
)
from app.services.plans import PAUSE
from app.services.study_text import Path, short

CLIPS = "{clips}"  # in the thanks it becomes the number of clips that were judged
_PLACEHOLDER = re.compile(r"\{[^{}\n]{0,40}\}")


def problems(definition: StudyDefinition, running: Running | None = None) -> list[Problem]:
    """All that would make the study other than its author means; the file's shape is right."""
    return [
        Problem(where=list(where), message=message, mend=mend)
        for rule in (_texts, _parts, _groups)
        for where, message, mend in rule(definition)
    ] + [
        Problem(where=["running", *where], message=message, mend=mend)
        for where, message, mend in (_running(definition, running) if running else ())
    ]


Found = Iterator[tuple[Path, str, str]]


def _texts(definition: StudyDefinition) -> Found:
    """A text for each language, and no braces that stay as they are."""
    for path, words in _all_words(definition, ()):
        yield from _languages(path, words, definition)
        texts = [words.root] if isinstance(words.root, str) else list(words.root.values())
        for text in texts:
            yield from _placeholders(path, text)


def _languages(path: Path, words: Words, definition: StudyDefinition) -> Found:
    missing = words.missing(definition.languages)
    if missing:
        names = ", ".join(LANGUAGE_NAMES[language] for language in missing)
        yield path, f"The text is missing in {names}.", f"Add {missing[0]}: and the text."
    if isinstance(words.root, dict):
        for language in words.root:
            if language not in definition.languages:
                name = LANGUAGE_NAMES[language]
                mend = f"Add {language} to languages, or take the text out."
                yield (*path, language), f"The study is not in {name}.", mend


def _placeholders(path: Path, text: str) -> Found:
    for found in _PLACEHOLDER.findall(text):
        if path == ("thanks", "text") and found == CLIPS:
            continue
        told = f"Nothing fills {short(found)}."
        if path == ("thanks", "text"):
            yield path, told, f"Did you mean {CLIPS}, the number of clips judged?"
        elif found == CLIPS:
            yield path, told, "Only the text of the thanks knows the number of clips."


def _all_words(value: object, path: Path) -> Iterator[tuple[Path, Words]]:
    if isinstance(value, Words):
        yield path, value
    elif isinstance(value, BaseModel):
        for name in type(value).model_fields:
            yield from _all_words(getattr(value, name), (*path, name))
    elif isinstance(value, tuple):
        for index, one in enumerate(value):
            yield from _all_words(one, (*path, index))


def _parts(definition: StudyDefinition) -> Found:
    checks: dict[str, Path] = {}
    for index, part in enumerate(definition.parts):
        place: Path = ("parts", index)
        if part.id == PAUSE.id:
            told = f"“{PAUSE.id}” is what the server calls the pauses between trials."
            yield (*place, "id"), told, "Give the part another id."
        if isinstance(part, Form):
            yield from _form(part, place)
        if isinstance(part, Trials):
            yield from _trials(part, place)
            for number, check in enumerate(part.checks):
                where = (*place, "checks", number, "id")
                if check.id in checks:
                    yield where, f"Two checks are called “{check.id}”.", "Give one another id."
                checks[check.id] = where


def _form(form: Form, place: Path) -> Found:
    yield from _each_once([field.id for field in form.fields], (*place, "fields"), "fields")
    for index, field in enumerate(form.fields):
        yield from _field(field, (*place, "fields", index))


def _field(field: FormField, place: Path) -> Found:
    yield from _each_once([one.id for one in field.options], (*place, "options"), "options")
    low, high = field.minimum, field.maximum
    if field.type != "number":
        for name in ("minimum", "maximum", "unit"):
            if getattr(field, name) is not None:
                message = f"A field of the type {field.type} has no {name}."
                yield (*place, name), message, "Take it out, or write type: number."
    elif low is not None and high is not None and low > high:
        yield (*place, "maximum"), "The maximum is below the minimum.", "Exchange the two."
    if field.options and all(option.screens_out for option in field.options):
        yield (*place, "options"), "Every answer ends the study.", "Let one go on."


def _trials(part: Trials, place: Path) -> Found:
    task = part.task
    for name in ("scales", "items"):
        ids = [one.id for one in getattr(task, name, ())]
        yield from _each_once(ids, (*place, "task", name), name)
    yield from _stimuli(part, place)
    yield from _sets(part, place)
    yield from _block_by(part, place)
    for index, check in enumerate(part.checks):
        yield from _check(part, check, (*place, "checks", index))


def _stimuli(part: Trials, place: Path) -> Found:
    known: dict[str, int] = {}
    for index, stimulus in enumerate(part.stimuli):
        where = (*place, "stimuli", index)
        what = stimulus.clip or (stimulus.made.model_dump_json() if stimulus.made else "")
        if known.setdefault(what, index) != index:
            told = f"This is the same clip as number {known[what] + 1}."
            yield where, told, "Keep one. A clip is shown again by a check of the kind repeated."
    names = [name for name in (stimulus.name for stimulus in part.stimuli) if name]
    yield from _each_once(names, (*place, "stimuli"), "stimuli")


def _sets(part: Trials, place: Path) -> Found:
    names = {word for one in part.stimuli for word in (one.name, one.clip) if word}
    for index, members in enumerate(part.sets or ()):
        where = (*place, "sets", index)
        for number, name in enumerate(members):
            if name not in names:
                told = f"No stimulus of this part is called “{short(name)}”."
                yield (*where, number), told, _offer(name, sorted(names))
            elif name in members[:number]:
                yield (*where, number), f"“{short(name)}” is in this set twice.", "Keep one."
    if part.subset is not None and part.task.kind not in OF_ONE:
        number = len(part.sets) if part.sets is not None else _together(part)
        if part.subset > number:
            told = f"There are {number} trials to choose {part.subset} from."
            yield (*place, "subset"), told, "Give a smaller number, or more sets."


def _together(part: Trials) -> int:
    """How many trials there are without sets: every pair, or all figures at once."""
    return len(list(combinations(part.stimuli, 2))) if part.task.kind in OF_TWO else 1


def _block_by(part: Trials, place: Path) -> Found:
    if part.block_by is None:
        return
    if part.task.kind not in OF_ONE:
        told = f"A trial of the kind {part.task.kind} shows clips of several bodies and styles."
        yield (*place, "block_by"), told, "Take it out."
    elif part.order == "fixed":
        yield (*place, "block_by"), "Clips in a fixed order form no blocks.", "Take it out."


def _check(part: Trials, check: Instructed | Repeated | Catch, place: Path) -> Found:
    if isinstance(check, Repeated):
        if part.task.kind in ("free_text", "match"):
            what = "texts" if part.task.kind == "free_text" else "matches"
            yield place, f"Two {what} cannot be compared.", "Take the check out."
        number = part.subset or len(part.stimuli)
        if part.task.kind in OF_ONE and check.count > number:
            told = f"Only {number} clips are there to come again."
            yield (*place, "count"), told, "Give a smaller number."
        return
    limits = _limits(part.task)
    if limits is None:
        told = f"A trial of the kind {part.task.kind} has no answer that can be told."
        yield place, told, "Use a check of the kind repeated, or none."
        return
    names, low, high = limits
    for name, wanted in check.answers.items():
        where = (*place, "answers", name)
        bounds = (wanted, wanted) if isinstance(wanted, int) else wanted
        if name not in names:
            yield where, f"The task has no “{short(name)}”.", _offer(name, names)
        elif bounds[0] > bounds[1]:
            yield where, "The lowest answer is above the highest.", "Exchange the two."
        elif bounds[0] < low or bounds[1] > high:
            told = f"No answer is {_outside(bounds, low, high):g}."
            yield where, told, f"Give {low:g} to {high:g}."


def _limits(task: Task) -> tuple[list[str], float, float] | None:
    """What one figure is asked, and the least and the greatest answer; None for other kinds."""
    match task:
        case SemanticDifferential():
            return [scale.id for scale in task.scales], -task.reach, task.reach
        case Unipolar():
            return [item.id for item in task.items], 0, len(task.steps) - 1
        case Likert():
            return [item.id for item in task.items], 1, len(task.steps)
        case Analogue():
            return [scale.id for scale in task.scales], 0, 100
        case _:
            return None


def _outside(bounds: tuple[float, float], low: float, high: float) -> float:
    return bounds[0] if not low <= bounds[0] <= high else bounds[1]


def _groups(definition: StudyDefinition) -> Found:
    if not definition.trials:
        yield ("parts",), "No part shows a clip.", "Add a part of the kind trials."
        return
    for index, group in enumerate(definition.groups):
        if not any(part.groups is None or group.id in part.groups for part in definition.trials):
            told = f"The group “{group.id}” sees no clip."
            yield ("groups", index), told, "Add it to the groups of a part of the kind trials."


def _running(definition: StudyDefinition, running: Running) -> Found:
    if running.fail_after is not None:
        number = sum(
            check.count if isinstance(check, Repeated) else 1
            for part in definition.trials
            for check in part.checks
        )
        if number < running.fail_after:
            told = f"The study has {number} attention checks, so nobody can fail so many."
            yield ("fail_after",), told, "Add checks to a part, or lower the number."
    if running.sona is not None and "{id}" not in running.sona.credit_url:
        where = ("sona", "credit_url")
        yield where, "The address does not say whose credit it is.", "Put {id} where SONA has XXXX."


def _each_once(names: Sequence[str], place: Path, what: str) -> Found:
    for index, name in enumerate(names):
        if name in names[:index]:
            told = f"Two of the {what} are called “{short(name)}”."
            yield (*place, index), told, "Give one another name."


def _offer(given: str, known: Sequence[str]) -> str:
    near = get_close_matches(given, known, 1, 0.6)
    if near:
        return f"Did you mean “{short(near[0])}”?"
    return f"There are: {short(', '.join(known), 200)}."
