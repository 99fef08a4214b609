"""Opening the live page of a study with a million answers, on SQLite.

python -m tests.bench.live_rows
"""

from __future__ import annotations

import statistics
import sys
import tempfile
import time
import uuid
from datetime import UTC, datetime, timedelta
from pathlib import Path

import numpy as np
from sqlalchemy import insert
from starlette.testclient import TestClient

from app.main import create_app
from app.persistence import researchers, schema
from app.persistence.engine import Database, make_engine
from app.persistence.models import Response, Study, StudySession, StudyVersion
from app.persistence.writer import Writer
from app.schemas.study import StudyDefinition
from app.services import keys, studies, summaries
from app.services.plans import draw_plan, planned_steps
from app.settings import PROJECT, Settings
from app.studies import emotion
from tests.bench.measure import RUNS, Row
from tests.support.simulate import add_study

ANSWERS = 1_000_000
ADDRESS = f"/research/studies/{emotion.SLUG}/live"
AT_ONCE = 500  # participants in one insert
SCALES = [scale["id"] for scale in emotion.SCALES]


def rows(scratch: Path) -> list[Row]:
    """The whole page as the server makes it, catching up and charts included."""
    url = f"sqlite:///{scratch / 'live.sqlite3'}"
    count = fill(url, ANSWERS)
    summarise(url)
    times = opened(url)
    what = f"Live page of {count:,} answers, SQLite"
    spread = (min(times), max(times))
    return [Row(what, "ours", statistics.median(times), "ms", "≤ 300", spread)]


def opened(url: str) -> list[float]:
    """Milliseconds of each opening of the page, the first one of a fresh server left out."""
    settings = Settings(database_url=url, secret_key="x" * 40, log_level="error")
    built = PROJECT / "static" / "dist"
    with TestClient(create_app(settings, built)) as client:
        key = _key(client.app.state.database)
        times = []
        for _ in range(1 + RUNS):
            started = time.perf_counter()
            page = client.get(ADDRESS, headers={"authorization": f"Bearer {key}"})
            times.append(1000 * (time.perf_counter() - started))
            page.raise_for_status()
    return times[1:]


def _key(database: Database) -> str:
    with database.writing() as db:
        if researchers.by_email(db, "bench@example.org") is None:
            researchers.add(db, email="bench@example.org", name="Bench", password_hash="-")
        person = researchers.by_email(db, "bench@example.org")
        return keys.make(db, person.id, "bench", "read").secret


def summarise(url: str) -> float:
    """Seconds to make every summary anew, which the server does beside its work."""
    database = Database(make_engine(url))
    writer = Writer(database)
    started = time.perf_counter()
    while summaries.catch_up(database, writer):
        pass
    writer.close()
    database.engine.dispose()
    return time.perf_counter() - started


def fill(url: str, answers: int) -> int:
    """About so many answers, one participant in five leaving half-way; inserted without care."""
    database = Database(make_engine(url))
    schema.upgrade(database.engine)
    generator = np.random.default_rng(1)
    stored = number = 0
    with database.writing() as db:
        add_study(db)
        study = studies.find(db, emotion.SLUG)
        version = studies.newest(db, study)
        definition = studies.definition_of(version)
        while stored < answers:
            sessions = [_session(study, version, definition, number + i) for i in range(AT_ONCE)]
            given = [answer for one in sessions for answer in _answers(one, generator)]
            db.execute(insert(StudySession), sessions)
            db.execute(insert(Response), given)
            stored, number = stored + len(given), number + AT_ONCE
        db.commit()
    database.engine.dispose()
    return stored


def _session(
    study: Study, version: StudyVersion, definition: StudyDefinition, number: int
) -> dict[str, object]:
    began = datetime(2026, 1, 1, tzinfo=UTC) + timedelta(seconds=number)
    return {
        "id": uuid.UUID(int=(number * 0x9E3779B97F4A7C15) % 2**128), "study_id": study.id,
        "version_id": version.id, "token_hash": f"{number:064x}", "slot": number, "seed": number,
        "plan": draw_plan(definition, number, number, version.definition_hash),
        "state": "active" if number % 5 == 0 else "complete", "source": "open", "language": "en",
        "consent_version": "1", "consented_at": began, "completed_at": began,
        "user_agent_class": "phone", "created_at": began,
    }  # fmt: skip


def _answers(session: dict[str, object], generator: np.random.Generator) -> list[dict[str, object]]:
    steps = planned_steps(session["plan"])
    if session["state"] == "active":
        steps = steps[: generator.integers(1, len(steps))]
    began = session["consented_at"]
    values = generator.integers(-2, 3, (len(steps), len(SCALES))).tolist()
    times = generator.gamma(4, 2000, len(steps)).tolist()
    return [
        {
            "session_id": session["id"], "trial_index": index, "revision": 1, "part": step["part"],
            "trial_type": "semantic_differential", "clip_id": step["clips"][0],
            "clips": step["clips"], "practice": bool(step.get("practice")), "rt_ms": times[index],
            "answers": dict(zip(SCALES, values[index], strict=True)), "fingerprint": "0" * 64,
            "record": {"touched": SCALES, "plays": 2, "hidden_ms": 0.0, "viewing_ms": 4800.5},
            "received_at": began + timedelta(seconds=sum(times[: index + 1]) / 1000),
        }
        for index, step in enumerate(steps)
    ]  # fmt: skip


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        for row in rows(Path(sys.argv[1] if len(sys.argv) > 1 else folder)):
            print(f"{row.who}: {row.value:,.0f} {row.unit}, {row.spread}")
