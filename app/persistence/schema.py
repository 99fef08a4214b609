"""Brings the database's tables to the newest form, and says whether they are."""

from __future__ import annotations

from functools import cache

from alembic import command
from alembic.config import Config
from alembic.runtime.migration import MigrationContext
from alembic.script import ScriptDirectory
from sqlalchemy import Connection, Engine, text

from app.settings import PROJECT


def migrations_config(connection: Connection | None = None) -> Config:
    """Alembic's configuration, bound to an open connection."""
    config = Config()
    config.set_main_option("script_location", str(PROJECT / "migrations"))
    config.attributes["connection"] = connection
    return config


@cache
def head() -> str | None:
    """The newest revision in the code."""
    return ScriptDirectory.from_config(migrations_config()).get_current_head()


def current(engine: Engine) -> str | None:
    """The revision of the database; ``None`` for an empty one."""
    with engine.connect() as connection:
        return MigrationContext.configure(connection).get_current_revision()


def upgrade(engine: Engine, revision: str = "head") -> None:
    """Migrate up, in one transaction. Several servers may start at once: one waits."""
    with engine.execution_options(writes=True).begin() as connection:
        if engine.dialect.name == "postgresql":
            connection.execute(text("SELECT pg_advisory_xact_lock(:key)"), {"key": 7_254_001})
        command.upgrade(migrations_config(connection), revision)


def downgrade(engine: Engine, revision: str) -> None:
    """Migrate down to ``revision`` (``base``: empty)."""
    with engine.execution_options(writes=True).begin() as connection:
        command.downgrade(migrations_config(connection), revision)
