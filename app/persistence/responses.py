"""Answers. Rows are added, and deleted only by their participant's withdrawal; never changed."""

from __future__ import annotations

import uuid
from collections.abc import Iterator

from sqlalchemy import ColumnElement, Row, delete, func, select
from sqlalchemy.orm import Session, aliased

from app.persistence.models import Response, Study, StudySession


def stored(
    session: Session, session_id: uuid.UUID, trial_index: int, revision: int
) -> Response | None:
    """One revision of one answer."""
    return session.scalar(
        select(Response).where(
            Response.session_id == session_id,
            Response.trial_index == trial_index,
            Response.revision == revision,
        )
    )


def newest(session: Session, session_id: uuid.UUID) -> dict[int, Response]:
    """The newest answer of each trial."""
    rows = session.scalars(
        select(Response).where(Response.session_id == session_id).order_by(Response.revision)
    )
    return {row.trial_index: row for row in rows}


def answered(session: Session, session_id: uuid.UUID) -> set[int]:
    """The trials that have an answer."""
    return set(
        session.scalars(
            select(Response.trial_index).where(Response.session_id == session_id).distinct()
        )
    )


def delete_all(session: Session, session_id: uuid.UUID) -> None:
    """Delete what a participant answered, by the participant's right."""
    session.execute(delete(Response).where(Response.session_id == session_id))


def count(session: Session, study: Study) -> int:
    """All stored rows of a study, earlier revisions and practice included."""
    found = (
        select(func.count())
        .select_from(Response)
        .join(StudySession)
        .where(StudySession.study_id == study.id)
    )
    return session.scalar(found) or 0


def analysed(session: Session, study: Study) -> list[tuple[uuid.UUID, str, dict[str, int]]]:
    """Session, clip and values of every answer that counts: complete, not practice, newest."""
    rows = session.execute(
        select(Response.session_id, Response.clip_id, Response.answers)
        .join(StudySession)
        .where(
            StudySession.study_id == study.id,
            StudySession.state == "complete",
            Response.practice.is_(False),
            ~_superseded(),
        )
        .order_by(StudySession.completed_at, StudySession.id, Response.trial_index)
    )
    return [(session_id, clip, answers) for session_id, clip, answers in rows]


def stream(session: Session, study: Study) -> Iterator[Row[Response, StudySession, bool]]:
    """Every stored answer with its session and whether a newer revision exists, row by row."""
    yield from session.execute(
        select(Response, StudySession, _superseded().label("superseded"))
        .join(StudySession, StudySession.id == Response.session_id)
        .where(StudySession.study_id == study.id)
        .order_by(StudySession.created_at, StudySession.id, Response.id)
        .execution_options(yield_per=500)
    )


def _superseded() -> ColumnElement[bool]:
    newer = aliased(Response)
    return (
        select(newer.id)
        .where(
            newer.session_id == Response.session_id,
            newer.trial_index == Response.trial_index,
            newer.revision > Response.revision,
        )
        .exists()
    )
