"""Answers. Rows are added, and deleted only by their participant's withdrawal; never changed."""

from __future__ import annotations

import uuid
from collections.abc import Iterator
from datetime import datetime
from typing import Any, NamedTuple

from sqlalchemy import ColumnElement, Row, and_, bindparam, delete, func, insert, select
from sqlalchemy.orm import Session, aliased

from app.persistence.models import Response, Study, StudySession


class Asked(NamedTuple):
    """A session as far as one answer needs it; `stored` is the answer that is there already."""

    session_id: uuid.UUID
    state: str
    plan: dict[str, Any] | None
    study_id: int
    definition_hash: str
    stored: Stored | None


class Stored(NamedTuple):
    """What is stored of one revision of one answer."""

    fingerprint: str
    answers: dict[str, int]
    comment: str
    received_at: datetime
    record: dict[str, Any]


# Tables instead of classes, made once: answers come by the hundred in a second, and building
# statements and objects anew for each would take most of that second.
_SESSIONS, _RESPONSES, _STUDIES = (model.__table__.c for model in (StudySession, Response, Study))
_ASKED = (
    select(
        _SESSIONS.id, _SESSIONS.state, _SESSIONS.plan, _SESSIONS.study_id,
        _STUDIES.definition_hash, _RESPONSES.fingerprint, _RESPONSES.answers,
        _RESPONSES.comment, _RESPONSES.received_at, _RESPONSES.record,
    )
    .join_from(StudySession.__table__, Study.__table__)
    .outerjoin(
        Response.__table__,
        and_(
            _RESPONSES.session_id == _SESSIONS.id,
            _RESPONSES.trial_index == bindparam("trial_index"),
            _RESPONSES.revision == bindparam("revision"),
        ),
    )
    .where(_SESSIONS.token_hash == bindparam("token_hash"))
    # So that no other server process completes or empties the session meanwhile; SQLite has one
    # writer at a time anyway and leaves this out.
    .with_for_update(of=StudySession.__table__)
)  # fmt: skip
_ADD = insert(Response)


def asked(session: Session, token_hash: str, trial_index: int, revision: int) -> Asked | None:
    """All that storing one answer must know, in one query; locks the session's row."""
    sought = {"token_hash": token_hash, "trial_index": trial_index, "revision": revision}
    row = session.connection().execute(_ASKED, sought).one_or_none()
    if row is None:
        return None
    return Asked(*row[:5], Stored._make(row[5:]) if row.fingerprint else None)


def add(session: Session, **row: Any) -> None:  # noqa: ANN401 -- the columns of Response
    """Add one answer."""
    session.connection().execute(_ADD, row)


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
