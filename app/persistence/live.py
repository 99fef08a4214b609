"""What the live page counts: sessions by index, their answers by one summary a session."""

from __future__ import annotations

import uuid
from collections.abc import Iterable, Sequence
from datetime import datetime
from typing import Any, NamedTuple

from sqlalchemy import ColumnElement, Select, and_, case, delete, func, insert, or_, select, update
from sqlalchemy.orm import Session

from app.persistence.models import Response, SessionSummary, StudySession, StudyVersion

# Transactions of several servers may commit in another order than they were numbered: as many
# answers back may still turn up.
LATE = 1000


class Limits(NamedTuple):
    """From where on a session's numbers are suspicious (`app.services.suspicions`)."""

    same_run: int
    fewest: int
    fast_ms: int
    hidden_ms: int
    usual_ms: float | None


class Scope(NamedTuple):
    """Whose sessions are counted."""

    study_id: int
    kind: str


class Total(NamedTuple):
    """How many sessions of a group are in a state."""

    state: str
    group: str | None
    sessions: int


class Active(NamedTuple):
    """How many active sessions of a group are equally far; `going`: with a sign of life lately."""

    group: str | None
    going: bool
    answered: int
    sessions: int


class Seen(NamedTuple):
    """The answers of a version's sessions, complete and others apart.

    Attributes:
        clips: places of the judged clips, joined (`SessionSummary.seen`).
        answered: steps answered in all; steps: of the longest session.
    """

    version_id: int
    complete: bool
    clips: str
    answered: int
    steps: int


class Line(NamedTuple):
    """One session as the list shows it; the summary is None before the first answer."""

    id: uuid.UUID
    state: str
    group: str | None
    language: str | None
    device: str | None
    source: str | None
    began: datetime
    excluded: dict[str, Any] | None
    flags: dict[str, Any] | None
    summary: SessionSummary | None


_S, _M = StudySession, SessionSummary


def totals(db: Session, scope: Scope) -> list[Total]:
    """Counted sessions by state and group."""
    # As the index has them, so that nothing need be sorted.
    keys = (_S.state, _S.version_id, _S.group)
    rows = db.execute(select(*keys, func.count()).where(*_counted(scope)).group_by(*keys))
    return [Total(state, group, sessions) for state, _, group, sessions in rows]


def active(db: Session, scope: Scope, since: datetime) -> list[Active]:
    """Active counted sessions by group and by how far they are.

    Args:
        db: where to read.
        scope: whose sessions.
        since: `going` are those that gave a sign since then.
    """
    sign = func.coalesce(_M.last_at, _S.created_at)
    keys = (_S.group, case((sign >= since, 1), else_=0), func.coalesce(_M.answered, 0))
    query = select(*keys, func.count()).outerjoin(_M, _M.session_id == _S.id)
    rows = db.execute(query.where(*_counted(scope), _S.state == "active").group_by(*keys))
    return [Active(group, bool(going), answered, n) for group, going, answered, n in rows]


def excluded_count(db: Session, scope: Scope) -> int:
    """How many sessions a researcher has left out."""
    query = select(func.count()).select_from(_S)
    return db.scalar(query.where(*_few(scope), _S.id.in_(_left_out()))) or 0


def durations(db: Session, scope: Scope) -> list[tuple[int, int]]:
    """Whole seconds from agreeing to the last answer, and how many complete sessions took them."""
    return _histogram(db, scope, _M.seconds)


def paces(db: Session, scope: Scope) -> list[tuple[int, int]]:
    """Median time of a trial in ms, and how many complete sessions had it."""
    return _histogram(db, scope, _M.median_ms)


def seen(db: Session, scope: Scope) -> list[Seen]:
    """What the counted sessions of each version have answered."""
    keys = (_S.state, _S.version_id)
    rows = db.execute(
        select(
            *keys, func.aggregate_strings(_M.seen, ""),
            func.sum(_M.answered), func.max(_M.steps),
        )
        .join(_M, _M.session_id == _S.id)
        .where(*_counted(scope))
        .group_by(*keys)
    )  # fmt: skip
    return [
        Seen(version, state == "complete", clips, answered, steps)
        for state, version, clips, answered, steps in rows
    ]


def suspicious(
    db: Session, scope: Scope, limits: Limits, count: int
) -> tuple[int, list[uuid.UUID]]:
    """How many counted sessions break a rule, and the latest of them."""
    broken = or_(
        _M.same_run >= limits.same_run,
        and_(_M.rated >= limits.fewest, 2 * _M.flat >= _M.rated),
        and_(_M.judged >= limits.fewest, _M.median_ms < limits.fast_ms),
        _M.failed > 0,
        _M.hidden_ms > limits.hidden_ms,
    )
    total = func.count().over()
    query = select(_S.id, total).join(_M, _M.session_id == _S.id).where(*_counted(scope), broken)
    rows = db.execute(query.order_by(_S.created_at.desc(), _S.id).limit(count)).all()
    return (rows[0][1] if rows else 0), [row[0] for row in rows]


def latest(db: Session, scope: Scope, count: int, offset: int = 0) -> list[uuid.UUID]:
    """The sessions that began last, tombstones left out."""
    query = select(_S.id).where(*_of(scope), _S.state != "withdrawn")
    page = query.order_by(_S.created_at.desc(), _S.id).limit(count).offset(offset)
    return list(db.scalars(page))


def a_plan(db: Session, scope: Scope, version_id: int) -> dict[str, Any] | None:
    """The plan of one session of a version."""
    return db.scalar(
        select(_S.plan)
        .where(*_of(scope), _S.version_id == version_id, _S.state != "withdrawn")
        .limit(1)
    )


def marked(db: Session, scope: Scope, count: int) -> list[uuid.UUID]:
    """The sessions that a researcher has left out or marked by hand."""
    found: list[uuid.UUID] = []
    for column in (_S.excluded, _S.flags):
        those = select(_S.id).where(column.is_not(None))
        query = select(_S.id).where(*_few(scope), _S.id.in_(those))
        found += db.scalars(query.order_by(_S.created_at.desc(), _S.id).limit(count))
    return list(dict.fromkeys(found))


def lines(db: Session, ids: Iterable[uuid.UUID]) -> dict[uuid.UUID, Line]:
    """These sessions, as lists show them."""
    rows = db.execute(
        select(
            _S.id, _S.state, _S.group, _S.language, _S.user_agent_class, _S.source,
            _S.created_at, _S.excluded, _S.flags, _M,
        )
        .outerjoin(_M, _M.session_id == _S.id)
        .where(_S.id.in_(list(ids)))
    )  # fmt: skip
    return {row[0]: Line(*row) for row in rows}


def session_of(
    db: Session, study_id: int, session_id: uuid.UUID, *, lock: bool = False
) -> StudySession | None:
    """A session of this study; locked, no other server process changes it meanwhile."""
    query = select(_S).where(_S.id == session_id, _S.study_id == study_id)
    if lock:
        query = query.with_for_update().execution_options(populate_existing=True)
    return db.scalar(query)


def answers_of(db: Session, session_id: uuid.UUID) -> list[Response]:
    """Every answer of a session in the order of its steps, earlier revisions first."""
    query = select(Response).where(Response.session_id == session_id)
    return list(db.scalars(query.order_by(Response.trial_index, Response.revision)))


def expired(db: Session, study_id: int, before: datetime, count: int) -> list[StudySession]:
    """Sessions whose last sign, answer or beginning, is older; tombstones left out."""
    last = (
        select(func.max(Response.received_at)).where(Response.session_id == _S.id).scalar_subquery()
    )
    query = (
        select(_S)
        .where(_S.study_id == study_id, _S.state != "withdrawn", _S.created_at < before)
        .where(func.coalesce(last, _S.created_at) < before)
        .limit(count)
    )
    return list(db.scalars(query.with_for_update(of=_S)))


# ── summaries ──────────────────────────────────────────────────────────────────────────────────


class Asked(NamedTuple):
    """A session as its summary needs it."""

    id: uuid.UUID
    version_id: int
    definition_hash: str
    plan: dict[str, Any] | None
    began: datetime


class Answered(NamedTuple):
    """An answer as its session's summary needs it."""

    trial_index: int
    part: str
    clip_id: str | None
    clips: list[str] | None
    practice: bool
    check: str | None
    passed: bool | None
    answers: dict[str, Any]
    rt_ms: float
    received_at: datetime
    hidden_ms: float | None


class Waiting(NamedTuple):
    """Sessions with answers that are in no summary.

    Attributes:
        end: number of the last answer that was looked at.
        more: whether others may wait behind it.
    """

    end: int
    sessions: list[uuid.UUID]
    more: bool


def waiting(db: Session, window: int) -> Waiting:
    """The sessions of the next answers that are in no summary."""
    known = db.scalar(select(func.max(_M.upto))) or 0
    end = db.scalar(
        select(func.max(Response.id)).where(
            Response.id.in_(
                select(Response.id).where(Response.id > known).order_by(Response.id).limit(window)
            )
        )
    )
    end = max(end or 0, known)
    rows = db.scalars(
        select(Response.session_id)
        .distinct()
        .outerjoin(_M, _M.session_id == Response.session_id)
        .where(Response.id > known - LATE, Response.id <= end)
        .where(or_(_M.upto.is_(None), Response.id > _M.upto))
    )
    return Waiting(end, list(rows), more=end - known >= window)


def to_summarise(db: Session, ids: Sequence[uuid.UUID]) -> list[Asked]:
    """What is known of these sessions besides their answers."""
    began = func.coalesce(_S.consented_at, _S.created_at)
    rows = db.execute(
        select(_S.id, _S.version_id, StudyVersion.definition_hash, _S.plan, began)
        .join(StudyVersion, StudyVersion.id == _S.version_id)
        .where(_S.id.in_(ids), _S.state != "withdrawn")
    )
    return [Asked(*row) for row in rows]


def newest_answers(db: Session, session_id: uuid.UUID) -> list[Answered]:
    """The newest answer of each step, as far as a summary needs it."""
    rows = db.execute(
        select(
            Response.trial_index, Response.part, Response.clip_id, Response.clips,
            Response.practice, Response.check, Response.passed, Response.answers,
            Response.rt_ms, Response.received_at,
            Response.record["hidden_ms"].as_float(),
        )
        .where(Response.session_id == session_id)
        .order_by(Response.trial_index, Response.revision)
    )  # fmt: skip
    return list({row[0]: Answered(*row) for row in rows}.values())


def put_summaries(db: Session, rows: Sequence[dict[str, Any]]) -> None:
    """Store summaries in the place of earlier ones."""
    alive = set(
        db.scalars(
            select(_S.id)
            .where(_S.id.in_([row["session_id"] for row in rows]), _S.state != "withdrawn")
            .with_for_update()
        )
    )
    last = _last_answer(db)
    kept = [{**row, "upto": min(row["upto"], last)} for row in rows if row["session_id"] in alive]
    db.execute(delete(_M).where(_M.session_id.in_([row["session_id"] for row in kept])))
    if kept:
        db.execute(insert(_M), kept)


def forget(db: Session, session_id: uuid.UUID) -> None:
    """Delete a session's summary, after its answers.

    SQLite gives the numbers of the last rows anew once they are deleted, so that no other summary
    may claim to reach further than the answers do.
    """
    db.execute(delete(_M).where(_M.session_id == session_id))
    last = _last_answer(db)
    db.execute(update(_M).where(_M.upto > last).values(upto=last))


def _last_answer(db: Session) -> int:
    return db.scalar(select(func.max(Response.id))) or 0


def _of(scope: Scope) -> tuple[ColumnElement[bool], ...]:
    return (_S.study_id == scope.study_id, _S.kind == scope.kind)


def _few(scope: Scope) -> tuple[ColumnElement[bool], ...]:
    """The same for few known sessions: the sum keeps SQLite from going through all of a study."""
    return (_S.study_id + 0 == scope.study_id, _S.kind == scope.kind)


def _left_out() -> Select[Any]:
    """Of all studies: naming one would make SQLite take a larger index than the one of these."""
    return select(_S.id).where(_S.excluded.is_not(None))


def _counted(scope: Scope) -> tuple[ColumnElement[bool], ...]:
    """By the indexes alone: not to be left out is the rule, so the few exceptions are listed."""
    return (*_of(scope), _S.id.not_in(_left_out()))


def _histogram(db: Session, scope: Scope, value: Any) -> list[tuple[int, int]]:  # noqa: ANN401 -- a column
    query = (
        select(value, func.count())
        .join(_S, _S.id == _M.session_id)
        .where(*_counted(scope), _S.state == "complete", value.is_not(None))
        .group_by(value)
        .order_by(value)
    )
    return [(row[0], row[1]) for row in db.execute(query)]
