"""Poses captured from clips."""

from __future__ import annotations

from collections.abc import Iterable

from sqlalchemy import Text, cast, select
from sqlalchemy.orm import Session

from app.persistence import blobs
from app.persistence.models import ClipRecord, PoseRecord, now


def listed(db: Session) -> list[PoseRecord]:
    """All poses by name."""
    return list(db.scalars(select(PoseRecord).order_by(PoseRecord.name, PoseRecord.id)))


def by_id(db: Session, pose_id: str) -> PoseRecord | None:
    """The pose with this hash."""
    return db.get(PoseRecord, pose_id)


def by_ids(db: Session, ids: Iterable[str]) -> list[PoseRecord]:
    """Those of the named poses that are there."""
    wanted = list(ids)
    if not wanted:
        return []
    return list(db.scalars(select(PoseRecord).where(PoseRecord.id.in_(wanted))))


def put(db: Session, pose: PoseRecord) -> PoseRecord:
    """Store a pose under its hash; the same rotations again get the new name."""
    given = {c.key: getattr(pose, c.key) for c in PoseRecord.__mapper__.column_attrs}
    given["created_at"] = pose.created_at or now()
    blobs.insert_if_new(db, PoseRecord, given)  # another server may store the same at this moment
    return db.merge(pose)


def delete(db: Session, pose: PoseRecord) -> None:
    """Delete a pose."""
    db.delete(pose)


def used_by(db: Session, pose_id: str) -> int:
    """How many clips' recipes refer to the pose."""
    query = select(ClipRecord.id).where(cast(ClipRecord.recipe, Text).contains(pose_id))
    return len(db.scalars(query).all())
