"""Storing one answer: idempotent, checked against the study, never overwriting another."""

from __future__ import annotations

from datetime import datetime
from hashlib import sha256
from json import dumps
from typing import Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError
from app.persistence import responses
from app.persistence.models import now
from app.persistence.responses import Asked, Stored
from app.schemas.sessions import Answer, AnswerReceipt
from app.schemas.study import StudyDefinition
from app.services.sessions import hash_token, planned_trials, refuse_withdrawn, unknown_link
from app.services.studies import definition_by_hash


def record(db: Session, token: str, answer: Answer) -> tuple[AnswerReceipt, bool]:
    """Store an answer, or find it stored; the commit is the writer's.

    Returns:
        The receipt, and whether the answer is new. Receipts of one answer are all the same.

    Raises:
        NotFoundError: no such session.
        ConflictError: this revision holds another answer, or the session takes no more.
        InvalidError: the answer does not fit the study.
    """
    asked = responses.asked(db, hash_token(token), answer.trial_index, answer.revision)
    if asked is None:
        raise unknown_link()
    refuse_withdrawn(asked.state)
    fingerprint = fingerprint_of(answer)
    if asked.stored is not None:
        if asked.stored.fingerprint != fingerprint:
            raise _already_answered(answer, asked.stored)
        return _receipt(answer, asked.stored.received_at), False
    if asked.state == "complete":
        raise ConflictError(
            "The study is complete; its answers can no longer be changed.",
            code="session_complete",
            mend="Nothing more to do: all that you answered before is stored.",
        )
    check_answer(answer, definition_by_hash(db, asked.study_id, asked.definition_hash))
    trial = _trial(asked, answer.trial_index)
    received_at = now()
    responses.add(
        db,
        session_id=asked.session_id,
        trial_index=answer.trial_index,
        revision=answer.revision,
        clip_id=trial["clip"],
        practice=trial["practice"],
        answers=answer.answers,
        comment=answer.comment,
        rt_ms=answer.rt_ms,
        record=_record(answer),
        fingerprint=fingerprint,
        received_at=received_at,
    )
    return _receipt(answer, received_at), True


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


def _trial(asked: Asked, index: int) -> dict[str, Any]:
    trials = planned_trials(asked.plan)
    if index >= len(trials):
        raise InvalidError(
            f"There is no clip {index}: the session has {len(trials)}, counted from 0.",
            code="trial_unknown",
            where={"trial_index": index},
            mend="Reload the page.",
        )
    return trials[index]


def _record(answer: Answer) -> dict[str, Any]:
    return {
        "touched": answer.touched,
        "time_elapsed_ms": answer.time_elapsed_ms,
        "client_time": answer.client_time.isoformat(),
        **answer.record.model_dump(mode="json"),
    }


def _receipt(answer: Answer, received_at: datetime) -> AnswerReceipt:
    return AnswerReceipt(
        trial_index=answer.trial_index, revision=answer.revision, received_at=received_at
    )


def _already_answered(answer: Answer, stored: Stored) -> ConflictError:
    place = {"trial_index": answer.trial_index, "revision": answer.revision}
    return ConflictError(
        "Another answer to this clip is stored already, perhaps from a second tab.",
        code="already_answered",
        where=place,
        mend="Reload the page: it shows what is stored.",
        extra={
            "stored": {
                **place,
                "answers": stored.answers,
                "touched": stored.record["touched"],
                "comment": stored.comment,
                "received_at": stored.received_at.isoformat(),
            }
        },
    )
