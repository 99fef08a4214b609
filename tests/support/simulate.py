"""Participants that do not exist: seeded answers that go through the same services as real ones.

Each clip's style has latent effects on the six axes; a rater adds a bias of his own and noise, and
the sum is rounded to a step. So the results have a known truth behind them.
"""

from __future__ import annotations

from collections.abc import Callable
from datetime import UTC, datetime
from functools import partial
from hashlib import sha256
from typing import Any

import numpy as np
from sqlalchemy.orm import Session

from app.persistence.models import Blob, ClipRecord, FigureRecord
from app.schemas.sessions import Answer, ViewingRecord, Viewport
from app.schemas.study import SemanticDifferential, Stimulus, StudyDefinition, Trials
from app.services import answers, sessions, studies
from app.services.plans import planned_steps
from app.studies import emotion

Write = Callable[[Callable[[Session], Any]], Any]
STYLES = (
    "afraid", "angry", "excited", "happy", "neutral", "relaxed", "sad", "strong", "tired", "weak",
)  # fmt: skip
BODIES = ("female", "male")

# Latent effects on (sad_happy, tired_excited, angry_relaxed, weak_strong, afraid_confident,
# masculine_feminine), in steps toward the right pole.
EFFECTS = {
    "afraid": (-0.7, -0.1, -0.2, -1.0, -1.6, 0.4),
    "angry": (-1.0, 0.7, -1.7, 1.0, 0.9, -0.8),
    "excited": (0.7, 1.6, 0.1, 0.5, 0.4, 0.1),
    "happy": (1.5, 1.0, 0.7, 0.3, 0.8, 0.3),
    "neutral": (0.1, 0.0, 0.3, 0.2, 0.3, 0.0),
    "relaxed": (0.4, -0.4, 1.6, 0.1, 0.6, 0.1),
    "sad": (-1.6, -1.0, 0.2, -0.8, -0.7, 0.2),
    "strong": (0.0, 0.6, -0.8, 1.7, 1.4, -0.9),
    "tired": (-0.9, -1.7, 0.3, -1.0, -0.4, 0.0),
    "weak": (-0.8, -1.0, 0.0, -1.6, -1.0, 0.3),
}
BODY_EFFECTS = {"female": 0.5, "male": -0.5}  # on masculine_feminine


def directly(db: Session) -> Write:
    """A stand-in for the writer where a test has one database session for all."""
    return lambda job: job(db)


def add_study(db: Session) -> StudyDefinition:
    """The demonstration study on clips without motion: enough for everything but the viewer."""
    for body in BODIES:
        for style in STYLES:
            _add_clip(db, f"acted_{body}_{style}", set="acted", body=body, style=style)
    _add_clip(db, "walk_neutral", set="A", body="adult", style="neutral")
    db.commit()
    study = studies.ensure_demonstration(db)
    assert study is not None
    return studies.definition_of(studies.newest(db, study))


def begin(write: Write, slug: str = emotion.SLUG, **beginning: Any) -> str:
    """Somebody agrees and begins; gives the personal token."""
    start = sessions.Beginning(**{"consent_version": "1", **beginning})
    token: str = write(partial(sessions.begin, slug=slug, beginning=start))
    return token


def take_part(
    write: Write,
    generator: np.random.Generator,
    *,
    slug: str = emotion.SLUG,
    answered: int | None = None,
    complete: bool = True,
) -> str:
    """One simulated participant, who may stop after some answers; gives the personal token."""
    # Of a stream of its own, which takes nothing from the answers' one.
    order = int(generator.spawn(1)[0].integers(2**sessions.SEED_BITS))
    token = begin(write, slug, seed=order)
    part, clips = write(partial(_plan, token=token))
    # Drawn clip by clip in the study's order, so that the sessions' own order changes no answer.
    bias = generator.normal(0, 0.25, len(part.task.scales))
    drawn = {shown.clip: _answer(part.task, shown, bias, generator) for shown in part.stimuli}
    for index, clip in enumerate(clips[:answered]):
        answer = drawn[clip].model_copy(update={"trial_index": index})
        write(partial(answers.record, token=token, answer=answer))
    if complete and answered is None:
        write(partial(sessions.complete, token=token))
    return token


def simulate(write: Write, participants: int, seed: int = 1, slug: str = emotion.SLUG) -> list[str]:
    """So many complete participants."""
    generator = np.random.default_rng(seed)
    return [take_part(write, generator, slug=slug) for _ in range(participants)]


def answer_with(
    values: dict[str, Any], trial_index: int = 0, revision: int = 1, **changes: Any
) -> Answer:
    """An answer that a page might send."""
    given = {
        "trial_index": trial_index,
        "revision": revision,
        "answers": values,
        "touched": sorted(values),
        "comment": "",
        "rt_ms": 5210.5,
        "time_elapsed_ms": 61_000.25,
        "client_time": datetime(2026, 3, 1, 12, tzinfo=UTC),
        "record": ViewingRecord(
            plays=2, viewing_ms=4800.0, camera_moves=1, hidden_ms=0.0, blur_count=0,
            dropped_frames=3, tier="high",
            viewport=Viewport(width=1280, height=800, pixel_ratio=1.0),
        ),
    }  # fmt: skip
    return Answer.model_validate({**given, **changes})


def _plan(db: Session, token: str) -> tuple[Trials, list[str]]:
    session = sessions.open_session(db, token)
    (part,) = studies.definition_of(session.version).trials
    return part, [step["clips"][0] for step in planned_steps(session.plan)]


def _answer(
    task: SemanticDifferential, shown: Stimulus, bias: np.ndarray, generator: np.random.Generator
) -> Answer:
    latent = np.array(EFFECTS.get(shown.style or "", np.zeros(6))) + bias
    latent[-1] += BODY_EFFECTS.get(shown.body or "", 0.0)
    noisy = latent + generator.normal(0, 0.8, latent.size)
    steps = np.clip(np.rint(noisy), -task.reach, task.reach)
    values = {scale.id: int(step) for scale, step in zip(task.scales, steps, strict=True)}
    touched = [scale for scale, value in values.items() if value or generator.random() < 0.5]
    viewing = float(generator.uniform(3000, 9000))
    return answer_with(values, touched=touched, rt_ms=viewing + 900)


def _add_clip(db: Session, name: str, **tags: str) -> None:
    content = name.encode()
    known = sha256(content).hexdigest()
    db.add(Blob(hash=known, media_type="model/gltf-binary", content=content))
    db.flush()
    skeleton = sha256(tags["body"].encode()).hexdigest()
    if db.get(FigureRecord, skeleton) is None:
        db.add(FigureRecord(skeleton_hash=skeleton, glb_blob=known, engine_version="test"))
    db.add(
        ClipRecord(
            id=sha256(b"clip" + content).hexdigest(), content_hash=known, name=name,
            source="sample", state="kept",
            skeleton_hash=skeleton, frames=10, frame_time=1 / 30, duration=0.3, cyclic=False,
            stature=1.7, poster_time=0.1, tags=tags, report=None, clip_blob=known, glb_blob=known,
            source_blob=None, engine_version="test",
        )
    )  # fmt: skip
    db.flush()
