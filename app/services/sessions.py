"""A participant's way through a study: begin, look where one is, complete, withdraw.

Functions that change something take the writer's database session and leave the commit to it.
"""

from __future__ import annotations

import secrets
from dataclasses import dataclass
from hashlib import sha256
from typing import Any

import numpy as np
from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError, NotFoundError
from app.persistence import responses, studies
from app.persistence import sessions as store
from app.persistence.models import StudySession, now
from app.schemas.sessions import (
    Completion,
    ResponseView,
    ScaleView,
    SessionView,
    StudyView,
    TrialView,
)
from app.schemas.study import StudyDefinition
from app.services.studies import ExampleClip, definition_of, find, media_url, thanks_clip

# Crockford's base 32: no I, L, O, U, so a code can be read out and typed.
CODE_LETTERS = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"
# 48 bits: every statistics program and spreadsheet reads them back exactly.
SEED_BITS = 48


@dataclass(frozen=True)
class Standing:
    """Where a personal link stands; there is a completion code only once the session is complete.

    `answers` counts the clips that have an answer.
    """

    study: StudyDefinition
    state: str
    answers: int
    completion_code: str | None
    clip: ExampleClip | None


def begin(db: Session, slug: str, consent_version: str, user_agent: str = "") -> str:
    """Start a session for someone who agreed, and return the secret of the personal link.

    Raises:
        NotFoundError: no such study.
        InvalidError: agreed to another version of the consent than the present one.
    """
    study = find(db, slug)
    definition = definition_of(study)
    if consent_version != definition.consent.version:
        raise InvalidError(
            "The text that you agreed to has changed since you opened the page.",
            code="consent_changed",
            mend="Please read the new text and agree again.",
        )
    token, seed = secrets.token_urlsafe(24), secrets.randbits(SEED_BITS)
    db.add(
        StudySession(
            study=study,
            token_hash=hash_token(token),
            seed=seed,
            plan=draw_plan(definition, seed),
            state="active",
            consent_version=consent_version,
            consented_at=now(),
            user_agent_class=device_class(user_agent),
        )
    )
    db.flush()
    return token


def draw_plan(definition: StudyDefinition, seed: int) -> dict[str, Any]:
    """The trials in one participant's order: practice clips first, then every clip once.

    The order is that of the raw 64-bit draws of PCG64: NumPy promises these to stay the same
    for a seed, on every platform and in every version, which it does not for its shuffles.
    """
    draws = np.random.Generator(np.random.PCG64(seed)).bit_generator
    clips = [stimulus.clip for stimulus in definition.stimuli]
    practice = np.argsort(draws.random_raw(len(clips)), kind="stable")[: definition.practice]
    order = np.argsort(draws.random_raw(len(clips)), kind="stable")
    trials = [{"clip": clips[index], "practice": True} for index in practice]
    trials += [{"clip": clips[index], "practice": False} for index in order]
    return {"trials": trials}


def view(db: Session, token: str) -> SessionView:
    """All that the participant's page needs to go on where it stopped."""
    session = open_session(db, token)
    definition = definition_of(session.study)
    trials = planned_trials(session.plan)
    media = studies.media(db, (trial["clip"] for trial in trials))
    newest = responses.newest(db, session.id)
    return SessionView(
        study=_study_view(definition),
        state=session.state,
        trials=[
            TrialView(
                index=index,
                glb_url=media_url(clip.glb),
                figure_url=clip.figure and media_url(clip.figure),
                cyclic=clip.cyclic,
            )
            for index, clip in enumerate(media[trial["clip"]] for trial in trials)
        ],
        responses={
            index: ResponseView(
                revision=row.revision,
                answers=row.answers,
                touched=row.record["touched"],
                comment=row.comment,
            )
            for index, row in sorted(newest.items())
        },
        next=next((i for i in range(len(trials)) if i not in newest), len(trials)),
    )


def complete(db: Session, token: str) -> Completion:
    """Close a session that has an answer for every trial; the same code however often asked.

    Raises:
        ConflictError: answers are missing, or the session was withdrawn.
    """
    session = open_session(db, token, lock=True)
    refuse_withdrawn(session.state)
    trials = len(planned_trials(session.plan))
    if session.completion_code is None:
        missing = sorted(set(range(trials)) - responses.answered(db, session.id))
        if missing:
            raise ConflictError(
                f"{len(missing)} of {trials} clips have no answer yet.",
                code="answers_missing",
                where={"missing": missing},
                mend="Answer the missing clips; what you have answered is kept.",
            )
        session.state = "complete"
        session.completed_at = now()
        session.completion_code = _completion_code()
        db.flush()
    return Completion(completion_code=session.completion_code, answers=trials)


def withdraw(db: Session, token: str) -> None:
    """Delete a participant's answers and all that is known of the session, now and for good.

    A tombstone stays: that somebody withdrew. Withdrawing again changes nothing.
    """
    session = open_session(db, token, lock=True)
    responses.delete_all(db, session.id)
    session.state = "withdrawn"
    session.withdrawn_at = session.created_at = session.withdrawn_at or now()
    session.seed = session.plan = session.completion_code = None
    session.consent_version = session.consented_at = session.completed_at = None
    session.user_agent_class = None
    db.flush()


def standing(db: Session, token: str) -> Standing:
    """Where a personal link stands."""
    session = open_session(db, token)
    definition = definition_of(session.study)
    return Standing(
        study=definition,
        state=session.state,
        answers=len(responses.answered(db, session.id)),
        completion_code=session.completion_code,
        clip=thanks_clip(db, definition),
    )


def open_session(db: Session, token: str, *, lock: bool = False) -> StudySession:
    """The session of a personal link.

    Raises:
        NotFoundError: the link is none of ours.
    """
    session = store.by_token_hash(db, hash_token(token), lock=lock)
    if session is None:
        raise unknown_link()
    return session


def unknown_link() -> NotFoundError:
    """What to raise for a token that is none of ours."""
    return NotFoundError(
        "This personal link is not known here.",
        code="session_not_found",
        mend="Open the link exactly as you got it, or begin the study anew.",
    )


def refuse_withdrawn(state: str) -> None:
    """Raise ConflictError for a session whose participant took the answers back."""
    if state == "withdrawn":
        raise ConflictError(
            "You have withdrawn from this study and your answers are deleted.",
            code="session_withdrawn",
            mend="Nothing more to do. To take part after all, begin anew.",
        )


def planned_trials(plan: dict[str, Any] | None) -> list[dict[str, Any]]:
    """The trials of a session's plan in order; none after a withdrawal."""
    trials: list[dict[str, Any]] = (plan or {"trials": []})["trials"]
    return trials


def hash_token(token: str) -> str:
    """What is stored of a personal link: enough to know it again, not to make it."""
    return sha256(token.encode("utf-8", "replace")).hexdigest()


def device_class(user_agent: str) -> str:
    """Phone, tablet or desktop; the rest of what a browser tells of itself is not kept."""
    agent = user_agent.lower()
    if "ipad" in agent or ("android" in agent and "mobile" not in agent):
        return "tablet"
    return "phone" if "mobi" in agent else "desktop"


def _completion_code() -> str:
    letters = "".join(secrets.choice(CODE_LETTERS) for _ in range(8))
    return f"MNR-{letters[:4]}-{letters[4:]}"


def _study_view(definition: StudyDefinition) -> StudyView:
    return StudyView(
        title=definition.welcome.heading,
        question=definition.question,
        hint=definition.hint,
        scales=[ScaleView(id=s.id, left=s.left, right=s.right) for s in definition.scales],
        steps=list(definition.steps),
        comment_label=definition.comment.label,
        comment_placeholder=definition.comment.placeholder,
    )
