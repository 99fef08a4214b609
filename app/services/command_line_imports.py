"""Imports as the command line tells them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from app.errors import MannerError
from app.persistence.engine import Database
from app.schemas.library import Imported, Note
from app.services import imports, library


@dataclass(frozen=True)
class Told:
    """What became of a file, in lines for a person."""

    text: str
    failed: bool


def import_path(database: Database, path: Path, *, confirm: bool) -> Told:
    """Import the file; its report, or what is wrong with it."""
    try:
        result = imports.import_file(database, path.name, path.read_bytes())
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
