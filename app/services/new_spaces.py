"""New authoring spaces: clips become examples, and what is defined is kept under its hash.

What is computed from clips is computed in a process of ``app.workers`` (``space_making``).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from sqlalchemy.orm import Session

from app.errors import InvalidError
from app.persistence import clips
from app.persistence import spaces as store
from app.persistence.engine import Database
from app.persistence.models import ClipRecord, SpaceRecord
from app.persistence.writer import Writer
from app.schemas.spaces import (
    Keytimes,
    NewSpace,
    Origin,
    Sliders,
    SpaceDefinition,
    SpaceDetail,
    SpaceLine,
)
from app.services import edits, spaces
from app.workers import Workers

if TYPE_CHECKING:  # it brings SciPy, for which the server's start shall not wait
    from app.services.space_clips import Source


def create(
    database: Database, writer: Writer, workers: Workers, request: NewSpace, made_by: int
) -> SpaceDetail:
    """A space of clips that nobody judged; its sliders are motion features.

    Raises:
        ConflictError: a clip waits to be confirmed.
        InvalidError: the clips cannot be blended with each other.
        NotFoundError: there is no such clip.
    """
    defined = define(database, workers, request.name, request.clips, keytimes=request.keytimes)
    made = writer.write(lambda db: keep(db, defined, study_id=None, made_by=made_by))
    return spaces.detail(database, made.id)


def define(
    database: Database,
    workers: Workers,
    name: str,
    clip_ids: Sequence[str],
    adjectives: Sliders | None = None,
    origin: Origin | None = None,
    keytimes: Mapping[str, Keytimes] | None = None,
) -> SpaceDefinition:
    """The definition of a space of clips, for ``keep``; nothing is stored.

    Args:
        database: where the clips are.
        workers: compute keytimes and features.
        name: the space is the next version of this name.
        clip_ids: the examples in their order.
        adjectives: their places by what people said, in that order; None if nobody did.
        origin: where those come from.
        keytimes: clip id to events, where they are not to be found automatically.

    Raises:
        ConflictError: a clip waits to be confirmed.
        InvalidError: the clips cannot be blended with each other.
        NotFoundError: there is no such clip.
    """
    from app.services import space_making

    given = keytimes or {}
    check_once(clip_ids)
    check_keytimes(given, clip_ids)
    with database.reading() as db:
        gathered = sources(db, clip_ids, given)
    return workers.run(
        gathered[0].id, space_making.define, name, gathered, given, adjectives, origin
    )


def keep(
    db: Session, defined: SpaceDefinition, *, study_id: int | None, made_by: int | None
) -> SpaceLine:
    """Store a space unless it is there; the caller commits."""
    for example in defined.examples:
        edits.source_clip(db, example.clip)  # it may have been deleted meanwhile
    space_id = defined.content_hash
    if not store.exists(db, space_id):
        record = SpaceRecord(
            id=space_id,
            name=defined.title,
            definition=defined.model_dump(mode="json"),
            study_id=study_id,
            made_by=made_by,
        )
        store.add(db, record)
    return spaces.line(db, space_id)


def sources(
    db: Session, clip_ids: Sequence[str], keytimes: Mapping[str, Keytimes] | None = None
) -> list[Source]:
    """The clips that become examples.

    Raises:
        ConflictError: one waits to be confirmed.
        InvalidError: a keytime lies outside of its clip.
        NotFoundError: there is no such clip.
    """
    from app.services.space_clips import Source

    records = [edits.source_clip(db, clip_id) for clip_id in clip_ids]
    for record in records:
        _check_times(record, (keytimes or {}).get(record.id, {}))
    contents = clips.contents(db, clip_ids)
    return [Source(record.id, record.name, contents[record.id]) for record in records]


def check_once(clip_ids: Sequence[str]) -> None:
    """Refuses a clip that is there twice.

    Raises:
        InvalidError: naming its place.
    """
    for place, clip_id in enumerate(clip_ids):
        if clip_id in clip_ids[:place]:
            raise InvalidError(
                "A clip is there twice.",
                code="clip_twice",
                where={"field": "clips", "place": place + 1},
                mend="Give each clip once.",
            )


def check_keytimes(keytimes: Mapping[str, Keytimes], clip_ids: Sequence[str]) -> None:
    """Refuses keytimes of clips that are not examples.

    Raises:
        InvalidError: naming the clip.
    """
    for clip_id in keytimes:
        if clip_id not in clip_ids:
            raise InvalidError(
                f"Keytimes are given for {clip_id[:12]}…, which is no clip of the space.",
                code="keytimes_unknown",
                where={"field": "keytimes", "clip": clip_id},
                mend="Give keytimes of the space's own clips only.",
            )


def _check_times(clip: ClipRecord, moments: Keytimes) -> None:
    late = [event for event, time in moments.items() if time >= clip.duration]
    if late:
        raise InvalidError(
            f"The keytime {late[0]} of “{clip.name}” lies beyond its {clip.duration:.3f} s.",
            code="keytime_outside",
            where={"field": "keytimes", "clip": clip.id, "event": late[0]},
            mend="Give seconds from the clip's first frame, less than its duration.",
        )
