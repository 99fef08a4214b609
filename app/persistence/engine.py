"""Connections to SQLite and PostgreSQL that behave alike."""

from __future__ import annotations

from sqlalchemy import Connection, Engine, create_engine, event, make_url
from sqlalchemy.engine.interfaces import DBAPIConnection, ExceptionContext
from sqlalchemy.exc import DataError
from sqlalchemy.orm import Session, sessionmaker
from sqlalchemy.pool import ConnectionPoolEntry, QueuePool

from app.errors import InvalidError

BUSY_TIMEOUT_MS = 10_000
# Each of the 40 threads that answer requests may hold a connection, as may the writer, the keeper,
# the job runner and its lock. Threads that wait for the writer must leave one for the writer.
POOL = {"poolclass": QueuePool, "pool_size": 10, "max_overflow": 50}


def make_engine(url: str) -> Engine:
    """An engine for the database at ``url``; parameters never reach error messages or logs."""
    if make_url(url).get_backend_name() != "sqlite":
        engine = create_engine(url, hide_parameters=True, pool_pre_ping=True, **POOL)
        event.listen(engine, "handle_error", _refuse_what_does_not_fit)
        return engine
    engine = create_engine(url, hide_parameters=True, **POOL)
    event.listen(engine, "connect", _prepare_sqlite)
    event.listen(engine, "begin", _begin_sqlite)
    return engine


class Database:
    """Hands out database sessions; each is one unit of work.

    A writing session takes SQLite's write lock at its first statement. Without that, two
    transactions that read first and then write would both hold the read lock and one would fail
    at once, whatever the busy timeout.
    """

    def __init__(self, bind: Engine | Connection) -> None:
        engine = bind.engine
        self.engine = engine
        if isinstance(bind, Connection):  # a test's transaction: commits become savepoints
            self.reading = self.writing = sessionmaker[Session](
                bind, expire_on_commit=False, join_transaction_mode="create_savepoint"
            )
        else:
            self.reading = sessionmaker[Session](engine, expire_on_commit=False)
            self.writing = sessionmaker[Session](
                engine.execution_options(writes=True), expire_on_commit=False
            )


def _refuse_what_does_not_fit(context: ExceptionContext) -> None:
    """PostgreSQL refuses text with NUL, or too long, already in a search: the request's fault."""
    if isinstance(context.sqlalchemy_exception, DataError):
        raise InvalidError(
            "The request holds text or numbers that cannot be stored.",
            mend="Take out unusual characters, or shorten it.",
        ) from context.original_exception


def _prepare_sqlite(connection: DBAPIConnection, _: ConnectionPoolEntry) -> None:
    # Python's driver would start transactions by itself, too late and never IMMEDIATE.
    connection.isolation_level = None
    cursor = connection.cursor()
    cursor.execute(f"PRAGMA busy_timeout = {BUSY_TIMEOUT_MS}")
    cursor.execute("PRAGMA journal_mode = WAL")
    cursor.execute("PRAGMA synchronous = FULL")
    cursor.execute("PRAGMA foreign_keys = ON")
    cursor.close()


def _begin_sqlite(connection: Connection) -> None:
    writes = connection.get_execution_options().get("writes", False)
    connection.exec_driver_sql("BEGIN IMMEDIATE" if writes else "BEGIN")
