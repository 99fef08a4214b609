"""Imported clips follow a newer motion library: their motion stays, their files are made anew."""

from __future__ import annotations

from collections.abc import Callable

from app.persistence import blobs, clips
from app.persistence.engine import Database
from app.services.clip_files import make_figure, make_files
from app.services.engine_version import engine_version
from motion.storage import clip_from_bytes


def renew_imported(
    database: Database, on_progress: Callable[[int, int], None] = lambda done, total: None
) -> int:
    """Make files and figures of clips that an older engine has imported; how many there were.

    Each clip is a transaction of its own: an interrupted renewal goes on where it stopped.
    """
    with database.reading() as db:
        outdated = clips.imported_by_others(db, engine_version())
    for done, clip_id in enumerate(outdated, 1):
        _renew(database, clip_id)
        on_progress(done, len(outdated))
    return len(outdated)


def _renew(database: Database, clip_id: str) -> None:
    with database.reading() as db:
        record = clips.by_id(db, clip_id)
        content = blobs.content(db, record.clip_blob) if record else None
        if record is None or content is None:  # deleted meanwhile
            return
        figure = clips.figure(db, record.skeleton_hash)
    clip = clip_from_bytes(content)
    files = make_files(clip, record.stature)
    current = figure is not None and figure.engine_version == engine_version()
    glb = None if current else make_figure(clip)
    with database.writing() as db:
        if glb is not None:
            clips.put_figure(db, record.skeleton_hash, glb, engine_version())
        clips.renew(db, clip_id, files.glb, files.poster_time, engine_version())
        db.commit()
