"""Storing one answer: idempotent, checked against the study, never overwriting another."""

from __future__ import annotations

from hashlib import sha256
from json import dumps
from typing import Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError
from app.persistence import responses
from app.persistence.models import Response, StudySession, now
from app.schemas.sessions import Answer, AnswerReceipt
from app.schemas.study import StudyDefinition
from app.services.sessions import open_session, planned_trials, refuse_withdrawn
from app.services.studies import definition_of


def record(db: Session, token: str, answer: Answer) -> tuple[AnswerReceipt, bool]:
    """Store an answer, or find it stored; the commit is the writer's.

    Returns:
        The receipt, and whether the answer is new. Receipts of one answer are all the same.

    Raises:
        NotFoundError: no such session.
        ConflictError: this revision holds another answer, or the session takes no more.
        InvalidError: the answer does not fit the study.
    """
    session = open_session(db, token, lock=True)
    refuse_withdrawn(session)
    fingerprint = fingerprint_of(answer)
    stored = responses.stored(db, session.id, answer.trial_index, answer.revision)
    if stored is not None:
        if stored.fingerprint != fingerprint:
            raise _already_answered(stored)
        return _receipt(stored), False
    if session.state == "complete":
        raise ConflictError(
            "The study is complete; its answers can no longer be changed.",
            code="session_complete",
            mend="Nothing more to do: all that you answered before is stored.",
        )
    check_answer(answer, definition_of(session.study))
    row = _row(session, answer, fingerprint)
    db.add(row)
    db.flush()
    return _receipt(row), True


def fingerprint_of(answer: Answer) -> str:
    """By what a repeated answer is known: what was chosen and written, not when it was sent."""
    chosen = {
        "answers": answer.answers,
        "touched": sorted(set(answer.touched)),
        "comment": answer.comment,
    }
    return sha256(dumps(chosen, sort_keys=True).encode()).hexdigest()


def check_answer(answer: Answer, definition: StudyDefinition) -> None:
    """Raise InvalidError unless every scale of the study has one of its steps, and no other has."""
    scales = {scale.id for scale in definition.scales}
    given = set(answer.answers)
    faults = [f"“{scale}” is not answered" for scale in sorted(scales - given)]
    faults += [f"“{scale}” is no scale of this study" for scale in sorted(given - scales)]
    faults += [
        f"“{scale}” is {value}, not within {-definition.reach} … {definition.reach}"
        for scale, value in answer.answers.items()
        if abs(value) > definition.reach
    ]
    faults += [
        f"“{scale}” was touched but is no scale" for scale in sorted(set(answer.touched) - scales)
    ]
    if faults:
        raise InvalidError(
            f"The answer does not fit the study: {'; '.join(faults[:5])[:600]}.",
            code="answer_invalid",
            where={"trial_index": answer.trial_index},
            mend="Reload the page and answer this clip again.",
        )


def _row(session: StudySession, answer: Answer, fingerprint: str) -> Response:
    trials = planned_trials(session)
    if answer.trial_index >= len(trials):
        raise InvalidError(
            f"There is no clip {answer.trial_index}: the session has {len(trials)}, from 0.",
            code="trial_unknown",
            where={"trial_index": answer.trial_index},
            mend="Reload the page.",
        )
    trial = trials[answer.trial_index]
    return Response(
        session_id=session.id,
        trial_index=answer.trial_index,
        revision=answer.revision,
        clip_id=trial["clip"],
        practice=trial["practice"],
        answers=answer.answers,
        comment=answer.comment,
        rt_ms=answer.rt_ms,
        record=_record(answer),
        fingerprint=fingerprint,
        received_at=now(),
    )


def _record(answer: Answer) -> dict[str, Any]:
    return {
        "touched": answer.touched,
        "time_elapsed_ms": answer.time_elapsed_ms,
        "client_time": answer.client_time.isoformat(),
        **answer.record.model_dump(mode="json"),
    }


def _receipt(row: Response) -> AnswerReceipt:
    return AnswerReceipt(
        trial_index=row.trial_index, revision=row.revision, received_at=row.received_at
    )


def _already_answered(stored: Response) -> ConflictError:
    return ConflictError(
        "Another answer to this clip is stored already, perhaps from a second tab.",
        code="already_answered",
        where={"trial_index": stored.trial_index, "revision": stored.revision},
        mend="Reload the page: it shows what is stored.",
        extra={
            "stored": {
                "trial_index": stored.trial_index,
                "revision": stored.revision,
                "answers": stored.answers,
                "comment": stored.comment,
                "received_at": stored.received_at.isoformat(),
            }
        },
    )
