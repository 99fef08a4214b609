"""One at a time, among all server processes that share a database.

The lock belongs to the operating system or to PostgreSQL, not to a row: it ends with its holder,
however that ends. So there are no clocks to compare and no claims of the dead to clear away.
"""

from __future__ import annotations

import fcntl
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from sqlalchemy import Engine, text

JOBS = 0x6D6E6A  # "mnj": any number that nothing else in the database uses


@contextmanager
def job_lock(engine: Engine) -> Iterator[bool]:
    """Whether we hold the right to work at jobs, until the block ends. Never waits."""
    if engine.dialect.name == "sqlite":
        with _file_lock(engine.url.database) as held:
            yield held
    else:
        with _advisory_lock(engine) as held:
            yield held


@contextmanager
def _file_lock(database: str | None) -> Iterator[bool]:
    if not database or database == ":memory:":  # nobody else can see it
        yield True
        return
    with Path(f"{database}-jobs.lock").open("w") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            yield False
        else:
            yield True  # closing the file gives it back


@contextmanager
def _advisory_lock(engine: Engine) -> Iterator[bool]:
    # Outside transactions: an open one would keep PostgreSQL from cleaning up for as long.
    with engine.connect().execution_options(isolation_level="AUTOCOMMIT") as connection:
        held = bool(connection.scalar(text("SELECT pg_try_advisory_lock(:key)"), {"key": JOBS}))
        try:
            yield held
        finally:
            if held:
                connection.scalar(text("SELECT pg_advisory_unlock(:key)"), {"key": JOBS})
