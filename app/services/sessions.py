"""A participant's way through a study: begin, look where one is, complete, withdraw.

Functions that change something take the writer's database session and leave the commit to it.
"""

from __future__ import annotations

import secrets
from dataclasses import dataclass, field
from datetime import timedelta
from hashlib import sha256
from typing import cast, get_args

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError, NotFoundError
from app.persistence import audit, responses
from app.persistence import sessions as store
from app.persistence.models import StudySession, now
from app.schemas.sessions import Completion
from app.schemas.study import Language, Outcome, StudyDefinition
from app.services.admission import Closed, closed_for
from app.services.allocation import take_slot
from app.services.plans import draw_plan, group_of, planned_steps
from app.services.recruiting import Arrival, Return, Source, given_back
from app.services.studies import (
    ExampleClip,
    definition_of,
    find,
    language_for,
    localised,
    newest,
    running_of,
    thanks_clip,
)

# Crockford's base 32: no I, L, O, U, so a code can be read out and typed.
CODE_LETTERS = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"
# 48 bits: every statistics program and spreadsheet reads them back exactly.
SEED_BITS = 48


@dataclass(frozen=True)
class Beginning:
    """How somebody begins.

    Attributes:
        consent_version: of the text that was agreed to.
        languages: those that the person wants, the best first.
        coming: who comes, from where.
        token: the secret of the personal link, where the identity gives it; None: a new one.
        kind: ``participant``, ``preview`` or ``simulated``.
        seed: from which the order is drawn; None: a new one.
    """

    consent_version: str
    user_agent: str = ""
    languages: tuple[str | None, ...] = ()
    coming: Arrival = field(default_factory=Arrival)
    token: str | None = None
    kind: str = "participant"
    seed: int | None = None


@dataclass(frozen=True)
class Standing:
    """Where a personal link stands; there is a completion code only once the session is complete.

    Attributes:
        study: its texts in the session's language.
        answers: how many trials about clips have an answer.
        going: where to go afterwards, once the session has ended.
    """

    study: StudyDefinition
    language: Language
    state: str
    answers: int
    completion_code: str | None
    going: Return | None
    clip: ExampleClip | None


def begin(db: Session, slug: str, beginning: Beginning) -> str:
    """Start a session for someone who agreed, and return the secret of the personal link.

    Whoever has begun already, by an identity that the link carries, goes on with the same session.

    Raises:
        NotFoundError: no such study.
        InvalidError: agreed to another version of the consent than the present one.
        ConflictError: the study takes nobody now (`study_closed`, `study_full`).
    """
    study = find(db, slug, lock=True)
    if beginning.token and store.by_token_hash(db, hash_token(beginning.token)):
        return beginning.token
    version = newest(db, study)
    definition = definition_of(version)
    if beginning.consent_version != definition.consent.version:
        raise InvalidError(
            "The text that you agreed to has changed since you opened the page.",
            code="consent_changed",
            mend="Please read the new text and agree again.",
        )
    moment = now()
    if beginning.kind == "participant":
        _refuse_closed(closed_for(db, study, running_of(study), beginning.coming, moment))
    slot = take_slot(db, study, version, beginning.kind, moment)
    token = beginning.token or secrets.token_urlsafe(24)
    seed = secrets.randbits(SEED_BITS) if beginning.seed is None else beginning.seed
    db.add(
        StudySession(
            study=study,
            version=version,
            kind=beginning.kind,
            token_hash=hash_token(token),
            slot=slot,
            group=group_of(definition, slot),
            seed=seed,
            plan=draw_plan(definition, seed, slot, version.definition_hash),
            state="active",
            language=language_for(definition, *beginning.languages),
            source=beginning.coming.source,
            external=beginning.coming.parameters,
            consent_version=beginning.consent_version,
            consented_at=moment,
            user_agent_class=device_class(beginning.user_agent),
        )
    )
    db.flush()
    return token


def known(db: Session, token: str | None) -> bool:
    """Whether somebody has begun with this secret already."""
    return token is not None and store.by_token_hash(db, hash_token(token)) is not None


def complete(db: Session, token: str) -> Completion:
    """Close a session that has an answer for every step; the same code however often asked.

    Raises:
        ConflictError: answers are missing, or the session has ended otherwise.
    """
    session = open_session(db, token, lock=True)
    refuse_withdrawn(session.state)
    steps = planned_steps(session.plan)
    if session.completion_code is None:
        missing = sorted(set(range(len(steps))) - responses.answered(db, session.id))
        if missing:
            raise ConflictError(
                f"{len(missing)} of {len(steps)} steps have no answer yet.",
                code="answers_missing",
                where={"missing": missing},
                mend="Answer what is missing; what you have answered is kept.",
            )
        session.state = "complete"
        session.completed_at = now()
        session.completion_code = _completion_code()
        db.flush()
    return Completion(completion_code=session.completion_code, answers=len(steps))


def withdraw(db: Session, token: str) -> None:
    """Delete a participant's answers and all that is known of the session, now and for good.

    A tombstone stays: that somebody withdrew. Withdrawing again changes nothing.
    """
    erase(db, open_session(db, token, lock=True))


def erase(db: Session, session: StudySession) -> None:
    """The same for a session at hand."""
    responses.delete_all(db, session.id)
    audit.forget_reasons(db, session.id)
    session.state = "withdrawn"
    session.withdrawn_at = session.created_at = session.withdrawn_at or now()
    session.seed = session.plan = session.completion_code = None
    session.slot = session.group = session.language = None
    session.source = session.external = session.excluded = session.flags = None
    session.consent_version = session.consented_at = session.completed_at = None
    session.user_agent_class = None
    db.flush()


def standing(db: Session, token: str) -> Standing:
    """Where a personal link stands."""
    session = open_session(db, token)
    definition = definition_of(session.version)
    language = language_for(definition, session.language)
    answered = responses.answered(db, session.id)
    steps = planned_steps(session.plan)
    return Standing(
        study=localised(session.version, language),
        language=language,
        state=session.state,
        answers=sum("clips" in step for i, step in enumerate(steps) if i in answered),
        completion_code=session.completion_code,
        going=_going(session),
        clip=thanks_clip(db, definition),
    )


def _going(session: StudySession) -> Return | None:
    if session.state not in get_args(Outcome):
        return None
    return given_back(
        running_of(session.study),
        cast("Source", session.source or "open"),
        cast("Outcome", session.state),
        session.external or {},
        session.completion_code or "",
    )


def open_session(db: Session, token: str, *, lock: bool = False) -> StudySession:
    """The session behind a personal link.

    Args:
        db: where to look.
        token: the secret of the link.
        lock: keep other server processes from changing it until the commit.

    Raises:
        NotFoundError: there is none.
    """
    session = store.by_token_hash(db, hash_token(token), lock=lock)
    if session is None:
        raise unknown_link()
    return session


def refuse_late(session: StudySession) -> None:
    """Raise ConflictError for a session that was begun too long ago to be gone on with."""
    days = running_of(session.study).resume_days
    if session.state == "active" and now() - session.created_at > timedelta(days=days):
        raise ConflictError(
            f"This link was good for {days} days, and they are over.",
            code="session_expired",
            mend="What you answered is kept. Write to the researchers if you want to go on.",
        )


def unknown_link() -> NotFoundError:
    """What to raise for a token that is none of ours."""
    return NotFoundError(
        "This personal link is not known here.",
        code="session_not_found",
        mend="Open the link exactly as you got it, or begin the study anew.",
    )


def refuse_ended(state: str) -> None:
    """Raise ConflictError for a session that takes no more answers, whatever has ended it."""
    refuse_withdrawn(state)
    if state == "complete":
        raise ConflictError(
            "The study is complete; its answers can no longer be changed.",
            code="session_complete",
            mend="Nothing more to do: all that you answered before is stored.",
        )
    if state != "active":
        raise ConflictError(
            "The study has ended for you.",
            code="session_ended",
            mend="Nothing more to do: load the page again to see why.",
        )


def refuse_withdrawn(state: str) -> None:
    """Raise ConflictError for a session whose participant took the answers back."""
    if state == "withdrawn":
        raise ConflictError(
            "You have withdrawn from this study and your answers are deleted.",
            code="session_withdrawn",
            mend="Nothing more to do. To take part after all, begin anew.",
        )


def hash_token(token: str) -> str:
    """What is stored of a personal link: enough to know it again, not to make it."""
    return sha256(token.encode("utf-8", "replace")).hexdigest()


def device_class(user_agent: str) -> str:
    """Phone, tablet or desktop; the rest of what a browser tells of itself is not kept."""
    agent = user_agent.lower()
    if "ipad" in agent or ("android" in agent and "mobile" not in agent):
        return "tablet"
    return "phone" if "mobi" in agent else "desktop"


def _refuse_closed(reason: Closed | None) -> None:
    if reason is not None:
        raise ConflictError(
            "This study takes no new participants now.",
            code="study_full" if reason == "full" else "study_closed",
            where={"reason": reason},
            mend="Nothing was kept. If you had begun already, your own link still works.",
        )


def _completion_code() -> str:
    letters = "".join(secrets.choice(CODE_LETTERS) for _ in range(8))
    return f"MNR-{letters[:4]}-{letters[4:]}"
