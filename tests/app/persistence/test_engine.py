"""SQLite and PostgreSQL behave alike where it matters."""

from __future__ import annotations

import threading
from datetime import UTC, datetime, timedelta, timezone

import pytest
from anyio.from_thread import start_blocking_portal
from anyio.to_thread import current_default_thread_limiter
from sqlalchemy import Engine, text
from sqlalchemy.exc import IntegrityError, StatementError
from sqlalchemy.orm import Session
from sqlalchemy.pool import QueuePool

from app.persistence import blobs
from app.persistence.engine import Database, make_engine
from app.persistence.models import FigureRecord, SetupToken


@pytest.mark.parametrize("database_kind", ["sqlite"], indirect=True)
def test_sqlite_survives_a_power_cut_and_checks_references(engine: Engine) -> None:
    with engine.connect() as connection:
        pragmas = {
            name: connection.exec_driver_sql(f"PRAGMA {name}").scalar()
            for name in ("journal_mode", "synchronous", "foreign_keys")
        }
    assert pragmas == {"journal_mode": "wal", "synchronous": 2, "foreign_keys": 1}


@pytest.mark.parametrize("url", ["sqlite:///nowhere", "postgresql+psycopg://nobody@nowhere/none"])
def test_every_thread_that_answers_can_hold_a_connection_and_some_are_left(url: str) -> None:
    async def threads() -> float:
        return current_default_thread_limiter().total_tokens

    pool = make_engine(url).pool
    assert isinstance(pool, QueuePool)
    with start_blocking_portal() as portal:  # a loop of its own: this thread may have one already
        answering = portal.call(threads)
    assert pool.size() + pool._max_overflow >= answering + 8


def test_writers_that_read_first_wait_for_each_other(engine: Engine) -> None:
    database = Database(engine)
    with database.writing() as db:
        db.add(SetupToken(token_hash="0"))
        db.commit()
    faults: list[Exception] = []

    def add_one() -> None:
        try:
            for _ in range(10):
                with database.writing() as db:
                    row = db.get(SetupToken, "0", with_for_update=True)
                    assert row is not None
                    count = (row.created_at - EPOCH) // timedelta(seconds=1)
                    row.created_at = EPOCH + timedelta(seconds=count + 1)
                    db.commit()
        except Exception as fault:
            faults.append(fault)

    with database.writing() as db:
        db.get_one(SetupToken, "0").created_at = EPOCH
        db.commit()
    threads = [threading.Thread(target=add_one) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert faults == []
    with database.reading() as db:
        assert db.get_one(SetupToken, "0").created_at == EPOCH + timedelta(seconds=40)


EPOCH = datetime(2026, 1, 1, tzinfo=UTC)


def test_a_reader_is_not_held_up_by_a_writer(engine: Engine) -> None:
    database = Database(engine)
    with database.writing() as writing, database.reading() as reading:
        writing.add(SetupToken(token_hash="1"))
        writing.flush()
        assert reading.get(SetupToken, "1") is None
        writing.commit()
    with database.reading() as reading:
        assert reading.get(SetupToken, "1") is not None


def test_references_are_checked(db: Session) -> None:
    db.add(FigureRecord(skeleton_hash="s", glb_blob="missing", engine_version="1"))
    with pytest.raises(IntegrityError):
        db.flush()


def test_times_come_back_as_utc_and_need_a_zone(db: Session) -> None:
    east = timezone(timedelta(hours=5))
    db.add(SetupToken(token_hash="t", created_at=datetime(2026, 3, 1, 4, 30, tzinfo=east)))
    db.commit()
    db.expire_all()
    stored = db.get_one(SetupToken, "t").created_at
    assert stored == datetime(2026, 2, 28, 23, 30, tzinfo=UTC)
    assert stored.utcoffset() == timedelta(0)
    db.add(SetupToken(token_hash="naive", created_at=datetime(2026, 3, 1)))
    with pytest.raises(StatementError, match="time zone"):
        db.flush()


def test_the_same_bytes_are_stored_once(db: Session) -> None:
    first = blobs.put(db, b"motion", blobs.GLB)
    assert blobs.put(db, b"motion", blobs.GLB) == first
    assert blobs.content(db, first) == b"motion"
    assert blobs.content(db, first, blobs.BVH) is None
    assert db.scalar(text("SELECT count(*) FROM blobs")) == 1


def test_an_error_message_holds_no_values(engine: Engine) -> None:
    database = Database(engine)
    with database.writing() as db:
        db.add_all([SetupToken(token_hash="secret"), SetupToken(token_hash="secret")])
        with pytest.raises(IntegrityError) as caught:
            db.flush()
    assert "[SQL parameters hidden" in str(caught.value)
