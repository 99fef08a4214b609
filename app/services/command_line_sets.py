"""Sets of clips made from the command line, by the same jobs as from the page."""

from __future__ import annotations

import time
from collections.abc import Callable

from sqlalchemy.orm import Session

from app.persistence.engine import Database
from app.persistence.writer import Writer
from app.schemas.jobs import Batch, JobDetail, Plan
from app.services import batches, sets
from app.services.job_pool import JobPool
from app.services.job_runner import JobRunner

SETS: dict[str, Callable[[Session], Plan]] = {"foerger": sets.foerger}
LOOK_EVERY = 0.2  # seconds


def make(
    database: Database,
    planned: Callable[[Session], Plan],
    on_progress: Callable[[int, int], None],
    scheduler: str = "",
) -> JobDetail:
    """Make what is planned and wait for it; the job at its end.

    A server that runs beside us may do the work instead: whoever holds the lock. Whoever
    interrupts the command cancels the job; what it has made stays.
    """
    with database.writing() as db:
        job = batches.submit(db, None, Batch(items=sets.as_requests(planned(db))))
    writer = Writer(database)
    runner = JobRunner(database, writer, JobPool(scheduler))
    try:
        while job.ended_at is None:
            time.sleep(LOOK_EVERY)
            with database.reading() as db:
                job = batches.find(db, job.id)
            on_progress(job.done + job.failed, job.total)
    except KeyboardInterrupt:
        with database.writing() as db:
            batches.cancel(db, job.id)
        raise
    finally:
        runner.close()
        writer.close()
    return job
