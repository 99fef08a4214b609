"""The bytes that the viewer plays, by their hash alone."""

from __future__ import annotations

import gzip
from dataclasses import dataclass
from functools import lru_cache

from app.errors import NotFoundError
from app.persistence import blobs
from app.persistence.engine import Database

KEPT_IN_MEMORY = 128


@dataclass(frozen=True)
class Media:
    """A GLB file, plain and compressed."""

    plain: bytes
    compressed: bytes

    def content(self, compressed: bool) -> bytes:
        """The one or the other."""
        return self.compressed if compressed else self.plain


class MediaStore:
    """Reads GLB files and keeps the latest in memory, compressed once instead of each time."""

    def __init__(self, database: Database) -> None:
        self._database = database
        self.get = lru_cache(maxsize=KEPT_IN_MEMORY)(self._load)

    def _load(self, digest: str) -> Media:
        """The file with this hash; a clip's source or original is never given out this way."""
        with self._database.reading() as db:
            content = blobs.content(db, digest, blobs.GLB)
        if content is None:
            raise NotFoundError("There is no such file.", code="media_not_found")
        return Media(content, gzip.compress(content, 6, mtime=0))
