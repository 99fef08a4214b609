"""Motion files on their way into the library: read, asked about, corrected, kept.

Reading takes seconds for a long file. It happens before the transaction, so that nobody waits for
the database meanwhile; what is stored is stored in one transaction, whole or not at all.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError
from app.persistence import blobs, clips
from app.persistence.engine import Database
from app.persistence.models import ClipRecord
from app.schemas.library import Imported, ImportOptions, ImportReport
from app.services import library
from app.services.engine_version import engine_version
from motion import Clip, MotionError
from motion.errors import BvhSyntaxError

if TYPE_CHECKING:
    from app.services.clip_files import ClipFiles


@dataclass(frozen=True)
class ReadMotion:
    """A file's content, ready to be stored; ``clip`` is what a figure can be grown from."""

    files: ClipFiles
    report: dict[str, Any]
    clip: Clip


Reader = Callable[[bytes, ImportOptions], ReadMotion]


def read_motion(data: bytes, options: ImportOptions) -> ReadMotion:
    """Compute all that the library keeps of a file. No database: it may run anywhere.

    Raises:
        InvalidError: the file cannot be read; ``where`` names line and column.
    """
    # Imported here: they bring SciPy, for which the server's start shall not wait.
    from app.services.clip_files import make_files
    from motion.ingest import IngestOptions, ingest

    try:
        ingested = ingest(data, IngestOptions(**options.model_dump()))
        files = make_files(ingested.clip)
    except MotionError as error:
        raise _unreadable(error) from error
    report = {**ingested.report.to_dict(), "options": options.model_dump(exclude_defaults=True)}
    return ReadMotion(files, report, ingested.clip)


def import_file(
    database: Database,
    name: str,
    data: bytes,
    options: ImportOptions | None = None,
    read: Reader = read_motion,
) -> Imported:
    """Read a BVH file into the library, where it waits for confirmation.

    A file that is there already is not stored again; the answer says so. ``read`` is given where
    the reading happens elsewhere.

    Raises:
        InvalidError: the file cannot be read; ``where`` names line and column.
    """
    options = options or ImportOptions()
    with database.reading() as db:
        known = clips.by_source(db, hashlib.sha256(data).hexdigest())
        if known is not None and options in (ImportOptions(), _options_of(known)):
            return _told(db, known, already_there=True)
    motion = read(data, options)
    figure = _figure(database, motion)
    with database.writing() as db:
        known = clips.by_id(db, motion.files.id)
        if known is not None and known.state != "retired":
            return _told(db, known, already_there=True, report=motion.report)
        clip = _store(db, motion, figure, _clip_name(name), data)
        db.commit()
        return _told(db, clip)


def revise(database: Database, clip_id: str, changes: dict[str, Any]) -> Imported:
    """Read a clip's file again with corrections; the clip gets another id, the old one goes.

    Raises:
        ConflictError: the clip was confirmed already, or has no file.
        InvalidError: the file cannot be read that way.
    """
    with database.reading() as db:
        clip = library.find(db, clip_id, signed_in=True)
        data = _source_to_revise(db, clip)
        name = clip.name
        options = _merged(_options_of(clip), changes)
    motion = read_motion(data, options)
    figure = _figure(database, motion)
    with database.writing() as db:
        old = library.find(db, clip_id, signed_in=True)
        same = clips.by_id(db, motion.files.id)
        if same is not None and same.state == "kept":
            clips.delete(db, old)
            db.commit()
            return _told(db, same, already_there=True, report=motion.report)
        clip = _store(db, motion, figure, name, data)
        if old.id != clip.id:
            clips.delete(db, old)
        db.commit()
        return _told(db, clip)


def _figure(database: Database, motion: ReadMotion) -> bytes | None:
    """The figure of the motion's skeleton, unless this engine made it before."""
    from app.services.clip_files import make_figure

    with database.reading() as db:
        known = clips.figure(db, motion.files.skeleton_hash)
    made_already = known is not None and known.engine_version == engine_version()
    return None if made_already else make_figure(motion.clip)


def _store(
    db: Session, motion: ReadMotion, figure: bytes | None, name: str, data: bytes
) -> ClipRecord:
    if figure is not None:
        clips.put_figure(db, motion.files.skeleton_hash, figure, engine_version())
    return library.store(
        db,
        motion.files,
        name=name,
        source="imported",
        state="to_confirm",
        tags={},
        report=motion.report,
        source_file=data,
    )


def _source_to_revise(db: Session, clip: ClipRecord) -> bytes:
    data = blobs.content(db, clip.source_blob) if clip.source_blob else None
    if clip.state != "to_confirm" or data is None:
        raise ConflictError(
            f"The clip {clip.name} was confirmed already.",
            code="clip_confirmed",
            mend="Delete it and import its file again to read it differently.",
        )
    return data


def _told(
    db: Session,
    clip: ClipRecord,
    *,
    already_there: bool = False,
    report: dict[str, Any] | None = None,
) -> Imported:
    figure = clips.figure(db, clip.skeleton_hash)
    return Imported(
        clip=library.view(clip, figure.glb_blob if figure else None),
        report=ImportReport.model_validate(clip.report or report),
        already_there=already_there,
    )


def _options_of(clip: ClipRecord) -> ImportOptions:
    return ImportOptions.model_validate((clip.report or {}).get("options", {}))


def _merged(options: ImportOptions, changes: dict[str, Any]) -> ImportOptions:
    """The earlier corrections and the new ones; one corrected role does not forget the others."""
    roles = {**(options.roles or {}), **(changes.get("roles") or {})} or None
    return options.model_copy(update={**changes, "roles": roles})


def _clip_name(file_name: str) -> str:
    # Browsers on Windows may send a whole path.
    return PurePath(file_name.replace("\\", "/")).stem.strip()[:200] or "unnamed"


def _unreadable(error: MotionError) -> InvalidError:
    if not isinstance(error, BvhSyntaxError):
        return InvalidError(str(error), code="motion_unusable")
    fault = error.fault
    place = {
        "line": error.line,
        "column": error.column,
        "frame": fault.frame,
        "joint": fault.joint,
        "channel": fault.channel,
        "context": [list(line) for line in fault.context],
    }
    return InvalidError(
        str(error),
        code="bvh_unreadable",
        where={name: value for name, value in place.items() if value is not None},
        extra={"offer": fault.offer} if fault.offer else None,
    )
