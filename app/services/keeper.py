"""The server's housekeeping: summaries every few seconds, the retention sweep once a day."""

from __future__ import annotations

import threading
import time

import structlog

from app.persistence.engine import Database
from app.persistence.writer import Writer
from app.services import retention, summaries

EVERY = 5.0  # seconds, at least
SHARE = 0.05  # of the time, at most: answers that come in go first
DAY = 86_400.0

log = structlog.get_logger("manner")


class Keeper:
    """Works in the background until it is closed. Several servers may do the same at once."""

    def __init__(self, database: Database, writer: Writer) -> None:
        self._database = database
        self._writer = writer
        self._closing = threading.Event()
        self._swept_at: float | None = None
        self._thread = threading.Thread(target=self._work, name="keeper", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """End; what is under way is finished."""
        self._closing.set()
        self._thread.join()

    def _work(self) -> None:
        rest = EVERY
        while not self._closing.wait(rest):
            began = time.monotonic()
            try:
                self._keep()
            except Exception:  # the database may be away; the next time may find it again
                log.exception("housekeeping failed")
            rest = max(EVERY, (time.monotonic() - began) / SHARE)

    def _keep(self) -> None:
        while not self._closing.is_set() and summaries.catch_up(self._database, self._writer):
            pass
        if self._swept_at is None or time.monotonic() - self._swept_at > DAY:
            deleted = retention.sweep(self._database, self._writer)
            self._swept_at = time.monotonic()
            if deleted:
                log.info("retention times were over", deleted=deleted)
