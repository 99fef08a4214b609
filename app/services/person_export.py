"""All that is stored of one participant, as one JSON document: to hand out to the person."""

from __future__ import annotations

from typing import Any
from uuid import UUID

from sqlalchemy import inspect
from sqlalchemy.orm import Session

from app.persistence import live as store
from app.persistence.models import StudySession
from app.services import audit
from app.services.live import session_name
from app.services.replay import find, no_such_session
from app.services.rights import Access
from app.services.studies import definition_of

# What says nothing about the person, or would open the session to whoever reads it.
LEFT_OUT = {"token_hash", "study_id", "version_id", "id", "fingerprint", "session_id"}


def export(db: Session, access: Access, session_id: UUID) -> dict[str, Any]:
    """Everything of one person: the session, the consent, every revision of every answer.

    Raises:
        NotFoundError: no such participant, or the data are deleted.
    """
    session = find(db, access, session_id)
    if session.state == "withdrawn":
        raise no_such_session()
    found = _document(db, access, session)
    audit.note(
        db, access.study_id, "session_exported", access.researcher_id, session.id,
        name=session_name(session.id),
    )  # fmt: skip
    db.commit()
    return found


def _document(db: Session, access: Access, session: StudySession) -> dict[str, Any]:
    definition = definition_of(session.version)
    trail = audit.trail(db, access.study_id, session_id=session.id)
    return {
        "format": "manner-person-1",
        "study": {
            "address": access.slug,
            "title": str(definition.title),
            "version": session.version.number,
            "hash": session.version.definition_hash,
        },
        "participant": {"id": str(session.id), **_columns(session)},
        "agreed_to": definition.consent.model_dump(mode="json"),
        "answers": [_columns(row) for row in store.answers_of(db, session.id)],
        "done_by_researchers": [
            {"at": entry.at.isoformat(), "by": entry.who, "what": entry.sentence}
            for entry in trail.entries
        ],
    }


def _columns(row: object) -> dict[str, Any]:
    names = [column.key for column in inspect(type(row)).column_attrs]
    return {name: getattr(row, name) for name in names if name not in LEFT_OUT}
