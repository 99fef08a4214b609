"""Two hundred participants at once, a fifth of whom leave half-way, on two server processes."""

from __future__ import annotations

import threading
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from datetime import timedelta
from functools import partial
from typing import Any

import pytest
from sqlalchemy import func, select, update

from app.persistence.engine import Database
from app.persistence.models import Response, StudySession
from app.persistence.writer import Writer
from app.services import answers, sessions
from tests.app.services.test_allocation import add
from tests.support.simulate import add_study, answer_with
from tests.support.taking_part import begin

CROWD = 200
PER_PERSON = 4  # of eight clips, in two groups
GROUPS = [{"id": "a", "label": "A"}, {"id": "b", "label": "B"}]
VALUES = {"sad_happy": 1, "weak_strong": -1}


@pytest.fixture
def database(engine):
    database = Database(engine)
    with database.writing() as db:
        add_study(db)
        add(db, number=8, subset=PER_PERSON, groups=GROUPS, order="latin_square")
        db.commit()
    return database


@pytest.fixture
def writers(database):
    """Two, as two server processes have them."""
    writers = [Writer(database), Writer(database)]
    yield writers
    for writer in writers:
        writer.close()


def take_part(writer: Writer, start: threading.Barrier, person: int, leaves: bool) -> int:
    """How many answers were acknowledged; each is sent twice, as after a lost acknowledgement."""
    start.wait()
    token = writer.write(partial(begin, slug="small"))
    acknowledged = 0
    for index in range(PER_PERSON // 2 if leaves else PER_PERSON):
        given: Any = answer_with(VALUES, index, rt_ms=float(person))
        receipts = [
            writer.write(partial(answers.record, token=token, answer=given)) for _ in range(2)
        ]
        acknowledged += sum(new for _, new in receipts)
        assert receipts[0][0] == receipts[1][0]
    if not leaves:
        writer.write(partial(sessions.complete, token=token))
    return acknowledged


def crowd(writers: list[Writer], people: int, leaving: int) -> int:
    start = threading.Barrier(people)
    with ThreadPoolExecutor(people) as pool:
        jobs = [
            pool.submit(take_part, writers[person % 2], start, person, person < leaving)
            for person in range(people)
        ]
        return sum(job.result() for job in jobs)


def test_every_acknowledged_answer_is_stored_and_the_complete_are_balanced(
    database: Database, writers: list[Writer]
) -> None:
    acknowledged = crowd(writers, CROWD, leaving=CROWD // 5)
    assert acknowledged == stored(database) == 160 * PER_PERSON + 40 * PER_PERSON // 2
    slots = column(database, select(StudySession.slot))
    assert sorted(slots) == list(range(CROWD))

    leases_run_out(database)
    acknowledged += crowd(writers, CROWD // 5, leaving=0)
    assert acknowledged == stored(database)
    done = StudySession.state == "complete"
    slots = column(database, select(StudySession.slot).where(done))
    assert sorted(slots) == list(range(CROWD))
    groups = Counter(column(database, select(StudySession.group).where(done)))
    assert groups == {"a": CROWD // 2, "b": CROWD // 2}
    clips = Counter(column(database, select(Response.clip_id).join(StudySession).where(done)))
    assert len(clips) == 8
    assert set(clips.values()) == {CROWD * PER_PERSON // 8}


def stored(database: Database) -> int:
    return column(database, select(func.count()).select_from(Response))[0]


def column(database: Database, query: Any) -> list[Any]:
    with database.reading() as db:
        return list(db.scalars(query))


def leases_run_out(database: Database) -> None:
    """As if whoever left had done so two hours ago."""
    with database.writing() as db:
        left = db.scalars(select(StudySession).where(StudySession.state == "active")).all()
        for session in left:
            session.created_at -= timedelta(hours=2)
            db.execute(
                update(Response)
                .where(Response.session_id == session.id)
                .values(received_at=session.created_at)
            )
        db.commit()
