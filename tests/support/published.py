"""A study put into the database as publishing leaves it, without looking clips up."""

from __future__ import annotations

from typing import Any

from sqlalchemy.orm import Session

from app.persistence.models import Study, StudyVersion
from app.schemas.study import StudyDefinition


def add_published(
    db: Session, definition: StudyDefinition, state: str = "open", **running: Any
) -> Study:
    """The study with its first version; the commit is the caller's."""
    study = Study(slug=definition.slug, title=definition.title, state=state, running=running)
    db.add(study)
    db.flush()
    add_version(db, study, definition, number=1)
    return study


def add_version(
    db: Session, study: Study, definition: StudyDefinition, number: int
) -> StudyVersion:
    """A version of the study; the commit is the caller's."""
    version = StudyVersion(
        study_id=study.id,
        number=number,
        definition=definition.model_dump(mode="json"),
        definition_hash=definition.content_hash,
    )
    db.add(version)
    db.flush()
    return version
