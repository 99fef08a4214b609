"""Authoring spaces: made of clips, kept for ever, made anew as the next version.

A space is known by the hash of its definition. What is computed from clips is computed in a
process of ``app.workers`` (``space_making``); points of a space become motion in ``space_motion``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from sqlalchemy.orm import Session

from app.errors import InvalidError, NotFoundError
from app.persistence import clips, graphs, spaces
from app.persistence.engine import Database
from app.persistence.models import ClipRecord, SpaceRecord
from app.persistence.writer import Writer
from app.schemas.spaces import (
    ExampleClip,
    Keytimes,
    KeytimesView,
    NewSpace,
    Origin,
    Point,
    Sliders,
    SpaceDefinition,
    SpaceDetail,
    SpaceLine,
    SpaceList,
    SpaceRecipe,
    TargetList,
    TargetRequest,
    Weighed,
)
from app.schemas.study import Interface
from app.services import edits, library
from app.services.studies import media_url
from app.workers import Workers

if TYPE_CHECKING:  # they bring SciPy, for which the server's start shall not wait
    from app.services.space_making import Source
    from app.services.space_motion import Prepared

# Of the sample walks by set, as `space_samples` makes them.
SAMPLES = {
    "set_a": "Walks of set A (simulated raters)",
    "set_b": "Walks of set B (simulated raters)",
}


def has_samples(db: Session) -> bool:
    """Whether the sample spaces were made."""
    return all(spaces.is_named(db, name) for name in SAMPLES.values())


def listed(db: Session) -> SpaceList:
    """All spaces, newest first."""
    return SpaceList(spaces=[_line(space) for space in spaces.listed(db)])


def line(db: Session, space_id: str) -> SpaceLine:
    """One space as the list shows it."""
    return _line(_found(db, space_id))


def definition(db: Session, space_id: str) -> SpaceDefinition:
    """A space as it was frozen.

    Raises:
        NotFoundError: there is no such space.
    """
    return SpaceDefinition.model_validate(_found(db, space_id).record.definition)


def study_of(db: Session, space_id: str) -> int | None:
    """The study that a space was made of."""
    return _found(db, space_id).record.study_id


def detail(database: Database, space_id: str) -> SpaceDetail:
    """A space with its numbers and its clips' files."""
    ready = _prepared(database, space_id)
    with database.reading() as db:
        known = line(db, space_id)
        members = graphs.members(db, [example.clip for example in ready.definition.examples])
    return SpaceDetail(
        **known.model_dump(),
        definition=ready.definition,
        clips=[_example_clip(*members[example.clip]) for example in ready.definition.examples],
        notes={interface: ready.notes(interface) for interface in known.interfaces},
    )


def weights(database: Database, space_id: str, point: Point) -> Weighed:
    """What a point means."""
    return _prepared(database, space_id).weights(point)


def motion(database: Database, space_id: str, point: Point) -> tuple[Weighed, bytes]:
    """What a point means, and its motion as GLB without a figure. Nothing is stored."""
    ready = _prepared(database, space_id)
    weighed = ready.weights(point)
    return weighed, ready.glb(weighed.weights)


def recipe(database: Database, space_id: str, point: Point) -> SpaceRecipe:
    """A point as an ordinary recipe."""
    return _prepared(database, space_id).recipe(point)


def targets(
    database: Database, workers: Workers, space_id: str, request: TargetRequest
) -> TargetList:
    """Motions to be matched, drawn by seed.

    Raises:
        InvalidError: the space has no adjectives.
    """
    from app.services import space_targets

    with database.reading() as db:
        known = definition(db, space_id)
        contents = clips.contents(db, [example.clip for example in known.examples])
    return workers.run(space_id, space_targets.draw, known, contents, request)


def keytimes(database: Database, workers: Workers, clip_id: str) -> KeytimesView:
    """The events found in a clip."""
    from app.services import space_making

    with database.reading() as db:
        stored = library.content(db, library.find(db, clip_id, signed_in=True))
    return KeytimesView(keytimes=workers.run(clip_id, space_making.found_keytimes, stored))


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
    return detail(database, made.id)


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
    if spaces.by_id(db, space_id) is None:
        record = SpaceRecord(
            id=space_id,
            name=defined.title,
            definition=defined.model_dump(mode="json"),
            study_id=study_id,
            made_by=made_by,
        )
        spaces.add(db, record)
    return line(db, space_id)


def sources(
    db: Session, clip_ids: Sequence[str], keytimes: Mapping[str, Keytimes] | None = None
) -> list[Source]:
    """The clips that become examples.

    Raises:
        ConflictError: one waits to be confirmed.
        InvalidError: a keytime lies outside of its clip.
        NotFoundError: there is no such clip.
    """
    from app.services.space_making import Source

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


def _prepared(database: Database, space_id: str) -> Prepared:
    from app.services import space_motion

    return space_motion.prepared(database, space_id)


def _found(db: Session, space_id: str) -> spaces.Space:
    found = spaces.by_id(db, space_id)
    if found is None:
        raise NotFoundError(
            "There is no such space.", code="space_not_found", mend="Look for it under Spaces."
        )
    return found


def _line(space: spaces.Space) -> SpaceLine:
    record = space.record
    interfaces: list[Interface] = ["features", "weights"]
    if record.definition["adjectives"]:
        interfaces.insert(0, "adjectives")
    return SpaceLine(
        id=record.id,
        name=record.name,
        number=record.number,
        newest=record.number == space.newest,
        examples=len(record.definition["examples"]),
        interfaces=interfaces,
        simulated=record.definition["origin"]["kind"] == "simulated",
        study=space.study,
        made_by=space.made_by,
        created_at=record.created_at,
    )


def _example_clip(clip: ClipRecord, figure: str | None) -> ExampleClip:
    return ExampleClip(
        clip=clip.id,
        name=clip.name,
        glb_url=media_url(clip.glb_blob),
        figure_url=figure and media_url(figure),
        duration=clip.duration,
    )
