"""What a researcher decides about one participant: to leave out, to mark, to delete, to hand out.

Everything of it is written into the audit trail in the same transaction.
"""

from __future__ import annotations

from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.errors import ConflictError
from app.persistence import researchers
from app.persistence.models import StudySession, now
from app.services import audit
from app.services.live import session_name
from app.services.replay import find
from app.services.rights import Access
from app.services.sessions import erase


def exclude(db: Session, access: Access, session_id: UUID, reason: str) -> None:
    """Leave a participant out of results and groups, with a reason; the answers stay.

    Raises:
        NotFoundError: no such participant.
        ConflictError: they have withdrawn, so that nothing is left to leave out.
    """
    session = _there(db, access, session_id)
    session.excluded = _mark(db, access, reason)
    _note(db, access, session, "session_excluded", reason=reason)


def include(db: Session, access: Access, session_id: UUID) -> None:
    """Count a participant again."""
    session = _there(db, access, session_id)
    if session.excluded is not None:
        session.excluded = None
        _note(db, access, session, "session_included")


def flag(db: Session, access: Access, session_id: UUID, reason: str) -> None:
    """Mark a participant to be looked at; it changes nothing else."""
    session = _there(db, access, session_id)
    session.flags = _mark(db, access, reason)
    _note(db, access, session, "session_flagged", reason=reason)


def unflag(db: Session, access: Access, session_id: UUID) -> None:
    """Take the mark off."""
    session = _there(db, access, session_id)
    if session.flags is not None:
        session.flags = None
        _note(db, access, session, "session_unflagged")


def delete(db: Session, access: Access, session_id: UUID) -> None:
    """Delete a participant's answers and all that is known of them; a tombstone stays.

    Again for the same one it changes nothing.
    """
    session = find(db, access, session_id, lock=True)
    if session.state != "withdrawn":
        erase(db, session)
        _note(db, access, session, "session_deleted")


def _there(db: Session, access: Access, session_id: UUID) -> StudySession:
    session = find(db, access, session_id, lock=True)
    if session.state == "withdrawn":
        raise ConflictError(
            "This participant has withdrawn and the data are deleted.",
            code="session_withdrawn",
            mend="Nothing more to do.",
        )
    return session


def _mark(db: Session, access: Access, reason: str) -> dict[str, Any]:
    researcher = researchers.by_id(db, access.researcher_id)
    by = researcher.name if researcher else ""
    return {"reason": reason, "by": by, "at": now().isoformat()}


def _note(
    db: Session, access: Access, session: StudySession, act: str, reason: str | None = None
) -> None:
    detail: dict[str, Any] = {"name": session_name(session.id)}
    if reason is not None:
        detail["reason"] = reason
    audit.note(db, access.study_id, act, access.researcher_id, session.id, **detail)
    db.commit()
