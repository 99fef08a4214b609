"""Where long work runs: processes of this machine, or a Dask cluster when a scheduler is set."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager


@contextmanager
def executor(scheduler: str = "") -> Iterator[Executor]:
    """Something that takes work by ``submit`` and ``map``; it ends with the block.

    Args:
        scheduler: address of a Dask scheduler, such as ``tcp://scheduler:8786``; empty for this
            machine. A cluster runs a killed worker's tasks again. Its tasks cost about 2 ms each,
            so hand over chunks.
    """
    if scheduler:
        # Imported when wanted: the cluster's client takes a second to load and most have none.
        from distributed import Client

        with Client(scheduler, set_as_default=False) as client, client.get_executor() as cluster:
            yield cluster
    else:
        # Spawned, not forked: a forked child would inherit open database connections and locks.
        context = multiprocessing.get_context("spawn")
        with ProcessPoolExecutor(max_workers=os.cpu_count(), mp_context=context) as pool:
            yield pool
