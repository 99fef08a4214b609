"""Two server processes (here: two writers) that get the same session's answers at once."""

import threading
from functools import partial

import pytest
from sqlalchemy import select

from app.errors import ConflictError
from app.persistence.engine import Database
from app.persistence.models import Response
from app.persistence.writer import Writer
from app.services import answers, sessions
from tests.support.simulate import add_study, answer_with
from tests.support.taking_part import NEUTRAL, begin

OTHER = NEUTRAL | {"sad_happy": 2}


@pytest.fixture
def database(engine):
    database = Database(engine)
    with database.writing() as db:
        add_study(db)
    return database


@pytest.fixture
def writers(database):
    writers = [Writer(database), Writer(database)]
    yield writers
    for writer in writers:
        writer.close()


def at_once(writers, *jobs):
    """Hand each job to a writer of its own at the same moment; results or errors."""
    start, outcomes = threading.Barrier(len(jobs)), [None] * len(jobs)

    def run(place):
        start.wait()
        try:
            outcomes[place] = writers[place].write(jobs[place])
        except ConflictError as error:
            outcomes[place] = error

    threads = [threading.Thread(target=run, args=(place,)) for place in range(len(jobs))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return outcomes


def test_the_same_answer_twice_at_once_is_stored_once_and_acknowledged_twice(database, writers):
    token = writers[0].write(begin)
    for index in range(10):
        job = partial(answers.record, token=token, answer=answer_with(NEUTRAL, index))
        (one, first), (other, second) = at_once(writers, job, job)
        assert one == other
        assert {first, second} == {True, False}
    with database.reading() as db:
        assert sorted(db.scalars(select(Response.trial_index))) == list(range(10))


def test_of_two_different_answers_at_once_one_is_stored_and_the_other_is_told(database, writers):
    token = writers[0].write(begin)
    for index in range(10):
        outcomes = at_once(
            writers,
            partial(answers.record, token=token, answer=answer_with(NEUTRAL, index)),
            partial(answers.record, token=token, answer=answer_with(OTHER, index)),
        )
        (refused,) = [outcome for outcome in outcomes if isinstance(outcome, ConflictError)]
        assert refused.code == "already_answered"
        with database.reading() as db:
            (row,) = db.scalars(select(Response).where(Response.trial_index == index))
        assert refused.extra["stored"]["answers"] == row.answers


def test_an_answer_and_a_withdrawal_at_once_leave_no_answer_behind(database, writers):
    for _ in range(10):
        token = writers[0].write(begin)
        outcomes = at_once(
            writers,
            partial(answers.record, token=token, answer=answer_with(NEUTRAL)),
            partial(sessions.withdraw, token=token),
        )
        if isinstance(outcomes[0], ConflictError):
            assert outcomes[0].code == "session_withdrawn"
        with database.reading() as db:
            assert db.scalars(select(Response)).all() == []
