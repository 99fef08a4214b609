"""Whether the database answers and has its newest form."""

from __future__ import annotations

import structlog

from app.persistence import schema
from app.persistence.engine import Database

log = structlog.get_logger("manner")


def check(database: Database) -> dict[str, str]:
    """``status`` is ok, or says what hinders."""
    try:
        revision = schema.current(database.engine)
    except Exception as error:
        log.warning("database unreachable", error=type(error).__name__)
        return {"status": "unavailable", "database": "unreachable"}
    if revision != schema.head():
        return {"status": "unavailable", "database": "needs `manner prepare`"}
    return {"status": "ok", "database": "ready"}
