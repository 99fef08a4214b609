"""Where long work runs: processes of this machine, or a Dask cluster when a scheduler is set."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager

NICENESS = 2  # requests come first, but on a busy machine work goes on as well


@contextmanager
def executor(scheduler: str = "", processes: int | None = None) -> Iterator[Executor]:
    """Something that takes work by ``submit`` and ``map``; it ends with the block.

    Args:
        scheduler: address of a Dask scheduler, such as ``tcp://scheduler:8786``; empty for this
            machine. A cluster runs a killed worker's tasks again. Its tasks cost about 2 ms each,
            so hand over chunks.
        processes: of this machine; None for one a processor.
    """
    if scheduler:
        # Imported when wanted: the cluster's client takes a second to load and most have none.
        from distributed import Client

        with Client(scheduler, set_as_default=False) as client, client.get_executor() as cluster:
            yield cluster
    else:
        # Spawned, not forked: a forked child would inherit open database connections and locks.
        context = multiprocessing.get_context("spawn")
        with ProcessPoolExecutor(
            processes or os.cpu_count(), mp_context=context, initializer=_prepare_process
        ) as pool:
            yield pool


def _prepare_process() -> None:
    os.nice(NICENESS)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the processes share the processors
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl+C ends the parent, which ends us
    threading.Thread(target=_end_with_parent, name="parent", daemon=True).start()


def _end_with_parent() -> None:
    # A pool's processes wait for work for ever if the server is killed and cannot tell them.
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
