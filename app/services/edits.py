"""Edited clips: a recipe done to a clip of the library, tried out or kept.

An edited clip is known by what it is made of: source, recipe and engine. Asking for it twice, also
at the same moment, gives the same clip. Computing happens before the transaction that stores it,
in a process of ``app.workers``; nothing half done is ever stored.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError
from app.persistence import clips, poses
from app.persistence.engine import Database
from app.persistence.models import ClipRecord
from app.persistence.writer import Writer
from app.schemas.edits import Checked, ClipRequest, EasedOff, Edit, Rebuilt
from app.schemas.library import ClipDetail
from app.services import library
from app.services.engine_version import engine_version
from app.workers import Workers

if TYPE_CHECKING:
    from app.services.clip_files import ClipFiles
    from app.services.rendering import Supplies
    from motion.recipe import Recipe

# The motion library and ``rendering``, which needs it, are imported where they are used: they bring
# SciPy, for which the server's start shall not wait.


@dataclass(frozen=True)
class Work:
    """A recipe and all that is needed to do it, read from the database."""

    recipe: Recipe
    source: ClipRecord
    content: bytes
    supplies: Supplies

    @property
    def arguments(self) -> tuple[bytes, list[dict[str, Any]], Supplies]:
        """What the functions of ``rendering`` take."""
        return self.content, self.recipe.to_list(), self.supplies


def read_recipe(edit: Edit) -> Recipe:
    """The recipe of a request.

    Raises:
        InvalidError: naming the step and the parameter at fault, or the unknown preset.
    """
    from app.services.rendering import recipe_fault
    from motion.errors import RecipeError
    from motion.recipe import PRESETS, Recipe
    from motion.recipe.parameters import offer, shown

    if edit.preset is None:
        try:
            return Recipe.parse(edit.operations)
        except RecipeError as error:
            raise recipe_fault(error) from error
    if edit.preset not in PRESETS:
        raise InvalidError(
            f"There is no preset {shown(edit.preset)}.",
            code="preset_unknown",
            where={"field": "preset"},
            mend=offer(edit.preset, tuple(PRESETS)),
        )
    return PRESETS[edit.preset].operations


def create(
    database: Database, writer: Writer, workers: Workers, request: ClipRequest
) -> tuple[ClipDetail, bool]:
    """The edited clip, and whether it is new.

    Raises:
        InvalidError: the recipe is wrong, or cannot be done to this clip.
        NotFoundError: there is no such source.
    """
    recipe = read_recipe(request)
    with database.reading() as db:
        source = source_clip(db, request.source)
        known = clips.by_id(db, edited_id(source.id, recipe))
        if known is not None:
            return library.described(db, known), False
        work = _work(db, source, recipe)
    name = request.name or name_for(work.source, request, recipe)
    files = _rendered(workers, work)

    def keep(db: Session) -> tuple[ClipDetail, bool]:
        source_clip(db, work.source.id)  # it may have been deleted meanwhile
        made = _record(db, files, work.source, recipe, name, request.tags)
        is_new = clips.add(db, made)
        return library.detail(db, made.id, signed_in=True), is_new

    return writer.write(keep)


def preview(database: Database, workers: Workers, edit: Edit) -> tuple[str, bytes]:
    """The recipe's hash, and the edited clip as GLB; nothing is stored."""
    from app.services import rendering

    work = _read_work(database, edit)
    glb = workers.run(work.source.id, rendering.preview, *work.arguments)
    return work.recipe.hash, glb


def check(database: Database, workers: Workers, edit: Edit) -> Checked:
    """What the edit would break, and when its feet would stand."""
    from app.services import rendering

    work = _read_work(database, edit)
    found = workers.run(work.source.id, rendering.check, *work.arguments)
    return Checked.model_validate({"recipe_hash": work.recipe.hash, **found})


def ease_off(database: Database, workers: Workers, edit: Edit) -> EasedOff:
    """The recipe lowered until it breaks nothing."""
    from app.services import rendering

    work = _read_work(database, edit)
    found = workers.run(work.source.id, rendering.eased, *work.arguments)
    return EasedOff.model_validate(found)


def quality(database: Database, writer: Writer, workers: Workers, clip_id: str) -> Checked:
    """What the edit of a kept clip broke; the report stays with the clip."""
    from app.services import rendering

    with database.reading() as db:
        work = _kept_work(db, clip_id)
    found = workers.run(work.source.id, rendering.check, *work.arguments)

    def keep(db: Session) -> None:
        clip = clips.by_id(db, clip_id)
        if clip is not None:
            clip.quality = found["report"]

    writer.write(keep)
    return Checked.model_validate({"recipe_hash": work.recipe.hash, **found})


def rebuild(database: Database, writer: Writer, workers: Workers, clip_id: str) -> Rebuilt:
    """Make a kept clip again and compare; under a newer engine the new clip stands beside it."""
    with database.reading() as db:
        old = library.find(db, clip_id, signed_in=True)
        work = _kept_work(db, clip_id)
    files = _rendered(workers, work)

    def keep(db: Session) -> ClipDetail:
        source = library.find(db, work.source.id, signed_in=True)  # both may be deleted by now
        new = store(db, files, source, work.recipe, old.name, old.tags)
        return library.detail(db, new.id, signed_in=True)

    return Rebuilt(identical=files.id == old.content_hash, clip=writer.write(keep))


def materials(db: Session, recipe: Recipe) -> Supplies:
    """The poses and clips that a recipe refers to, as far as they are there.

    One that is missing is told by the recipe itself, which knows the step.
    """
    from app.services.rendering import Supplies

    return Supplies(
        {pose.id: pose.rotations for pose in poses.by_ids(db, recipe.poses)},
        clips.contents(db, recipe.clips),
    )


def store(
    db: Session,
    files: ClipFiles,
    source: ClipRecord,
    recipe: Recipe,
    name: str,
    tags: Mapping[str, str],
) -> ClipRecord:
    """Keep an edited clip, unless it is there already; the caller commits."""
    made = _record(db, files, source, recipe, name, tags)
    return made if clips.add(db, made) else clips.by_id(db, made.id) or made


def edited_id(source_id: str, recipe: Recipe) -> str:
    """The id of an edited clip: the hash of what it is made of."""
    made_of = {
        "engine": engine_version(),
        "operations": recipe.to_list(),
        "source": source_id,
    }
    text = json.dumps(made_of, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()


def source_clip(db: Session, clip_id: str) -> ClipRecord:
    """A clip to be edited; one that may still be read differently is none.

    Raises:
        ConflictError: it waits to be confirmed.
        NotFoundError: there is no such clip.
    """
    clip = library.find(db, clip_id, signed_in=True)
    if clip.state == "to_confirm":
        raise ConflictError(
            f"The clip {clip.name} waits to be confirmed.",
            code="clip_to_confirm",
            mend="Look through its import report in the library and keep it.",
        )
    return clip


def name_for(source: ClipRecord, request: ClipRequest, recipe: Recipe) -> str:
    """What an edited clip is called unless somebody names it."""
    ending = request.preset or f"edited_{recipe.hash[:6]}"
    return f"{source.name[:150]}_{ending}"


def _rendered(workers: Workers, work: Work) -> ClipFiles:
    from app.services import rendering

    return workers.run(work.source.id, rendering.render, *work.arguments, work.source.stature)


def _read_work(database: Database, edit: Edit) -> Work:
    recipe = read_recipe(edit)
    with database.reading() as db:
        return _work(db, source_clip(db, edit.source), recipe)


def _kept_work(db: Session, clip_id: str) -> Work:
    clip = library.find(db, clip_id, signed_in=True)
    if clip.recipe is None or clip.recipe_source is None:
        raise ConflictError(
            f"The clip {clip.name} was not made by a recipe.",
            code="not_edited",
            mend="Choose one that was edited here.",
        )
    recipe = read_recipe(Edit(source=clip.recipe_source, operations=clip.recipe))
    return _work(db, library.find(db, clip.recipe_source, signed_in=True), recipe)


def _work(db: Session, source: ClipRecord, recipe: Recipe) -> Work:
    return Work(recipe, source, library.content(db, source), materials(db, recipe))


def _record(
    db: Session,
    files: ClipFiles,
    source: ClipRecord,
    recipe: Recipe,
    name: str,
    tags: Mapping[str, str],
) -> ClipRecord:
    made = library.record(db, files, name=name, source="edited", state="kept", tags=dict(tags))
    made.id = edited_id(source.id, recipe)
    made.recipe = recipe.to_list()
    made.recipe_source = source.id
    made.recipe_hash = recipe.hash
    return made
