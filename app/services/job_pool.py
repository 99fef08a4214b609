"""The processes that jobs use: started when there is work, ended when there is none for a while."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import Executor, Future
from contextlib import ExitStack
from typing import ParamSpec, TypeVar

from app.jobs import executor

CLUSTER_AHEAD = 64  # chunks: how many processors a cluster has may change while we work
P = ParamSpec("P")
T = TypeVar("T")


class JobPool:
    """An executor that opens itself. For one thread.

    Args:
        scheduler: address of a Dask scheduler; empty for processes of this machine.
        processes: of this machine; None for one a processor.

    Attributes:
        ahead: pieces of work that keep it busy: one under way and one waiting for each process.
    """

    def __init__(self, scheduler: str = "", processes: int | None = None) -> None:
        self._scheduler = scheduler
        self._processes = processes
        self._executor: Executor | None = None
        self._open = ExitStack()
        self.ahead = CLUSTER_AHEAD if scheduler else 2 * (processes or os.cpu_count() or 1)

    def submit(self, function: Callable[P, T], *arguments: P.args, **more: P.kwargs) -> Future[T]:
        """Hand over work; the first work starts the processes."""
        if self._executor is None:
            self._executor = self._open.enter_context(executor(self._scheduler, self._processes))
        return self._executor.submit(function, *arguments, **more)

    def close(self) -> None:
        """End the processes, once what they are at is done; the next work starts others."""
        self._executor = None
        self._open.close()
