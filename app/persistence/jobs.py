"""Long work and its progress."""

from __future__ import annotations

import uuid
from collections.abc import Mapping
from typing import Any

from sqlalchemy import Text, cast, select, update
from sqlalchemy.orm import Session, defer

from app.persistence.models import Job, now

OPEN = ("running", "waiting")  # what a killed server left running goes on before what waits
NEWEST = 50


def add(db: Session, job: Job) -> Job:
    """Store a job that waits."""
    db.add(job)
    db.flush()
    return job


def by_id(db: Session, job_id: uuid.UUID) -> Job | None:
    """The job with this number."""
    return db.get(Job, job_id)


def newest(db: Session) -> list[Job]:
    """The last jobs, the newest first, without what they are made of."""
    query = select(Job).options(defer(Job.request), defer(Job.items))
    return list(db.scalars(query.order_by(Job.created_at.desc(), Job.id).limit(NEWEST)))


def any_open(db: Session) -> bool:
    """Whether there is work."""
    return db.scalar(select(Job.id).where(Job.state.in_(OPEN)).limit(1)) is not None


def refer_to(db: Session, name: str) -> bool:
    """Whether a job that is still to be done needs the clip or the pose with this id."""
    needs = cast(Job.request, Text).contains(name)
    return db.scalar(select(Job.id).where(Job.state.in_(OPEN), needs).limit(1)) is not None


def claim(db: Session) -> uuid.UUID | None:
    """Mark the next job running; None if there is none.

    Only who holds the lock of `app.persistence.locks` may ask: to it, a job that is running
    already is one that a killed server left behind.
    """
    query = select(Job.id).where(Job.state.in_(OPEN)).order_by(Job.state, Job.created_at, Job.id)
    job_id = db.scalar(query.limit(1))
    if job_id is None:
        return None
    waiting = update(Job).where(Job.id == job_id, Job.state == "waiting")
    db.execute(waiting.values(state="running", started_at=now()))
    return job_id


def kind(db: Session, job_id: uuid.UUID) -> str:
    """What a job does."""
    return db.scalars(select(Job.kind).where(Job.id == job_id)).one()


def is_running(db: Session, job_id: uuid.UUID) -> bool:
    """Whether the job is still to be worked at: nobody has cancelled it."""
    return db.scalar(select(Job.state).where(Job.id == job_id)) == "running"


def settle(db: Session, job_id: uuid.UUID, outcomes: Mapping[int, dict[str, Any]]) -> bool:
    """Write down what became of some items; false if the job was cancelled meanwhile.

    ``outcomes``: index of the item to ``{"clip": id, "error": None}`` or the other way round.
    """
    # Locked, so that whoever cancels comes before or after this, never in between.
    query = select(Job).options(defer(Job.request)).where(Job.id == job_id)
    job = db.scalar(query.with_for_update())
    if job is None or job.state != "running":
        return False
    items = list(job.items)
    for index, outcome in outcomes.items():
        items[index] = outcome
    job.items = items
    job.done = sum(item["clip"] is not None for item in items)
    job.failed = sum(item["error"] is not None for item in items)
    db.flush()
    return True


def advance(db: Session, job_id: uuid.UUID, done: int) -> bool:
    """Write down how much is done; false if the job was cancelled meanwhile."""
    running = update(Job).where(Job.id == job_id, Job.state == "running")
    return db.execute(running.values(done=done).returning(Job.id)).first() is not None


def conclude(db: Session, job_id: uuid.UUID, outcome: dict[str, Any]) -> bool:
    """Keep the one outcome of a job and end it; false if it was cancelled meanwhile."""
    running = update(Job).where(Job.id == job_id, Job.state == "running")
    values = running.values(items=[outcome], done=Job.total, state="done", ended_at=now())
    return db.execute(values.returning(Job.id)).first() is not None


def end(db: Session, job_id: uuid.UUID, state: str) -> bool:
    """Give an open job its last state; false if it had one already."""
    ended = update(Job).where(Job.id == job_id, Job.state.in_(OPEN))
    found = db.execute(ended.values(state=state, ended_at=now()).returning(Job.id))
    return found.first() is not None
