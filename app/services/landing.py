"""What the first page shows."""

from __future__ import annotations

from dataclasses import dataclass

from sqlalchemy.orm import Session

from app.errors import NotFoundError
from app.schemas.study import StudyDefinition
from app.services import studies
from app.services.studies import ExampleClip
from app.studies import emotion


@dataclass(frozen=True)
class Landing:
    """A walking figure and the demonstration study, once the samples are made."""

    clip: ExampleClip | None
    study: StudyDefinition | None


def find(db: Session) -> Landing:
    """The demonstration study and the clip that moves beside its text."""
    try:
        page = studies.welcome(db, emotion.SLUG)
    except NotFoundError:  # `manner prepare` has not made the samples yet
        return Landing(None, None)
    return Landing(page.clip, page.study)
