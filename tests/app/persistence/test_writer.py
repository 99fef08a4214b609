import threading
from functools import partial

import pytest
from sqlalchemy import event, func, select
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from app.errors import ConflictError
from app.persistence.engine import Database
from app.persistence.models import Blob
from app.persistence.writer import Writer


@pytest.fixture
def database(engine):
    return Database(engine)


@pytest.fixture
def writer(database):
    writer = Writer(database)
    yield writer
    writer.close()


def add(db, name):
    db.add(Blob(hash=name, media_type="text/plain", content=name.encode()))
    db.flush()
    return name


def stored(database):
    with database.reading() as db:
        return set(db.scalars(select(Blob.hash)))


def hold(writer):
    """Keep the writer busy until the returned event is set, so that what follows queues up."""
    begun, go_on = threading.Event(), threading.Event()

    def wait(_):
        begun.set()
        assert go_on.wait(20)

    promise = writer.submit(wait)
    assert begun.wait(20)
    return go_on, promise


def test_what_was_acknowledged_can_be_read_by_everybody(writer, database):
    assert writer.write(partial(add, name="one")) == "one"
    assert stored(database) == {"one"}


def test_jobs_that_wait_together_share_one_commit_and_none_is_acknowledged_before_it(
    writer, database
):
    go_on, holding = hold(writer)
    promises = [writer.submit(partial(add, name=f"job {i}")) for i in range(20)]
    commits = []

    def note(_):
        commits.append([promise.done() for promise in promises])

    event.listen(database.engine, "commit", note)
    go_on.set()
    holding.result(20)
    assert [promise.result(20) for promise in promises] == [f"job {i}" for i in range(20)]
    group = [done for done in commits if not all(done)]
    assert group[-1] == [False] * 20
    assert len(group) <= 2  # the holding job's own, and that of all the twenty
    assert len(stored(database)) == 20


def test_a_job_that_fails_undoes_itself_alone(writer, database):
    def add_then_fail(db):
        add(db, "undone")
        raise ConflictError("no")

    go_on, _ = hold(writer)
    before = writer.submit(partial(add, name="before"))
    failing = writer.submit(add_then_fail)
    after = writer.submit(partial(add, name="after"))
    go_on.set()
    assert (before.result(20), after.result(20)) == ("before", "after")
    with pytest.raises(ConflictError, match="no"):
        failing.result(20)
    assert stored(database) == {"before", "after"}


def test_a_job_that_breaks_a_constraint_harms_no_other_and_hears_of_it(writer, database):
    writer.write(partial(add, name="taken"))
    go_on, _ = hold(writer)
    promises = [writer.submit(partial(add, name=name)) for name in ("a", "taken", "b")]
    go_on.set()
    assert promises[0].result(20) == "a"
    assert promises[2].result(20) == "b"
    with pytest.raises(IntegrityError):
        promises[1].result(20)
    assert stored(database) == {"taken", "a", "b"}


def test_a_job_that_met_a_fault_of_the_database_runs_again_on_its_own(writer, database):
    tries = []

    def taken_at_first(db):
        # As if another server process had stored the same key a moment before.
        tries.append(1)
        name = "taken" if len(tries) == 1 else "free"
        return add(db, name)

    writer.write(partial(add, name="taken"))
    assert writer.write(taken_at_first) == "free"
    assert len(tries) == 2


def test_a_group_whose_commit_fails_is_run_again_one_by_one(writer, database, monkeypatch):
    go_on, holding = hold(writer)
    promises = [writer.submit(partial(add, name=name)) for name in ("a", "b")]
    commit, commits = Session.commit, []

    def fail_once(session):
        commits.append(len(commits))
        if len(commits) == 2:  # the first is the holding job's
            raise ConnectionError("the disk is gone")
        commit(session)

    monkeypatch.setattr(Session, "commit", fail_once)
    go_on.set()
    holding.result(20)
    assert [promise.result(20) for promise in promises] == ["a", "b"]
    assert len(commits) == 4
    assert stored(database) == {"a", "b"}


def test_closing_stores_what_waits_and_takes_no_more(database):
    writer = Writer(database)
    go_on, _ = hold(writer)
    promises = [writer.submit(partial(add, name=f"job {i}")) for i in range(100)]
    go_on.set()
    writer.close()
    assert all(promise.done() for promise in promises)
    assert len(stored(database)) == 100
    with pytest.raises(RuntimeError, match="shutting down"):
        writer.submit(partial(add, name="late"))


def test_many_threads_lose_nothing(writer, database):
    def work(thread):
        for i in range(20):
            writer.write(partial(add, name=f"{thread}/{i}"))

    threads = [threading.Thread(target=work, args=(number,)) for number in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    with database.reading() as db:
        assert db.scalar(select(func.count()).select_from(Blob)) == 160
