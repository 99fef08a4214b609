"""One job from its first clip to its last.

The work is cut into chunks that share a source, so that the process that takes one parses the
source and computes its nine motions once. A few chunks are under way at any time; what comes back
is stored at once, a chunk in a transaction. A clip that is in the library already, also because an
earlier server made it before it was killed, is found by its id and not made again.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING, Any
from uuid import UUID

import structlog
from sqlalchemy.orm import Session

from app.persistence import blobs, clips, jobs
from app.persistence.engine import Database
from app.persistence.writer import Writer
from app.schemas.edits import Edit
from app.services import edits
from app.services.job_pool import JobPool

if TYPE_CHECKING:  # it brings SciPy, for which the server's start shall not wait
    from app.services.batch_work import Failure
    from app.services.clip_files import ClipFiles
    from motion.recipe import Recipe

CHUNK = 16  # clips
CHUNK_FRAMES = 2_000  # fewer clips of a longer source, so that much of it is kept soon
TICK = 0.25  # seconds between looks at whether somebody has cancelled
DIED = "The computation broke off, probably for lack of memory. Cut the clip shorter first."

log = structlog.get_logger("manner")
Outcome = dict[str, Any]


@dataclass(frozen=True)
class Chunk:
    """Items of one source by their index; ``alone`` after their process has died once."""

    source: str
    indices: tuple[int, ...]
    alone: bool = False


class BatchRun:
    """The run of a job of kind ``clips``.

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
        self._under_way: dict[Future[list[ClipFiles | Failure]], Chunk] = {}
        self._orders: list[dict[str, Any]] = []
        self._kept = True

    def run(self) -> None:
        """Make what is still to be made, until all is done or somebody cancels."""
        waiting = self._chunks()
        while (waiting or self._under_way) and self._goes_on():
            while waiting and self._has_room_for(waiting[0]):
                self._start(waiting.popleft())
            ready, _ = wait(self._under_way, timeout=TICK, return_when=FIRST_COMPLETED)
            for future in ready:
                waiting.extendleft(self._finish(future, self._under_way.pop(future)))
        for future in self._under_way:
            future.cancel()
        if not self._leave():
            self._writer.write(self._end)

    def _goes_on(self) -> bool:
        with self._database.reading() as db:
            return self._kept and not self._leave() and jobs.is_running(db, self._job_id)

    def _chunks(self) -> deque[Chunk]:
        with self._database.reading() as db:
            job = jobs.by_id(db, self._job_id)
            assert job is not None  # noqa: S101 -- jobs are never deleted
            self._orders = job.request["items"]
            open_ = [i for i, item in enumerate(job.items) if not any(item.values())]
            by_source = sorted(open_, key=lambda i: self._orders[i]["source"])
            found: deque[Chunk] = deque()
            for source, indices in groupby(by_source, key=lambda i: self._orders[i]["source"]):
                clip = clips.by_id(db, source)
                size = max(1, min(CHUNK, CHUNK_FRAMES // clip.frames)) if clip else CHUNK
                found.extend(Chunk(source, part) for part in _parts(list(indices), size))
        return found

    def _has_room_for(self, chunk: Chunk) -> bool:
        """A chunk that may have killed its process gets the pool for itself."""
        if chunk.alone or any(other.alone for other in self._under_way.values()):
            return not self._under_way
        return len(self._under_way) < self._pool.ahead

    def _start(self, chunk: Chunk) -> None:
        """Settle what needs no work, hand the rest to the pool."""
        from app.services.batch_work import render_all

        outcomes: dict[int, Outcome] = {}
        work = []
        with self._database.reading() as db:
            ids = {i: edits.edited_id(chunk.source, self._recipe(i)) for i in chunk.indices}
            there = clips.present(db, ids.values())
            outcomes = {i: _made(ids[i]) for i in chunk.indices if ids[i] in there}
            rest = tuple(i for i in chunk.indices if i not in outcomes)
            source = clips.by_id(db, chunk.source)
            content = blobs.content(db, source.clip_blob) if source else None
            if source is None or content is None:
                outcomes |= {i: _failed("Its source was deleted meanwhile.") for i in rest}
                rest = ()
            for i in rest:
                work.append((self._orders[i]["operations"], edits.materials(db, self._recipe(i))))
        if outcomes:
            self._settle(lambda db: outcomes)
        if rest and source and content:
            future = self._pool.submit(render_all, content, source.stature, work)
            self._under_way[future] = Chunk(chunk.source, rest, chunk.alone)

    def _finish(self, future: Future[list[ClipFiles | Failure]], chunk: Chunk) -> list[Chunk]:
        """Store what a chunk has given; the chunks to try again if its process died."""
        try:
            results = future.result()
        except Exception as fault:  # of the pool or the cluster: our own come back as failures
            log.warning("a chunk of a job broke off", job=str(self._job_id), fault=repr(fault))
            if isinstance(fault, BrokenExecutor):
                self._pool.close()  # a broken one takes no more work
            if chunk.alone:
                self._settle(lambda db: {i: _failed(DIED) for i in chunk.indices})
                return []
            return [Chunk(chunk.source, (i,), alone=True) for i in reversed(chunk.indices)]
        self._settle(lambda db: self._store(db, chunk, results))
        return []

    def _settle(self, outcomes: Callable[[Session], dict[int, Outcome]]) -> None:
        """Write down outcomes together with what they tell of; nothing once it is cancelled."""

        def write(db: Session) -> bool:
            return jobs.is_running(db, self._job_id) and jobs.settle(db, self._job_id, outcomes(db))

        self._kept = self._writer.write(write) and self._kept

    def _store(
        self, db: Session, chunk: Chunk, results: list[ClipFiles | Failure]
    ) -> dict[int, Outcome]:
        from app.services.batch_work import Failure

        source = clips.by_id(db, chunk.source)
        outcomes: dict[int, Outcome] = {}
        for index, result in zip(chunk.indices, results, strict=True):
            if isinstance(result, Failure):
                if result.trace:
                    log.error("a clip of a job failed", job=str(self._job_id), trace=result.trace)
                outcomes[index] = _failed(result.message)
            elif source is None:
                outcomes[index] = _failed("Its source was deleted meanwhile.")
            else:
                order = self._orders[index]
                clip = edits.store(
                    db, result, source, self._recipe(index), order["name"], order["tags"]
                )
                outcomes[index] = _made(clip.id)
        return outcomes

    def _recipe(self, index: int) -> Recipe:
        order = self._orders[index]
        return edits.read_recipe(Edit(source=order["source"], operations=order["operations"]))

    def _end(self, db: Session) -> None:
        job = jobs.by_id(db, self._job_id)
        if job is not None:
            jobs.end(db, self._job_id, "failed" if job.failed == job.total else "done")


def _parts(indices: list[int], size: int) -> Iterator[tuple[int, ...]]:
    return (tuple(indices[i : i + size]) for i in range(0, len(indices), size))


def _made(clip_id: str) -> Outcome:
    return {"clip": clip_id, "error": None}


def _failed(message: str) -> Outcome:
    return {"clip": None, "error": message}
