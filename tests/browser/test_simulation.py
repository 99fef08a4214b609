"""A simulated participant in a real browser."""

from __future__ import annotations

import numpy as np
import pytest
from sqlalchemy import select

from app.persistence.engine import Database, make_engine
from app.persistence.models import Response, StudySession
from app.services import browser_simulation
from app.services.command_line_simulation import planned
from tests.browser.every_kind import SLUG, add_every_kind
from tests.support.server import Server

pytestmark = pytest.mark.browser


def test_it_answers_every_kind_by_the_pages_own_controls(server: Server):
    definition = add_every_kind(server.data_directory)
    database = Database(make_engine(f"sqlite:///{server.data_directory / 'manner.sqlite3'}"))
    told: list[int] = []
    (course,) = browser_simulation.run(
        database, planned(database, SLUG, None), 1, 1, server.url, np.random.default_rng(1),
        told.append,
    )  # fmt: skip
    assert course.complete
    assert told == [1]
    with database.reading() as db:
        rows = db.execute(select(Response, StudySession).join(StudySession)).all()
        stored = {row.part: row for row, _ in rows if row.check is None}
        states = {(person.kind, person.state) for _, person in rows}
        checks = [row.passed for row, _ in rows if row.check is not None]
    database.engine.dispose()
    assert states == {("simulated", "complete")}
    assert set(checks) == {True}
    assert set(stored) == {part.id for part in definition.parts}
    assert {part: row.answers for part, row in course.counted} == {
        part: stored[part].answers for part, _ in course.counted
    }
    for part in definition.trials:  # as only a page that drew and timed the figures can tell
        assert stored[part.id].record["viewing_ms"] > 0
