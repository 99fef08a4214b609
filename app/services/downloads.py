"""Clips as files to take home: JSON, GLB, BVH."""

from __future__ import annotations

import gzip
import hashlib
import threading
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Literal

from app.persistence.engine import Database
from app.persistence.models import ClipRecord
from app.services import library
from app.services.engine_version import engine_version
from app.workers import Workers

Format = Literal["json", "glb", "bvh"]
MEDIA_TYPES: dict[Format, str] = {
    "json": "application/json",
    "glb": "model/gltf-binary",
    "bvh": "text/x-bvh",
}
MEMORY = 64_000_000  # bytes of files that are kept


@dataclass(frozen=True)
class ClipFile:
    """A clip in one format.

    Attributes:
        tag: the same for the same bytes only; it is known before they are made.
        content: makes the bytes, compressed by gzip or as they are.
    """

    name: str
    media_type: str
    tag: str
    content: Callable[[bool], bytes]


class ClipFiles:
    """Makes the files of clips, and keeps the ones last asked for."""

    def __init__(self, database: Database, workers: Workers) -> None:
        self._database = database
        self._workers = workers
        self._kept = Kept(MEMORY)

    def find(self, clip_id: str, wanted: Format, *, whole: bool, signed_in: bool) -> ClipFile:
        """A clip's file; ``whole`` with the motion (JSON) or with the figure (GLB).

        Raises:
            NotFoundError: there is no clip that this person may see.
        """
        with self._database.reading() as db:
            clip = library.find(db, clip_id, signed_in=signed_in)
            about = library.described(db, clip).model_dump_json() if wanted == "json" else ""
        # The engine's version is a hash of the code that makes the bytes.
        made_of = (clip.content_hash, engine_version(), wanted, str(whole), about)
        tag = hashlib.sha256("\n".join(made_of).encode()).hexdigest()[:32]
        make = partial(self._make, clip, wanted, whole, about)
        content = partial(self._content, tag, make)
        return ClipFile(f"{clip.name}.{wanted}", MEDIA_TYPES[wanted], tag, content)

    def _content(self, tag: str, make: Callable[[], bytes], compressed: bool) -> bytes:
        if not compressed:
            return self._kept.get(tag, make)
        pack = partial(_pack, partial(self._kept.get, tag, make))
        return self._kept.get(f"{tag}-gzip", pack)

    def _make(self, clip: ClipRecord, wanted: Format, whole: bool, about: str) -> bytes:
        if wanted == "json" and not whole:
            return about.encode()
        from app.services import rendering  # it brings SciPy

        with self._database.reading() as db:
            stored = library.content(db, clip)
        if wanted == "bvh":
            return self._workers.run(clip.id, rendering.as_bvh, stored)
        if wanted == "glb":
            # By skeleton, so that its figure is built in one worker only.
            return self._workers.run(clip.skeleton_hash, rendering.as_glb, stored, whole)
        motion = self._workers.run(clip.id, rendering.as_json, stored)
        return about.encode().removesuffix(b"}") + b',"motion":' + motion + b"}"


class Kept:
    """Bytes under keys; those not asked for longest are forgotten first."""

    def __init__(self, memory: int) -> None:
        self._memory = memory
        self._size = 0
        self._kept: OrderedDict[str, bytes] = OrderedDict()
        self._gate = threading.Lock()

    def get(self, key: str, make: Callable[[], bytes]) -> bytes:
        """What is kept under the key, or is made now and then kept."""
        with self._gate:
            if key in self._kept:
                self._kept.move_to_end(key)
                return self._kept[key]
        made = make()
        with self._gate:
            self._size += len(made) - len(self._kept.pop(key, b""))
            self._kept[key] = made
            while self._size > self._memory:
                self._size -= len(self._kept.popitem(last=False)[1])
        return made


def _pack(make: Callable[[], bytes]) -> bytes:
    return gzip.compress(make(), 6, mtime=0)
