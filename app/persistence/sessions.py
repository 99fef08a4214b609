"""Participants' sessions."""

from __future__ import annotations

import uuid
from datetime import datetime
from typing import NamedTuple

from sqlalchemy import ColumnElement, and_, func, null, or_, select, update
from sqlalchemy.orm import Session

from app.persistence.models import Response, Study, StudySession, now


class Progress(NamedTuple):
    """How far one session is; `answered` counts steps, `last_answer` is None before the first."""

    state: str
    excluded: bool
    consented_at: datetime | None
    completed_at: datetime | None
    answered: int
    last_answer: datetime | None


def by_token_hash(session: Session, token_hash: str, *, lock: bool = False) -> StudySession | None:
    """The session of a personal link; locked, no other server process changes it meanwhile."""
    found = select(StudySession).where(StudySession.token_hash == token_hash)
    if lock:  # SQLite has one writer at a time anyway and leaves FOR UPDATE out
        found = found.with_for_update().execution_options(populate_existing=True)
    return session.scalar(found)


def end_early(session: Session, session_id: uuid.UUID, outcome: str) -> None:
    """End a session before its last step."""
    session.execute(
        update(StudySession)
        .where(StudySession.id == session_id)
        .values(state=outcome, completed_at=now())
    )


def held_slots(session: Session, version_id: int, kind: str, since: datetime) -> list[int]:
    """The slots of a version that are complete or under way, by the signs given since then."""
    rows = session.scalars(
        select(StudySession.slot).where(
            StudySession.version_id == version_id, StudySession.kind == kind, _holds(since)
        )
    )
    return [slot for slot in rows if slot is not None]


def count_held(session: Session, study_id: int, since: datetime) -> int:
    """How many participants of a study are complete or under way."""
    found = (
        select(func.count())
        .select_from(StudySession)
        .where(StudySession.study_id == study_id, StudySession.kind == "participant", _holds(since))
    )
    return session.scalar(found) or 0


def _holds(since: datetime) -> ColumnElement[bool]:
    answered = (
        select(Response.id)
        .where(Response.session_id == StudySession.id, Response.received_at >= since)
        .exists()
    )
    under_way = and_(
        StudySession.state == "active", or_(StudySession.created_at >= since, answered)
    )
    return and_(StudySession.excluded.is_(null()), or_(StudySession.state == "complete", under_way))


def progress(session: Session, study: Study, kind: str = "participant") -> list[Progress]:
    """All sessions of a study, of one kind."""
    answers = (
        select(
            Response.session_id,
            func.count(Response.trial_index.distinct()).label("answered"),
            func.max(Response.received_at).label("last_answer"),
        )
        .join(StudySession, StudySession.id == Response.session_id)
        .where(StudySession.study_id == study.id, StudySession.kind == kind)
        .group_by(Response.session_id)
        .subquery()
    )
    rows = session.execute(
        select(
            StudySession.state,
            StudySession.excluded.is_not(null()),
            StudySession.consented_at,
            StudySession.completed_at,
            func.coalesce(answers.c.answered, 0),
            answers.c.last_answer,
        )
        .outerjoin(answers, answers.c.session_id == StudySession.id)
        .where(StudySession.study_id == study.id, StudySession.kind == kind)
        .order_by(StudySession.created_at, StudySession.id)
    )
    return [Progress(*row) for row in rows]
