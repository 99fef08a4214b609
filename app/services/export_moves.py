"""The table of slider paths: every move of a slider in matches, one row a move, in their order."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from app.schemas.codebook import Column
from app.schemas.study import Match
from app.services.export_columns import field
from app.services.export_rows import Row
from app.services.versions import Version


class Move(NamedTuple):
    """One move, and the answer that it led to."""

    row: Row
    milliseconds: float
    slider: str
    position: float

    @property
    def target(self) -> str:
        """How the results name it."""
        return self.row.name_of(self.row.clip or "")

    @property
    def interface(self) -> str | None:
        """By which sliders it was to be made."""
        return self.row.answer.answers.get("interface")


FIELDS = (
    field("session", "the participant’s pseudonym", "text", "row.participant.id"),
    field("trial_index", "place in this participant’s order, from 0", "integer",
          "row.answer.trial_index"),
    field("revision", "1, 2, … for changed answers", "integer", "row.answer.revision"),
    field("part", "the part of the study", "category", "row.answer.part"),
    field("stimulus", "the name of the target", "category", "target"),
    field("interface", "by which sliders the target was made", "category", "interface"),
    field("milliseconds", "when a slider came there, by the clock of the match", "number",
          "milliseconds", "ms"),
    field("slider", "which slider; e0, e1, … are the weights of the space’s examples", "category",
          "slider"),
    field("position", "where it came to, from 0 (left) to 1 (right)", "number", "position"),
)  # fmt: skip
HEADS = tuple(one.column.name for one in FIELDS)


def moves(rows: Iterable[Row]) -> Iterator[Move]:
    """All moves that led to these answers."""
    for row in rows:
        for milliseconds, slider, position in row.answer.record.get("path") or ():
            yield Move(row, milliseconds, slider, position)


def columns_beside(known: Sequence[Column], versions: Sequence[Version]) -> tuple[Column, ...]:
    """The columns of moves that a codebook lacks, if the study has matches."""
    tasks = (part.task for one in versions for part in one.definition.trials)
    if not any(isinstance(task, Match) for task in tasks):
        return ()
    names = {column.name for column in known}
    return tuple(one.column for one in FIELDS if one.column.name not in names)
