"""The sample library, made by code once for each version of the motion library."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from app.persistence import clips
from app.persistence.engine import Database
from app.services import library
from app.services.clip_files import ClipFiles, make_figure, make_files
from app.services.engine_version import engine_version
from motion.procedural.library import SampleClip, sample_clips

Made = tuple[SampleClip, ClipFiles]


def make(
    database: Database,
    samples: Callable[[], Iterable[SampleClip]] = sample_clips,
    on_progress: Callable[[int, int], None] = lambda done, total: None,
) -> int:
    """Make the sample library and store it whole; the number of clips.

    Samples of an older engine leave the library but stay in the database: answers refer to them.
    """
    figures: dict[str, bytes] = {}
    chosen = list(samples())
    made: list[Made] = []
    for sample in chosen:
        made.append((sample, _make(sample, figures)))
        on_progress(len(made), len(chosen))
    with database.writing() as db:
        clips.retire_samples(db)
        for skeleton_hash, glb in figures.items():
            clips.put_figure(db, skeleton_hash, glb, engine_version())
        for sample, files in made:
            library.store(
                db, files, name=sample.name, source="sample", state="kept", tags=sample.tags
            )
        db.commit()
    return len(made)


def _make(sample: SampleClip, figures: dict[str, bytes]) -> ClipFiles:
    """The sample's files; the figure of a new skeleton goes into ``figures``."""
    files = make_files(sample.clip)
    if files.skeleton_hash not in figures:
        glb = make_figure(sample.clip)
        if glb is not None:
            figures[files.skeleton_hash] = glb
    return files
