"""Participants' sessions."""

from __future__ import annotations

from datetime import datetime
from typing import NamedTuple

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.persistence.models import Response, Study, StudySession


class Progress(NamedTuple):
    """How far one session is; `answered` counts trials, `last_answer` is None before the first."""

    state: str
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


def progress(session: Session, study: Study) -> list[Progress]:
    """All sessions of a study."""
    answers = (
        select(
            Response.session_id,
            func.count(Response.trial_index.distinct()).label("answered"),
            func.max(Response.received_at).label("last_answer"),
        )
        .group_by(Response.session_id)
        .subquery()
    )
    rows = session.execute(
        select(
            StudySession.state,
            StudySession.consented_at,
            StudySession.completed_at,
            func.coalesce(answers.c.answered, 0),
            answers.c.last_answer,
        )
        .outerjoin(answers, answers.c.session_id == StudySession.id)
        .where(StudySession.study_id == study.id)
        .order_by(StudySession.created_at, StudySession.id)
    )
    return [Progress(*row) for row in rows]
