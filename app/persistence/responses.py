"""Answers. Rows are added, and deleted only by their participant's withdrawal; never changed."""

from __future__ import annotations

import uuid
from collections.abc import Iterable, Iterator
from datetime import datetime
from typing import Any, NamedTuple

from sqlalchemy import ColumnElement, Row, and_, bindparam, delete, func, insert, null, select
from sqlalchemy.orm import Session, aliased, defer

from app.persistence import live
from app.persistence.models import (
    ClipRecord,
    Response,
    Study,
    StudySession,
    StudyVersion,
)


class Asked(NamedTuple):
    """A session as far as one answer needs it; `stored` is the answer that is there already."""

    session_id: uuid.UUID
    state: str
    plan: dict[str, Any] | None
    study_id: int
    version_id: int
    definition_hash: str
    stored: Stored | None


class Stored(NamedTuple):
    """What is stored of one revision of one answer."""

    fingerprint: str
    answers: dict[str, Any]
    comment: str
    received_at: datetime
    record: dict[str, Any]


# Tables instead of classes, made once: answers come by the hundred in a second, and building
# statements and objects anew for each would take most of that second.
_SESSIONS, _RESPONSES, _VERSIONS = (
    model.__table__.c for model in (StudySession, Response, StudyVersion)
)
_ASKED = (
    select(
        _SESSIONS.id, _SESSIONS.state, _SESSIONS.plan, _SESSIONS.study_id,
        _SESSIONS.version_id, _VERSIONS.definition_hash, _RESPONSES.fingerprint,
        _RESPONSES.answers,
        _RESPONSES.comment, _RESPONSES.received_at, _RESPONSES.record,
    )
    .join_from(
        StudySession.__table__,
        StudyVersion.__table__,
        _SESSIONS.version_id == _VERSIONS.id,
    )
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
    return Asked(*row[:6], Stored._make(row[6:]) if row.fingerprint else None)


def add(session: Session, **row: Any) -> None:  # noqa: ANN401 -- the columns of Response
    """Add one answer."""
    session.connection().execute(_ADD, row)


def newest(session: Session, session_id: uuid.UUID) -> dict[int, Response]:
    """The newest answer of each trial."""
    rows = session.scalars(
        select(Response).where(Response.session_id == session_id).order_by(Response.revision)
    )
    return {row.trial_index: row for row in rows}


def newest_of(session: Session, session_id: uuid.UUID, trial_index: int) -> dict[str, Any] | None:
    """What was answered to one trial, by its newest revision."""
    return session.scalar(
        select(Response.answers)
        .where(Response.session_id == session_id, Response.trial_index == trial_index)
        .order_by(Response.revision.desc())
        .limit(1)
    )


def failed_checks(session: Session, session_id: uuid.UUID) -> int:
    """How many attention checks of a session did not hold, each counted once."""
    found = select(func.count(Response.trial_index.distinct())).where(
        Response.session_id == session_id, Response.passed.is_(False)
    )
    return session.scalar(found) or 0


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
    live.forget(session, session_id)


def count(session: Session, study: Study, kind: str = "participant") -> int:
    """All stored rows of a study, earlier revisions and practice included."""
    found = (
        select(func.count())
        .select_from(Response)
        .join(StudySession)
        .where(StudySession.study_id == study.id, StudySession.kind == kind)
    )
    return session.scalar(found) or 0


class Counted(NamedTuple):
    """An answer that counts, as far as results need it."""

    session_id: uuid.UUID
    version_id: int
    clips: list[str]
    answers: dict[str, Any]


def analysed(session: Session, study: Study, part: str, kind: str = "participant") -> list[Counted]:
    """Every answer to a part that counts: complete, not excluded, no practice or check, newest."""
    rows = session.execute(
        select(Response.session_id, StudySession.version_id, Response.clips, Response.answers)
        .join(StudySession)
        .where(
            StudySession.study_id == study.id,
            StudySession.kind == kind,
            StudySession.state == "complete",
            StudySession.excluded.is_(null()),
            Response.part == part,
            Response.practice.is_(False),
            Response.check.is_(None),
            ~_superseded(),
        )
        .order_by(StudySession.completed_at, StudySession.id, Response.trial_index)
    )
    return [Counted(*row) for row in rows]


def stream(
    session: Session, study: Study, kind: str = "participant"
) -> Iterator[Row[Response, StudySession, bool]]:
    """Every stored answer with its session and whether a newer revision exists, row by row."""
    yield from session.execute(
        select(Response, StudySession, _superseded().label("superseded"))
        .join(StudySession, StudySession.id == Response.session_id)
        .where(StudySession.study_id == study.id, StudySession.kind == kind)
        .order_by(StudySession.created_at, StudySession.id, Response.id)
        # A plan may be as large as all its session's answers, and would be read with each of them.
        .options(defer(StudySession.plan, raiseload=True))
        .execution_options(yield_per=500)
    )


def recruited(session: Session, study: Study, kind: str = "participant") -> list[StudySession]:
    """The participants that a recruiting service sent, in no order."""
    found = session.scalars(
        select(StudySession).where(
            StudySession.study_id == study.id,
            StudySession.kind == kind,
            StudySession.external.is_not(null()),
        )
    )
    return list(found)


def engines(session: Session, clips: Iterable[str]) -> dict[str, str]:
    """The version of the engine that made each clip."""
    rows = session.execute(
        select(ClipRecord.id, ClipRecord.engine_version).where(ClipRecord.id.in_(set(clips)))
    )
    return {clip: engine for clip, engine in rows}  # noqa: C416 -- a row is no pair for mypy


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
