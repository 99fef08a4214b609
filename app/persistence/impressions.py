"""What researchers chose in the analysis of adjective pairs, and whose answers it rests on."""

from __future__ import annotations

from typing import Any

from sqlalchemy import null, select
from sqlalchemy.orm import Session

from app.persistence.models import ImpressionChoices, StudySession, now


def saved(db: Session, study_id: int, part: str, *, lock: bool = False) -> ImpressionChoices | None:
    """The choices for a part, if any were saved; `lock` until the end of the transaction."""
    return db.get(ImpressionChoices, (study_id, part), with_for_update=lock or None)


def save(db: Session, study_id: int, part: str, choices: dict[str, Any]) -> None:
    """Keep the choices for a part in place of earlier ones."""
    row = ImpressionChoices(study_id=study_id, part=part, choices=choices, saved_at=now())
    db.merge(row)
    db.flush()


def counted(db: Session, study_id: int, kind: str) -> tuple[str, ...]:
    """The sessions that `responses.analysed` takes answers from, in no order.

    A complete session takes no further answer and never changes its version, so that these names
    alone tell whether anything is to be counted anew.
    """
    query = select(StudySession.id).where(
        StudySession.study_id == study_id,
        StudySession.kind == kind,
        StudySession.state == "complete",
        StudySession.excluded.is_(null()),
    )
    return tuple(sorted(one.hex for one in db.scalars(query)))
