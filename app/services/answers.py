"""Storing one answer: idempotent, checked against the study, never overwriting another."""

from __future__ import annotations

from datetime import datetime
from hashlib import sha256
from json import dumps
from typing import Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError
from app.persistence import responses, sessions, studies
from app.persistence.models import now
from app.persistence.responses import Asked, Stored
from app.schemas.sessions import Answer, AnswerReceipt, SessionState
from app.schemas.study import AnyPart, Match, Outcome, Trials
from app.services import matching
from app.services.answer_checks import faults_of, held, screens_out
from app.services.measures import CHOICES
from app.services.plans import PAUSE, Step, planned_steps
from app.services.sessions import hash_token, refuse_ended, refuse_withdrawn, unknown_link
from app.services.studies import definition_by_hash, running_of


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
        state = "active" if asked.state == "complete" else asked.state
        return _receipt(answer, asked.stored.received_at, state), False
    refuse_ended(asked.state)
    definition = definition_by_hash(db, asked.version_id, asked.definition_hash)
    step = _step(asked, answer.trial_index)
    part = None if step["part"] == PAUSE.id else definition.part(step["part"])
    check_answer(answer, part, step)
    passed = _passed(db, asked, part, step, answer)
    received_at = now()
    responses.add(
        db,
        session_id=asked.session_id,
        trial_index=answer.trial_index,
        revision=answer.revision,
        part=step["part"],
        trial_type=_kind(part),
        clip_id=step["clips"][0] if len(step.get("clips", ())) == 1 else None,
        clips=_figures(step),
        practice=step.get("practice", False),
        check=step.get("check"),
        passed=passed,
        answers=_answers(db, part, step, answer),
        comment=answer.comment,
        rt_ms=answer.rt_ms,
        record=_record(answer),
        fingerprint=fingerprint,
        received_at=received_at,
    )
    return _receipt(answer, received_at, _state_after(db, asked, part, answer, passed)), True


def _answers(db: Session, part: AnyPart | None, step: Step, answer: Answer) -> dict[str, Any]:
    """What is stored: what was sent and, of a match, how near it came."""
    if isinstance(part, Trials) and isinstance(part.task, Match):
        return matching.measured(db, part.task, step, answer.answers)
    return answer.answers


def _passed(
    db: Session, asked: Asked, part: AnyPart | None, step: Step, answer: Answer
) -> bool | None:
    """Whether the attention check held that this step is; None where it is none."""
    if "check" not in step or not isinstance(part, Trials):
        return None
    check = next(one for one in part.checks if one.id == step["check"])
    earlier = responses.newest_of(db, asked.session_id, step["of"]) if "of" in step else None
    return held(check, answer.answers, earlier, chosen=part.task.kind in CHOICES)


def _state_after(
    db: Session, asked: Asked, part: AnyPart | None, answer: Answer, passed: bool | None
) -> SessionState:
    """Whether the answer ends the study for this person; if so, it is ended."""
    outcome: Outcome | None = None
    if screens_out(part, answer.answers):
        outcome = "screened_out"
    elif passed is False and _too_many_failed(db, asked):
        outcome = "failed_attention"
    if outcome is None:
        return "active"
    sessions.end_early(db, asked.session_id, outcome)
    return outcome


def _too_many_failed(db: Session, asked: Asked) -> bool:
    running = running_of(studies.by_id(db, asked.study_id))
    return running.fail_after is not None and (
        responses.failed_checks(db, asked.session_id) >= running.fail_after
    )


def _kind(part: AnyPart | None) -> str:
    if part is None:
        return PAUSE.kind
    return part.task.kind if isinstance(part, Trials) else part.kind


def fingerprint_of(answer: Answer) -> str:
    """By what a repeated answer is known: what was chosen and written, not when it was sent."""
    chosen = {
        "answers": answer.answers,
        "touched": sorted(set(answer.touched)),
        "comment": answer.comment,
    }
    return sha256(dumps(chosen, sort_keys=True).encode()).hexdigest()


def check_answer(answer: Answer, part: AnyPart | None, step: Step) -> None:
    """Raise InvalidError unless the answer fits what this step asks."""
    figures = 2 if "x" in step else len(step.get("clips", ()))
    faults = faults_of(part, answer.answers, figures)
    faults += [
        f"“{name[:60]}” was touched but is not asked here"
        for name in sorted(set(answer.touched) - set(answer.answers))
    ]
    if faults:
        raise InvalidError(
            f"The answer does not fit the study: {'; '.join(faults[:5])[:600]}.",
            code="answer_invalid",
            where={"trial_index": answer.trial_index},
            mend="Reload the page and answer this clip again.",
        )


def _step(asked: Asked, index: int) -> Step:
    steps = planned_steps(asked.plan)
    if index >= len(steps):
        raise InvalidError(
            f"There is no step {index}: the session has {len(steps)}, counted from 0.",
            code="trial_unknown",
            where={"trial_index": index},
            mend="Reload the page.",
        )
    return steps[index]


def _figures(step: Step) -> list[str] | None:
    """The clips as they stood on the page; X comes last, so that it shows who was right."""
    clips: list[str] | None = step.get("clips")
    return [*clips, clips[step["x"]]] if clips and "x" in step else clips


def _record(answer: Answer) -> dict[str, Any]:
    return {
        "touched": answer.touched,
        "time_elapsed_ms": answer.time_elapsed_ms,
        "client_time": answer.client_time.isoformat(),
        **answer.record.model_dump(mode="json"),
    }


def _receipt(answer: Answer, received_at: datetime, state: str) -> AnswerReceipt:
    return AnswerReceipt.model_validate(
        {
            "trial_index": answer.trial_index, "revision": answer.revision,
            "received_at": received_at, "state": state,
        }
    )  # fmt: skip


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
                "answers": matching.as_sent(stored.answers),
                "touched": stored.record["touched"],
                "comment": stored.comment,
                "received_at": stored.received_at.isoformat(),
            }
        },
    )
