"""The clips that a study refers to, looked up in the library, and what is wrong with them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches

from sqlalchemy.orm import Session

from app.errors import MannerError
from app.persistence import clips
from app.persistence.models import ClipRecord
from app.schemas.edits import ClipRequest, Edit
from app.schemas.studies_api import Problem
from app.schemas.study import Authored, Made, Stimulus, StudyDefinition
from app.services import edits, library, sets, study_references, study_spaces
from app.services.study_text import Path, short


@dataclass(frozen=True)
class ClipToMake:
    """A clip to be made, and the one that is there already."""

    request: ClipRequest
    clip: ClipRecord | None


class StudyClips:
    """The clips that a definition refers to, looked up together."""

    def __init__(self, db: Session, definition: StudyDefinition) -> None:
        self._db = db
        self._definition = definition
        references = {reference for _, reference in study_references.references(definition)}
        self._found: dict[str, list[ClipRecord]] = {one: [] for one in references}
        for clip in clips.named(db, references):
            own = {clip.id} if clip.state == "retired" else {clip.id, clip.name}
            for called in own & references:
                self._found[called].append(clip)
        self.made: dict[str, ClipToMake] = {}
        self._ids: dict[str, str] = {}
        self._faults: list[Problem] = []
        for path, stimulus in study_references.stimuli(definition):
            if stimulus.clip is None and (edit := self._edit(path, stimulus.made)) is not None:
                self._plan(path, stimulus, edit)
        for path, task in study_references.matches(definition):
            self._faults += study_spaces.problems(db, task, path)

    def problems(self) -> Iterator[Problem]:
        """What keeps the study from being published, of its clips."""
        names: list[str] | None = None
        for path, reference in study_references.references(self._definition):
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
        for path, stimulus in study_references.stimuli(self._definition):
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
        """The clip of this name or id; `problems` has told if there is none."""
        return self._found[reference][0]

    def space(self, reference: str) -> str:
        """The id of the space of this name."""
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
        self.made[made_id] = ClipToMake(request, clips.by_id(self._db, made_id))
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
