"""The audit trail: rows are added and read.

Nothing in them is changed, but for what researchers wrote about a person whose data are deleted.
"""

from __future__ import annotations

import uuid
from datetime import datetime
from typing import Any, NamedTuple

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.persistence.models import AuditEntry, Researcher


class AuditRow(NamedTuple):
    """One entry with the name of who did it."""

    id: int
    at: datetime
    researcher: str | None
    act: str
    detail: dict[str, Any]
    session_id: uuid.UUID | None


def add(db: Session, entry: AuditEntry) -> None:
    """Add an entry."""
    db.add(entry)
    db.flush()


def newest(db: Session, study_id: int) -> AuditEntry | None:
    """What was done last."""
    return db.scalar(
        select(AuditEntry)
        .where(AuditEntry.study_id == study_id)
        .order_by(AuditEntry.id.desc())
        .limit(1)
    )


def listed(
    db: Session,
    study_id: int,
    *,
    before: int | None = None,
    limit: int,
    session_id: uuid.UUID | None = None,
) -> list[AuditRow]:
    """Entries of a study, the newest first; those about one session, if one is given."""
    query = (
        select(
            AuditEntry.id, AuditEntry.at, Researcher.name,
            AuditEntry.act, AuditEntry.detail, AuditEntry.session_id,
        )
        .outerjoin(Researcher, Researcher.id == AuditEntry.researcher_id)
        .where(AuditEntry.study_id == study_id)
        .order_by(AuditEntry.id.desc())
        .limit(limit)
    )  # fmt: skip
    if before is not None:
        query = query.where(AuditEntry.id < before)
    if session_id is not None:
        query = query.where(AuditEntry.session_id == session_id)
    return [AuditRow(*row) for row in db.execute(query)]


def forget_reasons(db: Session, session_id: uuid.UUID) -> None:
    """Empty what researchers wrote about a participant; that they did something stays."""
    for entry in db.scalars(select(AuditEntry).where(AuditEntry.session_id == session_id)):
        if entry.detail.get("reason"):
            entry.detail = {**entry.detail, "reason": "…"}
    db.flush()
