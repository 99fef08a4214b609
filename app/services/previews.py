"""A study in the making as participants will see it. Nothing here is stored or counted."""

from __future__ import annotations

from collections.abc import Mapping

from sqlalchemy.orm import Session

from app.errors import InvalidError
from app.schemas.sessions import SessionView
from app.schemas.study import Language, StudyDefinition
from app.services import drafts, matching, session_views, studies, study_files, study_stimuli
from app.services.matching import Made
from app.services.plans import planned_steps
from app.services.rights import Access
from app.services.studies import WelcomePage


def session(
    db: Session, access: Access, language: Language | None, part: str | None
) -> SessionView:
    """A participant's way through what is being edited, beginning with a part.

    Raises:
        InvalidError: the draft is no study yet; where.problems says why.
    """
    definition = _shown(db, access)
    return session_views.preview(db, definition, language or definition.languages[0], part)


def motion(
    db: Session, access: Access, index: int, values: Mapping[str, float], part: str | None
) -> Made:
    """The motion that the sliders of a preview's step make.

    Raises:
        InvalidError: as `session`, or the step matches nothing.
        ConflictError: the step is a guess.
    """
    definition = _shown(db, access)
    steps = planned_steps(session_views.preview_plan(definition, part))
    return matching.made_in(db, definition, steps, index, values)


def welcome(db: Session, access: Access, language: Language | None) -> WelcomePage:
    """What a participant would read first.

    Raises:
        InvalidError: the draft is no study yet; where.problems says why.
    """
    definition = _shown(db, access)
    spoken = language or definition.languages[0]
    return WelcomePage(definition.into(spoken), spoken, studies.example_clip(db, definition))


def _shown(db: Session, access: Access) -> StudyDefinition:
    """What is being edited, with clips that stand in for those that are not made yet."""
    definition, _, found = study_files.examine(drafts.content(db, studies.find(db, access.slug)))
    if definition is None or not drafts.is_presentable(found):
        raise InvalidError(
            "The preview waits until nothing is missing.",
            code="study_incomplete",
            where={"problems": [problem.model_dump() for problem in found]},
        )
    return study_stimuli.shown(db, definition)
