"""The one thread that writes answers, as many as wait together in one durable commit.

A commit costs a write-through to the disk, about as long as thirty inserts. While one is under
way the next answers queue up, and the following commit takes them all: the busier the server, the
larger the groups. With one writer a process, no two threads fight over SQLite's write lock either.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future
from queue import Empty, SimpleQueue
from typing import Any, TypeVar

from sqlalchemy.exc import DBAPIError
from sqlalchemy.orm import Session

from app.persistence.engine import Database

GROUP = 64
T = TypeVar("T")


class _Waiting:
    """A job and the promise made to whoever handed it in."""

    def __init__(self, job: Callable[[Session], Any]) -> None:
        self.job = job
        self.promise: Future[Any] = Future()
        # From here on nobody can cancel: an answer that arrived is stored even if its sender left.
        self.promise.set_running_or_notify_cancel()
        self.outcome: Any = None
        self.fault: BaseException | None = None

    def settle(self) -> None:
        if self.fault is not None:
            self.promise.set_exception(self.fault)
        else:
            self.promise.set_result(self.outcome)


class Writer:
    """Runs jobs one after the other; each is acknowledged only after the commit that holds it.

    A job is a function of a database session that reads, decides and flushes. Jobs of one group
    are kept apart by savepoints: what one raises undoes that one alone and reaches only its caller.
    """

    def __init__(self, database: Database, group: int = GROUP) -> None:
        self._database = database
        self._group = group
        self._queue: SimpleQueue[_Waiting | None] = SimpleQueue()
        self._gate = threading.Lock()
        self._open = True
        self._thread = threading.Thread(target=self._work, name="writer", daemon=True)
        self._thread.start()

    def submit(self, job: Callable[[Session], T]) -> Future[T]:
        """Queue a job; the future is done once its commit is on the disk, or holds its error."""
        waiting = _Waiting(job)
        with self._gate:
            if not self._open:
                raise RuntimeError("The writer is closed: the server is shutting down.")
            self._queue.put(waiting)
        return waiting.promise

    def write(self, job: Callable[[Session], T]) -> T:
        """Queue a job and wait for it."""
        return self.submit(job).result()

    def close(self) -> None:
        """Take no more jobs, finish all that wait, and end."""
        with self._gate:
            if self._open:
                self._open = False
                self._queue.put(None)
        self._thread.join()

    def _work(self) -> None:
        while group := self._next_group():
            self._write(group)

    def _next_group(self) -> list[_Waiting]:
        """Wait for a job, then take what else is there; empty at the end."""
        first = self._queue.get()
        group = [first] if first else []
        while group and len(group) < self._group:
            try:
                more = self._queue.get_nowait()
            except Empty:
                break
            if more is None:  # the end: leave the mark for the next round
                self._queue.put(None)
                break
            group.append(more)
        return group

    def _write(self, group: list[_Waiting]) -> None:
        fault = self._try_commit(group)
        # A fault of the database itself (a unique key taken by another server process, a deadlock,
        # a lost connection) may be gone when the job runs again on its own.
        again = [waiting for waiting in group if fault or isinstance(waiting.fault, DBAPIError)]
        for waiting in again:
            waiting.fault = self._try_commit([waiting]) or waiting.fault
        for waiting in group:
            waiting.settle()

    def _try_commit(self, group: list[_Waiting]) -> BaseException | None:
        try:
            with self._database.writing() as session:
                for waiting in group:
                    _attempt(session, waiting)
                session.commit()
        except Exception as fault:  # whoever waits must learn of it, whatever it is
            return fault
        return None


def _attempt(session: Session, waiting: _Waiting) -> None:
    waiting.fault = None
    try:
        with session.begin_nested():
            waiting.outcome = waiting.job(session)
    except Exception as fault:  # its caller gets it
        if not session.in_transaction():  # the connection is gone, and with it the whole group
            raise
        waiting.fault = fault
