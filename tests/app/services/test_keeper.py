from __future__ import annotations

import threading

import numpy as np
import pytest
from sqlalchemy import Engine

from app.persistence.engine import Database
from app.persistence.models import SessionSummary
from app.persistence.writer import Writer
from app.services import keeper, retention, summaries
from tests.support import simulate


def test_the_keeper_summarises_and_sweeps_by_itself_and_outlives_a_fault(
    engine: Engine, monkeypatch: pytest.MonkeyPatch
) -> None:
    database = Database(engine)
    writer = Writer(database)
    with database.writing() as db:
        simulate.add_study(db)
    simulate.take_part(writer.write, np.random.default_rng(1), answered=3)
    catch_up, faults = summaries.catch_up, [RuntimeError("the database is away")]
    swept = threading.Event()

    def first_fails(*args: object) -> bool:
        if faults:
            raise faults.pop()
        return catch_up(*args)

    monkeypatch.setattr(keeper, "EVERY", 0.01)
    monkeypatch.setattr(summaries, "catch_up", first_fails)
    monkeypatch.setattr(retention, "sweep", lambda *_: swept.set() or 0)
    kept = keeper.Keeper(database, writer)
    assert swept.wait(60)
    kept.close()
    writer.close()
    with database.reading() as db:
        assert [one.answered for one in db.query(SessionSummary)] == [3]
