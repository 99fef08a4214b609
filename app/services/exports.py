"""The raw answers as tables, streamed: long and wide CSV, JSON lines, and their codebooks."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterable, Iterator, Sequence
from io import StringIO
from itertools import groupby
from typing import Any, NamedTuple

import orjson

from app.persistence import responses
from app.persistence.engine import Database
from app.persistence.models import Study
from app.schemas.codebook import Codebook, Table
from app.schemas.study import StudyDefinition
from app.services.export_columns import Row, about_participant, long_fields, wide_columns
from app.services.studies import definition_of, find

PIECE = 32_000  # characters, about
# What spreadsheets take for the beginning of a formula, full-width forms included.
DANGEROUS = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")


class Exported(NamedTuple):
    """A study whose answers are asked for.

    It is looked up before the first piece is sent, so that a wrong address is still an error page.
    """

    database: Database
    study: Study
    definition: StudyDefinition

    def rows(self) -> Iterator[Row]:
        """Every stored answer, one participant's together."""
        stimuli = {stimulus.clip: stimulus for stimulus in self.definition.stimuli}
        with self.database.reading() as session:
            for answer, participant, superseded in responses.stream(session, self.study):
                shown = stimuli[answer.clip_id]
                yield Row(self.study, participant, answer, shown, not superseded)

    def by_participant(self) -> Iterator[list[Row]]:
        """The same, a participant at a time."""
        for _, rows in groupby(self.rows(), lambda row: row.participant.id):
            yield list(rows)


def exported(database: Database, slug: str) -> Exported:
    """The study at this address.

    Raises:
        NotFoundError: there is none.
    """
    with database.reading() as session:
        study = find(session, slug)
    return Exported(database, study, definition_of(study))


def responses_csv(database: Database, slug: str) -> Iterator[str]:
    """Every stored answer of a study as CSV text, one row an answer, a piece at a time."""
    found = exported(database, slug)
    return csv_pieces(columns(found.definition), map(answer_cells(found.definition), found.rows()))


def wide_csv(database: Database, slug: str) -> Iterator[str]:
    """One row a participant: of each clip its place in the order and its newest answer."""
    found = exported(database, slug)
    heads = columns(found.definition, "wide")
    return csv_pieces(heads, map(_wide_cells(found.definition), found.by_participant()))


def responses_jsonl(database: Database, slug: str) -> Iterator[bytes]:
    """The long table as JSON lines: numbers are numbers, text stands as it was written."""
    found = exported(database, slug)
    names = columns(found.definition)
    return _gathered(
        orjson.dumps(dict(zip(names, cells, strict=True)), option=orjson.OPT_APPEND_NEWLINE)
        for cells in map(answer_cells(found.definition), found.rows())
    )


def codebook(database: Database, slug: str, table: Table = "long") -> Codebook:
    """What the columns of a table mean."""
    return codebook_of(exported(database, slug), table)


def codebook_of(found: Exported, table: Table = "long") -> Codebook:
    """The same, of a study already at hand."""
    definition = found.definition
    wide = table == "wide"
    return Codebook(
        study=definition.slug,
        study_hash=found.study.definition_hash,
        title=definition.title,
        table=table,
        columns=tuple(
            wide_columns(definition)
            if wide
            else (field.column for field in long_fields(definition))
        ),
    )


def codebook_csv(book: Codebook) -> Iterator[str]:
    """A codebook as a table, one row a column; levels as “label = value; …”."""
    rows = (
        [
            column.name, column.meaning, column.type, column.unit,
            "; ".join(f"{level.label} = {level.value}" for level in column.levels),
        ]
        for column in book.columns
    )  # fmt: skip
    return csv_pieces(["column", "meaning", "type", "unit", "levels"], rows)


def columns(definition: StudyDefinition, table: Table = "long") -> list[str]:
    """The names of a table's columns."""
    if table == "wide":
        return [column.name for column in wide_columns(definition)]
    return [field.column.name for field in long_fields(definition)]


def answer_cells(definition: StudyDefinition) -> Callable[[Row], list[Any]]:
    """What makes the cells of the long table from an answer."""
    values = [field.value for field in long_fields(definition)]
    return lambda row: [value(row) for value in values]


def csv_pieces(heads: Sequence[str], rows: Iterable[Sequence[object]]) -> Iterator[str]:
    """A table as CSV text, safe to open in a spreadsheet."""
    buffer = StringIO()
    write = csv.writer(buffer).writerow
    write(heads)
    for cells in rows:
        write([safe(cell) for cell in cells])
        if buffer.tell() > PIECE:
            yield buffer.getvalue()
            buffer.seek(0)
            buffer.truncate()
    yield buffer.getvalue()


def _gathered(lines: Iterable[bytes]) -> Iterator[bytes]:
    """The lines in pieces worth sending."""
    piece = bytearray()
    for line in lines:
        piece += line
        if len(piece) > PIECE:
            yield bytes(piece)
            piece.clear()
    yield bytes(piece)


def safe(cell: object) -> object:
    """Text that a spreadsheet would take for a formula gets an apostrophe; numbers stay numbers."""
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(DANGEROUS) else cell


def _wide_cells(definition: StudyDefinition) -> Callable[[list[Row]], list[Any]]:
    about = [field.value for field in about_participant()]
    clips = [stimulus.clip for stimulus in definition.stimuli]
    scales = [scale.id for scale in definition.scales]

    def cells(rows: list[Row]) -> list[Any]:
        found = [value(rows[-1]) for value in about]
        counted = {
            row.shown.clip: row.answer for row in rows if row.newest and not row.answer.practice
        }
        for clip in clips:
            answer = counted.get(clip)
            found.append(answer.trial_index if answer else None)
            found += [answer.answers.get(scale) if answer else None for scale in scales]
        return found

    return cells
