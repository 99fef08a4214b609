"""One large bootstrap from its first piece to its result, as a job.

While it runs only its progress is written down: answers may be deleted meanwhile, and what a killed
server had computed is computed again in seconds.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from uuid import UUID

from sqlalchemy.orm import Session

from app.persistence import jobs
from app.persistence.engine import Database
from app.persistence.writer import Writer
from app.schemas.impressions import Stability
from app.services.impression_bootstrap import Order, combined, piece
from app.services.impression_stability import Asked, prepared, told
from app.services.job_pool import JobPool
from app.statistics.stability import BySize, Drawn

TICK = 0.25  # seconds between looks at whether somebody has cancelled


class BootstrapRun:
    """The run of a job of kind ``stability``.

    Args:
        leave: whether the server is about to end, so that the job is left for the next start.
    """

    def __init__(
        self,
        database: Database,
        writer: Writer,
        pool: JobPool,
        job_id: UUID,
        leave: Callable[[], bool],
    ) -> None:
        self._database = database
        self._writer = writer
        self._pool = pool
        self._job_id = job_id
        self._leave = leave

    def run(self) -> None:
        """Compute it, until all is done or somebody cancels.

        Raises:
            NotFoundError, InvalidError: the study, its part or its clusters are gone meanwhile.
            BrokenExecutor: a process died, as for lack of memory.
        """
        with self._database.reading() as db:
            job = jobs.by_id(db, self._job_id)
            assert job is not None  # noqa: S101 -- jobs are never deleted
            found, order = prepared(db, Asked.of(job))
        try:
            pieces = self._pieces(order)
        except BrokenExecutor:
            self._pool.close()  # a broken one takes no more work
            raise
        if pieces is not None:
            outcome = told(found, order, combined(pieces))
            self._writer.write(lambda db: self._keep(db, outcome))

    def _pieces(self, order: Order) -> list[Drawn | BySize] | None:
        """All pieces in their order; None if it is not to go on."""
        waiting = list(reversed(range(order.pieces)))
        under_way: dict[Future[Drawn | BySize], int] = {}
        done: dict[int, Drawn | BySize] = {}
        while len(done) < order.pieces:
            if not self._goes_on(len(done)):
                for future in under_way:
                    future.cancel()
                return None
            while waiting and len(under_way) < self._pool.ahead:
                number = waiting.pop()
                under_way[self._pool.submit(piece, order, number)] = number
            ready, _ = wait(under_way, timeout=TICK, return_when=FIRST_COMPLETED)
            for future in ready:
                done[under_way.pop(future)] = future.result()
        return [done[number] for number in range(order.pieces)]

    def _goes_on(self, done: int) -> bool:
        """Write down how far it is, if it is still wanted."""
        return not self._leave() and self._writer.write(
            lambda db: jobs.advance(db, self._job_id, done)
        )

    def _keep(self, db: Session, outcome: Stability) -> None:
        jobs.conclude(db, self._job_id, outcome.model_dump(mode="json"))
