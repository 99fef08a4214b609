"""Answers to pairs of adjectives put straight into the database, as an array says them."""

from __future__ import annotations

from datetime import UTC, datetime
from hashlib import sha256
from typing import Any
from uuid import uuid4

import numpy as np
from numpy.typing import NDArray
from sqlalchemy.orm import Session

from app.persistence.models import Response, Study, StudySession, StudyVersion
from app.schemas.study import StudyDefinition
from tests.support import study_files
from tests.support.published import add_published

PART = "semantic_differential"
NOON = datetime(2026, 3, 1, 12, tzinfo=UTC)


def scales(pairs: int) -> list[dict[str, Any]]:
    """Made-up pairs in two languages: left_0 – right_0 and so on."""
    return [
        {
            "id": f"pair_{n}",
            "left": {"en": f"left {n}", "fi": f"vasen {n}"},
            "right": {"en": f"right {n}", "fi": f"oikea {n}"},
        }
        for n in range(pairs)
    ]


def definition(
    clips: int | list[dict[str, Any]],
    pairs: int,
    slug: str = "adjectives",
    steps: int = 5,
    **task: Any,
) -> StudyDefinition:
    """A study whose one part asks for so many pairs of so many clips, or of these stimuli."""
    asked = {"scales": scales(pairs), "steps": [f"step {n}" for n in range(steps)], **task}
    shown = study_files.stimuli(clips) if isinstance(clips, int) else clips
    part = study_files.trials(PART, task=asked, stimuli=shown)
    return study_files.study(part, slug=slug, title=slug.title(), languages=["en", "fi"])


def rated(db: Session, asked: StudyDefinition, ratings: NDArray[np.float64]) -> Study:
    """The study, published, with complete participants who rated so (people, clips, pairs)."""
    study = add_published(db, asked)
    add(db, study, ratings)
    return study


def add(
    db: Session, study: Study, ratings: NDArray[np.float64], **changes: Any
) -> list[StudySession]:
    """More participants of the newest version; NaN is no answer, a clip of NaN alone no trial.

    `changes`: columns of the sessions, and `practice`, `check` of the answers.
    """
    version = (
        db.query(StudyVersion)
        .filter_by(study_id=study.id)
        .order_by(StudyVersion.number.desc())
        .first()
    )
    of_answers = {name: changes.pop(name) for name in ("practice", "check") if name in changes}
    part = next(p for p in StudyDefinition.model_validate(version.definition).trials)
    found = []
    for person in ratings:
        session = StudySession(
            **{"study_id": study.id, "version_id": version.id, "kind": "participant",
               "token_hash": sha256(uuid4().bytes).hexdigest(), "state": "complete",
               "completed_at": NOON, **changes},
        )  # fmt: skip
        db.add(session)
        db.flush()
        for index, (shown, values) in enumerate(zip(part.stimuli, person, strict=True)):
            given = {
                scale.id: int(value)
                for scale, value in zip(part.task.scales, values, strict=True)
                if not np.isnan(value)
            }
            if given:
                db.add(_response(session, part.id, index, shown.clip, given, **of_answers))
        found.append(session)
    db.commit()
    return found


def latent(
    people: int, clips: int, groups: list[int], seed: int = 1, noise: float = 0.5
) -> NDArray[np.float64]:
    """Ratings (people, clips, pairs) that follow as many latent factors as there are groups.

    Args:
        people: how many rate.
        clips: how many clips.
        groups: how many pairs follow each factor.
        seed: of the draws.
        noise: standard deviation of a rating, in steps, before it is rounded.
    """
    generator = np.random.default_rng(seed)
    factors = generator.uniform(-2, 2, (clips, len(groups)))
    factors[0], factors[1] = 2, -2  # so that every pair has a clip at either end
    true = np.repeat(factors, groups, axis=1)
    drawn = true + generator.normal(0, noise, (people, *true.shape))
    return np.clip(np.rint(drawn), -2, 2)


def _response(
    session: StudySession, part: str, index: int, clip: str | None, given: dict[str, int],
    **more: Any,
) -> Response:  # fmt: skip
    return Response(
        **{
            "session_id": session.id, "part": part, "trial_type": PART, "trial_index": index,
            "revision": 1, "clips": [clip], "answers": given, "rt_ms": 1000.0, "record": {},
            "fingerprint": "-", "practice": False, "received_at": NOON, **more,
        }
    )  # fmt: skip
