"""The stimuli of a study: a file names them or says how they are made, a version has their ids."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from sqlalchemy.orm import Session

from app.errors import InvalidError, MannerError
from app.persistence.engine import Database
from app.persistence.writer import Writer
from app.schemas.edits import ClipRequest
from app.schemas.studies_api import Problem
from app.schemas.study import (
    Authored,
    Catch,
    Instructions,
    Match,
    Stimulus,
    StudyDefinition,
    Trials,
    Words,
)
from app.services import edits
from app.services.study_clips import StudyClips
from app.workers import Workers

Make = Callable[[Sequence[ClipRequest]], None]
LONGEST_NAME = 64


def maker(database: Database, writer: Writer, workers: Workers) -> Make:
    """Makes clips, a few at a time, each stored as soon as it is made."""

    def make_one(request: ClipRequest) -> None:
        try:
            edits.create(database, writer, workers, request)
        except MannerError as error:
            message = f"“{request.name}” cannot be made. {error.message}"
            raise InvalidError(message, code=error.code, mend=error.mend) from error

    def make(requests: Sequence[ClipRequest]) -> None:
        with ThreadPoolExecutor(os.cpu_count()) as threads:  # they wait for the workers' processes
            list(threads.map(make_one, requests))

    return make


def resolve(db: Session, definition: StudyDefinition, make: Make) -> StudyDefinition:
    """The definition as it is published: every clip by its id, every stimulus named and labelled.

    What is to be made and is in the library already is not made again, so that the same file gives
    the same definition however often it is resolved.

    Args:
        db: reads only; `make` writes in transactions of its own.
        definition: as its author wrote it.
        make: makes clips; nothing at all if only the outcome shall be known.

    Raises:
        InvalidError: a clip is not there or cannot be made; where.problems has them all.
    """
    found = StudyClips(db, definition)
    faults = list(found.problems())
    if faults:
        raise InvalidError(
            faults[0].message,
            code="study_invalid",
            where={"problems": [fault.model_dump() for fault in faults]},
            mend=faults[0].mend,
        )
    make([one.request for one in found.made.values() if one.clip is None])
    return _filled(definition, found)


def shown(db: Session, definition: StudyDefinition) -> StudyDefinition:
    """The definition for a preview: what is not made yet is shown as its source.

    Raises:
        InvalidError: as `resolve`.
    """
    text = resolve(db, definition, lambda requests: None).model_dump_json()
    for clip_id, one in StudyClips(db, definition).made.items():
        if one.clip is None:
            text = text.replace(clip_id, one.request.source)
    return StudyDefinition.model_validate_json(text)


def problems(db: Session, definition: StudyDefinition) -> list[Problem]:
    """Clips that are not there, and recipes that cannot be read."""
    return list(StudyClips(db, definition).problems())


def _filled(definition: StudyDefinition, found: StudyClips) -> StudyDefinition:
    given = definition.model_dump(mode="json")
    if definition.welcome.example is not None:
        given["welcome"]["example"] = found.clip(definition.welcome.example).id
    for part, target in zip(definition.parts, given["parts"], strict=True):
        if isinstance(part, Instructions):
            for figure in target["figures"]:
                figure["clip"] = found.clip(figure["clip"]).id
        elif isinstance(part, Trials):
            _fill_trials(part, target, found)
    return StudyDefinition.model_validate(given)


def _fill_trials(part: Trials, target: dict[str, Any], found: StudyClips) -> None:
    if reference := target["task"].get("reference"):
        target["task"]["reference"] = found.clip(reference).id
    stimuli = [_fill(one, found) for one in part.stimuli]
    called = {
        name: filled["name"]
        for one, filled in zip(part.stimuli, stimuli, strict=True)
        for name in (filled["name"], one.clip, one.name)
        if name is not None
    }
    target["stimuli"] = stimuli
    if isinstance(part.task, Match):
        practice = [_fill(one, found) for one in part.task.practice_targets]
        target["task"]["practice_targets"] = practice
        target["task"]["space"] = found.space(part.task.space)
    if part.sets is not None:
        target["sets"] = [[called.get(name, name) for name in one] for one in part.sets]
    for check, filled_check in zip(part.checks, target["checks"], strict=True):
        if isinstance(check, Catch):
            filled_check["stimulus"] = _fill(check.stimulus, found)


def _fill(stimulus: Stimulus, found: StudyClips) -> dict[str, Any]:
    """The stimulus with its clip's id; what its author left out comes from the clip's tags."""
    clip_id, name, tags = found.of(stimulus)
    own = tags.get("style") or tags.get("preset", "").replace("_", " ") or tags.get("emotion")
    style = stimulus.style or own
    words = (style or stimulus.name or name, tags.get("speed"), tags.get("body"), tags.get("made"))
    filled = stimulus.model_dump(mode="json")
    label = Words(", ".join(word for word in words if word)).model_dump(mode="json")
    filled["clip"] = clip_id
    if stimulus.clip is None and isinstance(stimulus.made, Authored):
        filled["made"]["space"] = found.space(stimulus.made.space)
    filled["name"] = filled["name"] or name[:LONGEST_NAME].strip()
    filled["label"] = filled["label"] or label
    filled["body"] = filled["body"] or tags.get("body")
    filled["style"] = style
    return filled
