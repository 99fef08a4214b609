"""A million answers through every export: how fast, and how much memory it takes.

    python -m tests.bench.export_rows

Each export runs in a process of its own, so that its peak of resident memory is its own.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
import uuid
from collections.abc import Callable, Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path

import numpy as np
from sqlalchemy import insert

from app.persistence import schema
from app.persistence.engine import Database, make_engine
from app.persistence.models import Response, StudySession, StudyVersion
from app.services import exports, psych_ds, studies
from app.services.exports import Exported
from app.studies import emotion
from tests.bench.measure import Row
from tests.support.simulate import add_study

ANSWERS = 1_000_000
AT_ONCE = 500  # participants in one insert
EXPORTS: dict[str, Callable[[Exported], Iterator[str] | Iterator[bytes]]] = {
    "long CSV": exports.responses_csv,
    "wide CSV": exports.wide_csv,
    "JSON lines": exports.responses_jsonl,
    "Psych-DS": psych_ds.dataset_zip,
}


def rows(scratch: Path) -> list[Row]:
    """Answers a second and megabytes of growth, of each export."""
    url = f"sqlite:///{scratch / 'exports.sqlite3'}"
    count = fill(url, ANSWERS)
    what = f"Export of {count:,} answers"
    found = []
    for name in EXPORTS:
        seconds, growth = _apart(url, name)
        found.append(Row(what, f"{name}, memory", growth, "MB", "≤ 150"))
        found.append(Row(what, name, count / seconds, "answers/s"))
    return found


def fill(url: str, answers: int) -> int:
    """At least so many answers by complete participants, inserted without the services' care."""
    database = Database(make_engine(url))
    schema.upgrade(database.engine)
    with database.writing() as db:
        definition = add_study(db)
        version = studies.newest(db, studies.find(db, emotion.SLUG))
        (part,) = definition.trials
        clips = [stimulus.clip for stimulus in part.stimuli]
        trials = [*clips[: part.practice], *clips]
        people = -(-answers // len(trials))
        generator = np.random.default_rng(1)
        for start in range(0, people, AT_ONCE):
            chosen = range(start, min(start + AT_ONCE, people))
            sessions = [_session(version, number) for number in chosen]
            db.execute(insert(StudySession), sessions)
            db.execute(
                insert(Response),
                [
                    _answer(session["id"], index, clip, part.practice, generator)
                    for session in sessions
                    for index, clip in enumerate(trials)
                ],
            )
        db.commit()
    database.engine.dispose()
    return people * len(trials)


def _session(version: StudyVersion, number: int) -> dict[str, object]:
    began = datetime(2026, 1, 1, tzinfo=UTC) + timedelta(seconds=number)
    return {
        "id": uuid.UUID(int=number), "study_id": version.study_id, "version_id": version.id,
        "slot": number, "token_hash": f"{number:064x}",
        "seed": number, "state": "complete", "consent_version": "1", "consented_at": began,
        "completed_at": began, "user_agent_class": "phone", "created_at": began,
    }  # fmt: skip


def _answer(
    session: object, index: int, clip: str, practice: int, generator: np.random.Generator
) -> dict[str, object]:
    drawn = generator.integers(-2, 3, 6).tolist()
    values = {scale["id"]: value for scale, value in zip(emotion.SCALES, drawn, strict=True)}
    return {
        "session_id": session, "trial_index": index, "revision": 1, "clip_id": clip,
        "part": "emotions", "trial_type": "semantic_differential", "clips": [clip],
        "practice": index < practice, "answers": values, "rt_ms": 5000.5, "fingerprint": "0" * 64,
        "comment": "seems to look for something" if index % 5 == 0 else "",
        "record": {
            "touched": sorted(values), "time_elapsed_ms": 61000.25, "plays": 2,
            "viewing_ms": 4800.5, "camera_moves": 1, "hidden_ms": 0.0, "blur_count": 0,
            "dropped_frames": 0, "tier": "high", "client_time": "2026-03-01T12:00:00Z",
            "viewport": {"width": 1280, "height": 800, "pixel_ratio": 1.0},
        },
    }  # fmt: skip


def _apart(url: str, name: str) -> tuple[float, float]:
    done = subprocess.run(
        [sys.executable, "-m", "tests.bench.export_rows", url, name],
        env={**os.environ}, capture_output=True, text=True, check=True,
    )  # fmt: skip
    seconds, growth = json.loads(done.stdout)
    return seconds, growth


def measure(url: str, name: str) -> tuple[float, float]:
    """Seconds, and MB by which the peak of resident memory lies above that before the export."""
    database = Database(make_engine(url))
    found = exports.exported(database, emotion.SLUG)  # what the server has loaded anyway
    before, started = _resident(), time.perf_counter()
    for _ in EXPORTS[name](found):
        pass
    return time.perf_counter() - started, _peak() - before


def _resident() -> float:
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize() / 1e6


def _peak() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 1e6


if __name__ == "__main__":
    if len(sys.argv) == 3:
        print(json.dumps(measure(*sys.argv[1:])))
    else:
        with tempfile.TemporaryDirectory() as folder:
            for row in rows(Path(folder)):
                print(f"{row.who}: {row.value:,.0f} {row.unit}")
