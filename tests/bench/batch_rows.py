"""A thousand small clips at once: what two processors give over one."""

from __future__ import annotations

import os
import time
from pathlib import Path

from app.persistence import schema
from app.persistence.engine import Database, make_engine
from app.persistence.writer import Writer
from app.schemas.jobs import Batch
from app.services import batches, samples
from app.services.job_pool import JobPool
from app.services.job_runner import JobRunner
from tests.bench.measure import Row
from tests.support.motions import walks

CLIPS = 1000
RUNS = 3
AMOUNTS = ({"path": 0.4, "timing": 1.6}, {"path": 1.6, "timing": 2.0}, {"path": 1.8, "timing": 1.4})


def rows(scratch: Path) -> list[Row]:
    """Clips a second on all processors and on one, storing included, and the ratio."""
    both, one = [], []
    for run in range(RUNS):
        for speeds, processors in ((both, None), (one, 1)):
            folder = scratch / f"{run}-{processors}"
            folder.mkdir()
            speeds.append(speed(folder, processors))
    what = f"Batch of {CLIPS} walks"
    ratios = [fast / slow for fast, slow in zip(both, one, strict=True)]
    return [
        _row(what, "all processors", both, "clips/s"),
        _row(what, "one processor", one, "clips/s"),
        _row(what, "ratio", ratios, "×", "≥ 1.7"),
    ]


def speed(folder: Path, processors: int | None) -> float:
    """Clips a second, from the request to the last commit, on a SQLite of its own.

    ``processors`` is 1 for a machine that has one for everything, computing and storing.
    """
    allowed = os.sched_getaffinity(0)
    if processors:  # the runner's threads and processes inherit it
        os.sched_setaffinity(0, sorted(allowed)[:processors])
    database = Database(make_engine(f"sqlite:///{folder / 'bench.sqlite3'}"))
    schema.upgrade(database.engine)
    samples.make(database, walks)
    writer = Writer(database)
    runner = JobRunner(database, writer, JobPool(processes=processors))
    try:
        _wait(database, runner, batch(64, start=CLIPS))  # the processes load their code
        started = time.perf_counter()
        _wait(database, runner, batch(CLIPS))
        return CLIPS / (time.perf_counter() - started)
    finally:
        runner.close()
        writer.close()
        database.engine.dispose()
        os.sched_setaffinity(0, allowed)


def batch(clips: int, start: int = 0) -> Batch:
    """Presets' edits of three walks in turn, each with another amount of head down."""
    items = []
    for number in range(start, start + clips):
        posture = {"pose": "head_down", "amount": round(number / 2000, 4)}
        operations = [
            {"operation": "grid@1", "parameters": AMOUNTS[number % len(AMOUNTS)]},
            {"operation": "posture@1", "parameters": {"offsets": [posture]}},
        ]
        source = walks()[number % 3].clip.content_hash
        items.append({"source": source, "operations": operations, "name": f"walk {number}"})
    return Batch.model_validate({"items": items})


def _wait(database: Database, runner: JobRunner, wanted: Batch) -> None:
    with database.writing() as db:
        job = batches.submit(db, None, wanted)
    runner.wake()
    while job.ended_at is None:
        time.sleep(0.05)
        with database.reading() as db:
            job = batches.find(db, job.id)
    if job.done != len(job.items):
        raise RuntimeError(next(item.error for item in job.items if item.error))


def _row(what: str, who: str, values: list[float], unit: str, aim: str = "") -> Row:
    return Row(what, who, sorted(values)[len(values) // 2], unit, aim, (min(values), max(values)))
