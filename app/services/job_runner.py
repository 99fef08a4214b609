"""The server's one thread for jobs: takes them in their order and sees each through.

Of all servers that share a database only one works at jobs, the one that holds the lock. When it
ends, however it ends, another takes the lock and goes on with what it finds running.
"""

from __future__ import annotations

import threading
import time
from uuid import UUID

import structlog

from app.persistence import jobs
from app.persistence.engine import Database
from app.persistence.locks import job_lock
from app.persistence.writer import Writer
from app.services.batch_run import BatchRun
from app.services.impression_run import BootstrapRun
from app.services.job_pool import JobPool

LOOK_EVERY = 2.0  # seconds; for jobs that came in at other servers
IDLE = 20.0  # seconds until the pool's processes end: they hold 100 MB each

RUNS: dict[str, type[BatchRun | BootstrapRun]] = {"clips": BatchRun, "stability": BootstrapRun}

log = structlog.get_logger("manner")


class JobRunner:
    """Works at jobs in the background until it is closed."""

    def __init__(self, database: Database, writer: Writer, pool: JobPool) -> None:
        self._database = database
        self._writer = writer
        self._pool = pool
        self._busy_at = time.monotonic()
        self._wanted = threading.Event()
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._work, name="jobs", daemon=True)
        self._thread.start()

    def wake(self) -> None:
        """Look for work now: a job has just come in."""
        self._wanted.set()

    def close(self) -> None:
        """End. A job under way goes on at the next start."""
        self._closing.set()
        self.wake()
        self._thread.join()

    def _work(self) -> None:
        while not self._closing.is_set():
            self._wanted.clear()
            try:
                self._work_off()
            except Exception:  # the database may be away; the next look may find it again
                log.exception("jobs cannot be worked at")
            self._wanted.wait(LOOK_EVERY)
        self._pool.close()

    def _work_off(self) -> None:
        with self._database.reading() as db:
            is_work = jobs.any_open(db)
        if is_work:
            with job_lock(self._database.engine) as held:
                while held and (job_id := self._next()):
                    self._run(job_id)
                    self._busy_at = time.monotonic()
        if time.monotonic() - self._busy_at > IDLE:
            self._pool.close()

    def _next(self) -> UUID | None:
        return None if self._closing.is_set() else self._writer.write(jobs.claim)

    def _run(self, job_id: UUID) -> None:
        with self._database.reading() as db:
            run_of = RUNS[jobs.kind(db, job_id)]
        run = run_of(self._database, self._writer, self._pool, job_id, self._closing.is_set)
        try:
            run.run()
        except Exception:
            # Left running it would be taken up again and again, and hold up all others.
            log.exception("a job failed", job=str(job_id))
            self._writer.write(lambda db: jobs.end(db, job_id, "failed"))
