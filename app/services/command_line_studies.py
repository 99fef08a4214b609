"""Studies from the command line: checking a file with the library, publishing it."""

from __future__ import annotations

from pathlib import Path

from sqlalchemy.orm import Session

from app.errors import InvalidError, NotFoundError, TooLargeError
from app.persistence import researchers
from app.persistence import studies as store
from app.persistence.engine import Database
from app.persistence.writer import Writer
from app.schemas.studies_api import Changes
from app.services import drafts, new_studies, publishing, rights, study_files, study_stimuli
from app.services.rights import Access
from app.services.study_files import Fault, StudyFile
from app.services.study_text import MOST_BYTES
from app.workers import Workers


def read(path: Path) -> StudyFile:
    """The study that a file describes, or its faults.

    Raises:
        TooLargeError: it cannot be a study file.
    """
    if path.stat().st_size > 2 * MOST_BYTES:  # whatever its encoding
        raise TooLargeError(
            f"{path.name} is too long for a study file.",
            mend="A study file holds texts and names, no motions.",
        )
    try:
        text = path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = path.read_bytes().count(b"\n", 0, error.start) + 1
        fault = Fault(line, 1, "", "The file is not written in UTF-8.", "Save it as UTF-8.")
        return StudyFile(faults=[fault])
    return study_files.read(text, path.name)


def faults_of_clips(db: Session, file: StudyFile) -> list[Fault]:
    """What the library says to a file: clips that are not there, recipes that cannot be done."""
    if file.definition is None:
        return []
    return file.located(study_stimuli.problems(db, file.definition))


def publish(database: Database, file: StudyFile, email: str | None) -> Changes:
    """Make the file's study, or its next version; clips that it needs are made as well.

    Args:
        database: where the study goes.
        file: one without faults.
        email: of the researcher in whose name it is done; None: whoever set the server up.

    Raises:
        InvalidError: there is no such researcher.
        NotFoundError: there is such a study, and it is somebody else's.
    """
    document = {name: value for name, value in file.text.data.items() if name != "running"}
    with database.writing() as db:
        access = _access(db, document["slug"], _researcher(db, email))
        if access is None:
            access = new_studies.create(db, document, _researcher(db, email))
        else:
            drafts.save(db, access, document)
    writer, workers = Writer(database), Workers()
    try:
        changes = publishing.publish(database, writer, workers, access)
    finally:
        workers.close()
        writer.close()
    if file.running is not None:
        with database.writing() as db:
            publishing.run(db, access, file.running)
    return changes


def _access(db: Session, slug: str, researcher_id: int) -> Access | None:
    if store.by_slug(db, slug) is None:
        return None
    return rights.access(db, slug, researcher_id, "edit")


def _researcher(db: Session, email: str | None) -> int:
    found = researchers.by_email(db, email) if email else researchers.earliest(db)
    if found is None and email:
        raise NotFoundError(
            f"No researcher has the address {email}.", mend="Look at how it is written."
        )
    if found is None:
        raise InvalidError(
            "This server has no researcher yet.", mend="Run manner set-up-link and follow the link."
        )
    return found.id
