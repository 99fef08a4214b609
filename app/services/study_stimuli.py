"""The clips of a study: a file names them or says how they are made, a version knows their ids."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any

from sqlalchemy.orm import Session

from app.errors import InvalidError, MannerError
from app.persistence import clips
from app.persistence.engine import Database
from app.persistence.models import ClipRecord
from app.persistence.writer import Writer
from app.schemas.edits import ClipRequest, Edit
from app.schemas.studies_api import Problem
from app.schemas.study import (
    Authored,
    Catch,
    Instructions,
    Made,
    Match,
    Stimulus,
    StudyDefinition,
    Trials,
    Words,
)
from app.services import edits, library, sets, study_spaces
from app.services.study_text import Path, short
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
    library = _Library(db, definition)
    faults = list(library.problems())
    if faults:
        raise InvalidError(
            faults[0].message,
            code="study_invalid",
            where={"problems": [fault.model_dump() for fault in faults]},
            mend=faults[0].mend,
        )
    make([one.request for one in library.made.values() if one.clip is None])
    return _filled(definition, library)


def shown(db: Session, definition: StudyDefinition) -> StudyDefinition:
    """The definition for a preview: what is not made yet is shown as its source.

    Raises:
        InvalidError: as `resolve`.
    """
    text = resolve(db, definition, lambda requests: None).model_dump_json()
    for clip_id, one in _Library(db, definition).made.items():
        if one.clip is None:
            text = text.replace(clip_id, one.request.source)
    return StudyDefinition.model_validate_json(text)


def problems(db: Session, definition: StudyDefinition) -> list[Problem]:
    """Clips that are not there, and recipes that cannot be read."""
    return list(_Library(db, definition).problems())


@dataclass(frozen=True)
class _Made:
    """A clip to be made, and the one that is there already."""

    request: ClipRequest
    clip: ClipRecord | None


class _Library:
    """The clips that a definition refers to, looked up together."""

    def __init__(self, db: Session, definition: StudyDefinition) -> None:
        self._db = db
        self._definition = definition
        references = {reference for _, reference in _references(definition)}
        self._found: dict[str, list[ClipRecord]] = {one: [] for one in references}
        for clip in clips.named(db, references):
            own = {clip.id} if clip.state == "retired" else {clip.id, clip.name}
            for called in own & references:
                self._found[called].append(clip)
        self.made: dict[str, _Made] = {}
        self._ids: dict[str, str] = {}
        self._faults: list[Problem] = []
        for path, stimulus in _stimuli(definition):
            if stimulus.clip is None and (edit := self._edit(path, stimulus.made)) is not None:
                self._plan(path, stimulus, edit)
        for path, task in _matches(definition):
            self._faults += study_spaces.problems(db, task, path)

    def problems(self) -> Iterator[Problem]:
        names: list[str] | None = None
        for path, reference in _references(self._definition):
            found = self._found[reference]
            if len(found) == 1 and self._usable(reference):
                continue
            if names is None:
                names = clips.names(self._db)
            yield _missing(path, reference, found, names)
        yield from self._faults
        if names is None and not self._faults:
            yield from self._alike()

    def _alike(self) -> Iterator[Problem]:
        """Stimuli of one part that turn out to be the same clip, or to have the same name."""
        seen: dict[tuple[Path, str], int] = {}
        for path, stimulus in _stimuli(self._definition):
            clip_id, name, _ = self.of(stimulus)
            number = int(path[-1]) if isinstance(path[-1], int) else -1
            for what in (clip_id, f"name {stimulus.name or name}") if number >= 0 else ():
                first = seen.setdefault((path[:3], what), number)
                if first != number:
                    is_same = what == clip_id
                    told = "is the same clip as" if is_same else "has the same name as"
                    yield Problem(
                        where=list(path),
                        message=f"This {told} number {first + 1}.",
                        mend="Keep one of the two." if is_same else "Give it a name of its own.",
                    )
                    break

    def clip(self, reference: str) -> ClipRecord:
        return self._found[reference][0]

    def space(self, reference: str) -> str:
        space = study_spaces.find(self._db, reference)
        return reference if space is None else space.record.id

    def of(self, stimulus: Stimulus) -> tuple[str, str, Mapping[str, str]]:
        """Id, name and tags of the clip that a stimulus shows."""
        if stimulus.clip is not None:  # of a version that was made before, whatever the engine now
            clip = self.clip(stimulus.clip)
            return clip.id, clip.name, clip.tags
        made_id = self._ids[_key(stimulus)]
        made = self.made[made_id]
        return made_id, made.request.name or "", made.request.tags

    def _usable(self, reference: str) -> bool:
        found = self._found[reference]
        return len(found) == 1 and found[0].state != "to_confirm"

    def _edit(self, path: Path, made: Made | Authored | None) -> Edit | None:
        """How a stimulus is made, as a request; None where it cannot be, which is told."""
        if isinstance(made, Authored):
            return self._authored(path, made)
        if made is None or not self._usable(made.source):
            return None
        operations = None if made.operations is None else list(made.operations)
        return Edit(source=self.clip(made.source).id, preset=made.preset, operations=operations)

    def _authored(self, path: Path, made: Authored) -> Edit | None:
        try:
            edit = study_spaces.edit_of(self._db, made)
        except MannerError as error:
            self._faults.append(study_spaces.fault_of(path, error))
            return None
        if edit is None:
            self._faults.append(study_spaces.missing(made.space, (*path, "made", "space")))
        return edit

    def _plan(self, path: Path, stimulus: Stimulus, edit: Edit) -> None:
        source = library.find(self._db, edit.source, signed_in=True)
        try:
            recipe = edits.read_recipe(edit)
        except MannerError as error:
            self._faults.append(_recipe_fault(path, error))
            return
        made_id = edits.edited_id(source.id, recipe)
        request = _request(source, stimulus, edit)
        self.made[made_id] = _Made(request, clips.by_id(self._db, made_id))
        self._ids[_key(stimulus)] = made_id


def _request(source: ClipRecord, stimulus: Stimulus, edit: Edit) -> ClipRequest:
    """How the clip is made and called: by a preset as in a set, else after the stimulus."""
    if edit.preset is not None:
        name, tags = sets.name_and_tags(source, edit.preset)
    else:
        recipe = edits.read_recipe(edit)
        ending = stimulus.name or f"edited {recipe.hash[:6]}"
        name = f"{source.name[:100]} · {ending}"
        tags = {"made": "modified", "from": source.name, **sets.kept_tags(source)}
    return ClipRequest(**edit.model_dump(), name=name, tags=tags)


def _key(stimulus: Stimulus) -> str:
    return "" if stimulus.made is None else stimulus.made.model_dump_json()


def _recipe_fault(path: Path, error: MannerError) -> Problem:
    place = (error.where or {}).get("path") or [(error.where or {}).get("field", "preset")]
    return Problem(where=[*path, "made", *place], message=error.message, mend=error.mend)


def _missing(
    path: Path, reference: str, found: Sequence[ClipRecord], names: Sequence[str]
) -> Problem:
    told = f"“{short(reference)}”"
    if len(found) > 1:
        return Problem(
            where=list(path),
            message=f"{len(found)} clips of the library are called {told}.",
            mend=f"Give the id of the one you mean, such as {found[0].id}.",
        )
    if found:
        return Problem(
            where=list(path),
            message=f"The clip {told} waits to be confirmed.",
            mend="Look through its import report in the library and keep it.",
        )
    near = get_close_matches(reference, names, 1, 0.6)
    mend = f"Did you mean “{short(near[0])}”?" if near else "Look for its name in the library."
    return Problem(where=list(path), message=f"The library has no clip {told}.", mend=mend)


def _references(definition: StudyDefinition) -> Iterator[tuple[Path, str]]:
    """Every clip that is named, with its place in the file."""
    if definition.welcome.example is not None:
        yield ("welcome", "example"), definition.welcome.example
    for index, part in enumerate(definition.parts):
        place: Path = ("parts", index)
        if isinstance(part, Instructions):
            for number, figure in enumerate(part.figures):
                yield (*place, "figures", number, "clip"), figure.clip
        if isinstance(part, Trials) and (reference := getattr(part.task, "reference", None)):
            yield (*place, "task", "reference"), reference
    for path, stimulus in _stimuli(definition):
        if stimulus.clip is not None:
            yield (*path, "clip"), stimulus.clip
        elif isinstance(stimulus.made, Made):
            yield (*path, "made", "source"), stimulus.made.source


def _matches(definition: StudyDefinition) -> Iterator[tuple[Path, Match]]:
    """Every task that matches targets, with its place in the file."""
    for index, part in enumerate(definition.parts):
        if isinstance(part, Trials) and isinstance(part.task, Match):
            yield ("parts", index, "task"), part.task


def _stimuli(definition: StudyDefinition) -> Iterator[tuple[Path, Stimulus]]:
    for index, part in enumerate(definition.parts):
        if not isinstance(part, Trials):
            continue
        for number, stimulus in enumerate(part.stimuli):
            yield ("parts", index, "stimuli", number), stimulus
        for number, stimulus in enumerate(getattr(part.task, "practice_targets", ())):
            yield ("parts", index, "task", "practice_targets", number), stimulus
        for number, check in enumerate(part.checks):
            if isinstance(check, Catch):
                yield ("parts", index, "checks", number, "stimulus"), check.stimulus


def _filled(definition: StudyDefinition, library: _Library) -> StudyDefinition:
    given = definition.model_dump(mode="json")
    if definition.welcome.example is not None:
        given["welcome"]["example"] = library.clip(definition.welcome.example).id
    for part, target in zip(definition.parts, given["parts"], strict=True):
        if isinstance(part, Instructions):
            for figure in target["figures"]:
                figure["clip"] = library.clip(figure["clip"]).id
        elif isinstance(part, Trials):
            _fill_trials(part, target, library)
    return StudyDefinition.model_validate(given)


def _fill_trials(part: Trials, target: dict[str, Any], library: _Library) -> None:
    if reference := target["task"].get("reference"):
        target["task"]["reference"] = library.clip(reference).id
    stimuli = [_fill(one, library) for one in part.stimuli]
    called = {
        name: filled["name"]
        for one, filled in zip(part.stimuli, stimuli, strict=True)
        for name in (filled["name"], one.clip, one.name)
        if name is not None
    }
    target["stimuli"] = stimuli
    if isinstance(part.task, Match):
        practice = [_fill(one, library) for one in part.task.practice_targets]
        target["task"]["practice_targets"] = practice
        target["task"]["space"] = library.space(part.task.space)
    if part.sets is not None:
        target["sets"] = [[called.get(name, name) for name in one] for one in part.sets]
    for check, filled_check in zip(part.checks, target["checks"], strict=True):
        if isinstance(check, Catch):
            filled_check["stimulus"] = _fill(check.stimulus, library)


def _fill(stimulus: Stimulus, library: _Library) -> dict[str, Any]:
    """The stimulus with its clip's id; what its author left out comes from the clip's tags."""
    clip_id, name, tags = library.of(stimulus)
    own = tags.get("style") or tags.get("preset", "").replace("_", " ") or tags.get("emotion")
    style = stimulus.style or own
    words = (style or stimulus.name or name, tags.get("speed"), tags.get("body"), tags.get("made"))
    filled = stimulus.model_dump(mode="json")
    label = Words(", ".join(word for word in words if word)).model_dump(mode="json")
    filled["clip"] = clip_id
    if stimulus.clip is None and isinstance(stimulus.made, Authored):
        filled["made"]["space"] = library.space(stimulus.made.space)
    filled["name"] = filled["name"] or name[:LONGEST_NAME].strip()
    filled["label"] = filled["label"] or label
    filled["body"] = filled["body"] or tags.get("body")
    filled["style"] = style
    return filled
