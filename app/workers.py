"""Processes that compute motions while the server's own process stays free for requests.

Each worker is one process that keeps what it has parsed and computed of the last clips. Work on
the same clip therefore goes to the worker that knows it, unless that one is busy and another idle.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from multiprocessing.connection import Connection
from typing import Any, ParamSpec, TypeVar
from zlib import crc32

from app.errors import BusyError, InvalidError

SECONDS = 60.0  # the longest that one piece of work may take
WAITING = 24  # pieces of work at once; more would take every thread from the other requests
P = ParamSpec("P")
T = TypeVar("T")

# Spawned, not forked: a forked child would inherit open database connections and locks.
_context = multiprocessing.get_context("spawn")


class Workers:
    """As many processes as there are processors, each started when it is first needed.

    Args:
        count: number of processes; None for one a processor.
        seconds: how long one piece of work may take.
        module: what a process imports first, so that its first work need not wait for it.
    """

    def __init__(
        self, count: int | None = None, seconds: float = SECONDS, module: str = "app.workers"
    ) -> None:
        self._workers = [_Worker(seconds, module) for _ in range(count or os.cpu_count() or 1)]
        self._gate = threading.Lock()
        self._waiting = threading.BoundedSemaphore(WAITING)

    def start(self) -> None:
        """Start the processes, without waiting until they are ready."""
        for worker in self._workers:
            worker.start()

    def run(self, key: str, function: Callable[P, T], *args: P.args, **more: P.kwargs) -> T:
        """What a function gives, computed in the worker that knows ``key``.

        Args:
            key: what the work is about, such as a clip's id.
            function: at the top level of a module.
            *args: what it takes; like the result, they travel pickled.
            **more: what it takes by name.

        Raises:
            InvalidError: it took too long.
            BusyError: too many wait already, or the process died twice, as for lack of memory.
            Exception: whatever the function raises.
        """
        if not self._waiting.acquire(blocking=False):
            raise BusyError("Many motions are being computed at this moment.")
        try:
            with self._chosen(key) as worker:
                return worker.run(partial(function, *args, **more))
        finally:
            self._waiting.release()

    def close(self) -> None:
        """End all processes."""
        for worker in self._workers:
            worker.close()

    @contextmanager
    def _chosen(self, key: str) -> Iterator[_Worker]:
        home = self._workers[crc32(key.encode()) % len(self._workers)]
        with self._gate:
            worker = min(self._workers, key=lambda other: (other.load, other is not home))
            worker.load += 1
        try:
            yield worker
        finally:
            with self._gate:
                worker.load -= 1


class _Worker:
    """One process and the line to it; one piece of work after the other."""

    def __init__(self, seconds: float, module: str) -> None:
        self.load = 0
        self._seconds = seconds
        self._module = module
        self._turn = threading.Lock()
        self._hand = threading.Lock()
        self._line: Connection | None = None
        self._process: multiprocessing.process.BaseProcess | None = None
        self._ready = False
        self._closed = False

    def start(self) -> None:
        if self._turn.acquire(blocking=False):  # otherwise it is at work already
            try:
                self._started()
            finally:
                self._turn.release()

    def run(self, work: partial[T]) -> T:
        with self._turn:
            try:
                outcome = self._exchange(work)
            except (EOFError, OSError):  # it had died, perhaps long ago and of something else
                outcome = self._exchange_again(work)
        if outcome.fault is not None:
            raise outcome.fault
        return outcome.value

    def close(self) -> None:
        self._closed = True
        with self._hand:
            if self._process is not None:
                self._process.kill()  # whoever waits for it hears so at once
        with self._turn:
            self._end()

    def _exchange(self, work: partial[Any]) -> _Outcome:
        line = self._started()
        try:
            if not self._ready:
                line.recv()  # its first word; starting does not count as working
                self._ready = True
            line.send(work)
            outcome = line.recv() if line.poll(self._seconds) else None
        except BaseException:
            self._end()  # otherwise a late answer would be taken for that of the next work
            raise
        if not isinstance(outcome, _Outcome):
            self._end()
            raise InvalidError(
                f"This took longer than {self._seconds:g} s and was stopped.",
                code="takes_too_long",
                mend="Cut the clip shorter first, or take steps out of the recipe.",
            )
        return outcome

    def _exchange_again(self, work: partial[Any]) -> _Outcome:
        try:
            return self._exchange(work)
        except (EOFError, OSError) as error:
            raise BusyError(
                "The computation broke off, probably for lack of memory.", code="broke_off"
            ) from error

    def _started(self) -> Connection:
        if self._closed:
            raise BusyError("The server is shutting down.")
        if self._line is None:
            ours, theirs = _context.Pipe()
            process = _context.Process(target=_work, args=(theirs, self._module), daemon=True)
            process.start()
            theirs.close()  # so that we hear of its death
            with self._hand:
                self._line, self._process = ours, process
            if self._closed:  # meanwhile
                raise BusyError("The server is shutting down.")
            return ours
        return self._line

    def _end(self) -> None:
        with self._hand:
            line, process = self._line, self._process
            self._line = self._process = None
            self._ready = False
        if process is not None:
            process.kill()
            process.join()
            process.close()
        if line is not None:
            line.close()


@dataclass(frozen=True)
class _Outcome:
    """What work has given, or what it raised."""

    value: Any = None
    fault: Exception | None = None


def _work(line: Connection, module: str) -> None:
    """What a worker's process does: take work, send the outcome, until the server is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl+C ends the server, which ends us
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the processes share the processors
    import_module(module)
    with suppress(EOFError, OSError):
        line.send(_Outcome())  # ready
        while True:
            try:
                outcome = _Outcome(line.recv()())
            except EOFError:
                raise
            except Exception as fault:  # its caller gets it
                outcome = _Outcome(fault=fault)
            line.send(outcome)
