"""The library's clips and the figures of their skeletons."""

from __future__ import annotations

from collections.abc import Iterable

from sqlalchemy import Text, case, cast, func, or_, select, update
from sqlalchemy.orm import Session

from app.persistence import blobs
from app.persistence.models import (
    Blob,
    ClipRecord,
    FigureRecord,
    GraphRecord,
    Response,
    Study,
    StudySession,
    StudyVersion,
    now,
)

# A set may be of thousands, so what it was made from stands before it.
_SHELVES = {"imported": 0, "sample": 1, "edited": 2}


def listed(db: Session, *, imported: bool) -> list[tuple[ClipRecord, str | None]]:
    """The library in its order, each clip with its figure's hash, in one query."""
    query = (
        select(ClipRecord, FigureRecord.glb_blob)
        .outerjoin(FigureRecord, FigureRecord.skeleton_hash == ClipRecord.skeleton_hash)
        .where(ClipRecord.state != "retired")
        .order_by(case(_SHELVES, value=ClipRecord.source), ClipRecord.name, ClipRecord.id)
    )
    if not imported:
        query = query.where(ClipRecord.source == "sample")
    return [(clip, figure) for clip, figure in db.execute(query)]


def by_id(db: Session, clip_id: str) -> ClipRecord | None:
    """The clip with this content hash."""
    return db.get(ClipRecord, clip_id)


def named(db: Session, references: Iterable[str]) -> list[ClipRecord]:
    """The clips that have one of these as their id, or are in the library under it as a name."""
    wanted = list(references)
    by_name = ClipRecord.name.in_(wanted) & (ClipRecord.state != "retired")
    query = select(ClipRecord).where(or_(ClipRecord.id.in_(wanted), by_name))
    return list(db.scalars(query.order_by(ClipRecord.name, ClipRecord.id)))


def names(db: Session) -> list[str]:
    """What the library's clips are called."""
    query = select(ClipRecord.name).where(ClipRecord.state != "retired").distinct()
    return list(db.scalars(query.order_by(ClipRecord.name)))


def by_source(db: Session, source_hash: str) -> ClipRecord | None:
    """The imported clip that was read from the file with this hash."""
    return db.scalar(
        select(ClipRecord).where(ClipRecord.source_blob == source_hash).order_by(ClipRecord.state)
    )


def put(db: Session, clip: ClipRecord) -> ClipRecord:
    """Store a clip, in the place of the one with the same content."""
    old = by_id(db, clip.id)
    replaced = _files(old) if old else set()
    stored = db.merge(clip)
    blobs.delete_orphans(db, replaced - _files(stored))
    return stored


def add(db: Session, clip: ClipRecord) -> bool:
    """Store a clip unless one with its id is there; whether it was stored."""
    given = {c.key: getattr(clip, c.key) for c in ClipRecord.__mapper__.column_attrs}
    given["created_at"] = clip.created_at or now()
    is_new = blobs.insert_if_new(db, ClipRecord, given)
    if not is_new:
        blobs.delete_orphans(db, _files(clip))
    return is_new


def contents(db: Session, ids: Iterable[str]) -> dict[str, bytes]:
    """Id to bytes of those of the named clips that are there."""
    wanted = list(ids)
    if not wanted:
        return {}
    query = select(ClipRecord.id, Blob.content).join(Blob, Blob.hash == ClipRecord.clip_blob)
    return {row.id: row.content for row in db.execute(query.where(ClipRecord.id.in_(wanted)))}


def present(db: Session, ids: Iterable[str]) -> set[str]:
    """Those of the ids under which there is a clip."""
    return set(db.scalars(select(ClipRecord.id).where(ClipRecord.id.in_(list(ids)))))


def made_from(db: Session, clip_id: str) -> int:
    """How many clips were made from this one, as their source or as an example in a recipe."""
    uses = or_(ClipRecord.recipe_source == clip_id, cast(ClipRecord.recipe, Text).contains(clip_id))
    return db.scalar(select(func.count()).select_from(ClipRecord).where(uses)) or 0


def lock(db: Session, clip_id: str) -> None:
    """Let nobody begin to refer to the clip until we are done; SQLite lets nobody write anyway."""
    db.execute(select(ClipRecord.id).where(ClipRecord.id == clip_id).with_for_update())


def is_in_graph(db: Session, clip_id: str) -> bool:
    """Whether a motion graph plays the clip."""
    query = select(GraphRecord.id).where(cast(GraphRecord.definition, Text).contains(clip_id))
    return db.scalar(query.limit(1)) is not None


def imported_by_others(db: Session, engine_version: str) -> list[str]:
    """The imported clips whose files another version of the engine has made."""
    query = select(ClipRecord.id).where(
        ClipRecord.source == "imported", ClipRecord.engine_version != engine_version
    )
    return list(db.scalars(query.order_by(ClipRecord.name)))


def renew(db: Session, clip_id: str, glb: bytes, poster_time: float, engine_version: str) -> None:
    """Put newer files in the place of a clip's older ones; a clip deleted meanwhile stays so."""
    clip = by_id(db, clip_id)
    if clip is None:
        return
    replaced = _files(clip)
    clip.glb_blob = blobs.put(db, glb, blobs.GLB)
    clip.poster_time = poster_time
    clip.engine_version = engine_version
    blobs.delete_orphans(db, replaced - _files(clip))


def delete(db: Session, clip: ClipRecord) -> None:
    """Delete a clip and the files that nothing else needs."""
    db.delete(clip)
    blobs.delete_orphans(db, _files(clip))


def is_in_use(db: Session, clip_id: str) -> bool:
    """Whether a study shows the clip, a participant will see it or somebody has answered it."""
    uses = (
        select(Response.id).where(Response.clip_id == clip_id),
        select(StudyVersion.id).where(cast(StudyVersion.definition, Text).contains(clip_id)),
        select(Study.id).where(cast(Study.draft, Text).contains(clip_id)),
        select(StudySession.id).where(cast(StudySession.plan, Text).contains(clip_id)),
    )
    return bool(db.scalar(select(or_(*(query.exists() for query in uses)))))


def figure(db: Session, skeleton_hash: str) -> FigureRecord | None:
    """The figure of a skeleton, if it was made."""
    return db.get(FigureRecord, skeleton_hash)


def put_figure(db: Session, skeleton_hash: str, glb: bytes, engine_version: str) -> None:
    """Store a skeleton's figure in the place of an older one."""
    digest = blobs.put(db, glb, blobs.GLB)
    old = figure(db, skeleton_hash)
    replaced = {old.glb_blob} if old and old.glb_blob != digest else set()
    db.merge(
        FigureRecord(skeleton_hash=skeleton_hash, glb_blob=digest, engine_version=engine_version)
    )
    blobs.delete_orphans(db, replaced)


def has_samples_of(db: Session, engine_version: str) -> bool:
    """Whether this engine has made the sample library; it is stored whole or not at all."""
    query = select(ClipRecord.id).where(
        ClipRecord.source == "sample",
        ClipRecord.state == "kept",
        ClipRecord.engine_version == engine_version,
    )
    return db.scalar(query.limit(1)) is not None


def retire_samples(db: Session) -> None:
    """Take all samples out of the library; answers may still refer to them."""
    db.execute(update(ClipRecord).where(ClipRecord.source == "sample").values(state="retired"))


def _files(clip: ClipRecord) -> set[str]:
    return {clip.clip_blob, clip.glb_blob, *filter(None, [clip.source_blob])}
