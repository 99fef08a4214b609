"""Authoring spaces."""

from __future__ import annotations

from typing import NamedTuple

from sqlalchemy import Select, Text, cast, func, select
from sqlalchemy.orm import Session

from app.persistence.models import Researcher, SpaceRecord, Study


class Space(NamedTuple):
    """A space with what its row refers to.

    Attributes:
        newest: the number of the newest space of its name.
        study, study_title: address and title of the study that it was made of.
        made_by: a researcher's name.
    """

    record: SpaceRecord
    newest: int
    study: str | None
    study_title: str | None
    made_by: str | None


def listed(db: Session) -> list[Space]:
    """All spaces, newest first."""
    order = (SpaceRecord.created_at.desc(), SpaceRecord.name, SpaceRecord.number.desc())
    return [Space._make(row) for row in db.execute(_spaces().order_by(*order))]


def by_id(db: Session, space_id: str) -> Space | None:
    """The space with this hash."""
    row = db.execute(_spaces().where(SpaceRecord.id == space_id)).first()
    return Space._make(row) if row else None


def exists(db: Session, space_id: str) -> bool:
    """Whether there is a space with this hash."""
    return db.scalar(select(SpaceRecord.id).where(SpaceRecord.id == space_id)) is not None


def versions(db: Session, name: str) -> list[Space]:
    """Every space of a name, the newest first."""
    query = _spaces().where(SpaceRecord.name == name).order_by(SpaceRecord.number.desc())
    return [Space._make(row) for row in db.execute(query)]


def newest_named(db: Session, name: str) -> Space | None:
    """The newest space of a name."""
    return next(iter(versions(db, name)), None)


def add(db: Session, record: SpaceRecord) -> None:
    """Store a new space as the next one of its name."""
    query = select(func.max(SpaceRecord.number)).where(SpaceRecord.name == record.name)
    record.number = (db.scalar(query) or 0) + 1
    db.add(record)
    db.flush()


def delete(db: Session, record: SpaceRecord) -> None:
    """Delete a space; its clips stay."""
    db.delete(record)
    db.flush()


def is_named(db: Session, name: str) -> bool:
    """Whether there is a space of this name."""
    return db.scalar(select(SpaceRecord.id).where(SpaceRecord.name == name).limit(1)) is not None


def blending(db: Session, clip_id: str) -> list[SpaceRecord]:
    """The spaces that have the clip as an example."""
    query = select(SpaceRecord).where(cast(SpaceRecord.definition, Text).contains(clip_id))
    return list(db.scalars(query.order_by(SpaceRecord.name, SpaceRecord.number)))


def _spaces() -> Select[tuple[SpaceRecord, int, str | None, str | None, str | None]]:
    other = select(SpaceRecord.name, func.max(SpaceRecord.number).label("newest"))
    newest = other.group_by(SpaceRecord.name).subquery()
    return (
        select(SpaceRecord, newest.c.newest, Study.slug, Study.title, Researcher.name)
        .join(newest, newest.c.name == SpaceRecord.name)
        .outerjoin(Study, Study.id == SpaceRecord.study_id)
        .outerjoin(Researcher, Researcher.id == SpaceRecord.made_by)
    )
