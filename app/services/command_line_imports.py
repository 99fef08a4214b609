"""Imports as the command line tells them."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor, Future
from dataclasses import dataclass
from pathlib import Path

from app.errors import MannerError
from app.jobs import executor
from app.persistence.engine import Database
from app.schemas.library import Imported, ImportOptions, Note
from app.services import imports, library

MANY = 16  # files: from here on, other processes are worth their start
AHEAD = 8  # files that are read while one is stored: bounds what is held in memory


@dataclass(frozen=True)
class Told:
    """What became of a file, in lines for a person."""

    text: str
    failed: bool


def import_paths(
    database: Database, paths: Sequence[Path], *, confirm: bool, scheduler: str = ""
) -> Iterator[Told]:
    """Import files one after the other; what each became, as soon as it is known.

    Many files are read by all processors of this machine, or by the cluster of ``scheduler``;
    stored they are here, in the order in which they were named.
    """
    if not scheduler and len(paths) < MANY:
        for path in paths:
            yield import_path(database, path, confirm=confirm)
        return
    with executor(scheduler) as pool:
        ahead: deque[tuple[Path, Future[imports.ReadMotion]]] = deque()
        for path in paths:
            ahead.append((path, _submit(pool, path)))
            if len(ahead) > AHEAD:
                yield _store_next(database, ahead, confirm=confirm)
        while ahead:
            yield _store_next(database, ahead, confirm=confirm)


def _submit(pool: Executor, path: Path) -> Future[imports.ReadMotion]:
    """The file's reading under way; one that cannot be opened fails like an unreadable one."""
    try:
        return pool.submit(_read_path, path.read_bytes())
    except OSError as error:
        failed: Future[imports.ReadMotion] = Future()
        failed.set_exception(error)
        return failed


def _read_path(data: bytes) -> imports.ReadMotion:
    return imports.read_motion(data, ImportOptions())


def _store_next(
    database: Database, ahead: deque[tuple[Path, Future[imports.ReadMotion]]], *, confirm: bool
) -> Told:
    path, reading = ahead.popleft()
    return import_path(database, path, confirm=confirm, read=lambda data, options: reading.result())


def import_path(
    database: Database, path: Path, *, confirm: bool, read: imports.Reader = imports.read_motion
) -> Told:
    """Import the file; its report, or what is wrong with it."""
    try:
        result = imports.import_file(database, path.name, path.read_bytes(), read=read)
        if confirm and result.clip.state == "to_confirm":
            with database.writing() as db:
                library.confirm(db, result.clip.id)
    except (MannerError, OSError) as error:
        return Told(f"✗ {path.name}\n    {error}", failed=True)
    return Told("\n".join(_lines(path, result, confirmed=confirm)), failed=False)


def _lines(path: Path, result: Imported, *, confirmed: bool) -> list[str]:
    report = result.report
    if result.already_there:
        return [f"= {path.name}  is in the library already, as {result.clip.name}"]
    lines = [
        f"✓ {path.name}  {report.duration:.1f} s at {1 / report.frame_time:.4g} fps, "
        f"{len(report.joint_names)} joints, {report.stature:.2f} m tall"
    ]
    lines += [f"    repaired: {_told(note)}" for note in report.repairs]
    if not confirmed:
        lines += [f"    to confirm: {_told(note)}" for note in report.questions]
    return lines


def _told(note: Note) -> str:
    return note.text + (f" ({note.where})" if note.where else "")
