"""What a row of the exported tables is about: an answer, who gave it, to which version."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

from app.persistence.models import Response, Study, StudySession
from app.services.measures import CHOICES, EACH_FIGURE, Measure
from app.services.versions import Version


class Row(NamedTuple):
    """One answer, or one figure of it, with all that its cells are made of."""

    study: Study
    version: Version
    participant: StudySession
    answer: Response
    newest: bool
    figure: int | None = None

    @property
    def clip(self) -> str | None:
        """The clip that the row is about; None on pages and where one of several is chosen."""
        if self.figure is None:
            return self.answer.clip_id
        return (self.answer.clips or [])[self.figure]

    @property
    def clips(self) -> list[str]:
        """All clips of the trial as they stood on the page."""
        return self.answer.clips or ([self.answer.clip_id] if self.answer.clip_id else [])

    def name_of(self, clip: str) -> str:
        """How the results name a clip."""
        return self.version.stimulus(self.answer.part, clip).name or clip


def rows_of(row: Row) -> Iterable[Row]:
    """The rows of one answer: one for each figure where each has a number of its own."""
    if row.answer.trial_type not in EACH_FIGURE:
        return (row,)
    return (row._replace(figure=place) for place in range(len(row.clips)))


def value_of(measure: Measure, row: Row) -> Any:  # noqa: ANN401 -- a cell
    """What an answer says of a measure; None where it is another part's."""
    if row.answer.part != measure.part:
        return None
    names = [row.name_of(clip) for clip in row.clips] if measure.trial_type in CHOICES else ()
    return measure.read(row.answer.answers, names, row.figure)
