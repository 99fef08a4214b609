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
from app.persistence.models import Study, StudySession
from app.schemas.codebook import Codebook, Table
from app.schemas.results import SessionKind
from app.services import export_moves
from app.services.export_columns import Field, long_fields
from app.services.export_rows import Row, rows_of
from app.services.export_wide import Person, WideField, wide_fields
from app.services.studies import find
from app.services.versions import Version, published

PIECE = 32_000  # characters, about
# What spreadsheets take for the beginning of a formula, full-width forms included.
DANGEROUS = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")


class Exported(NamedTuple):
    """A study whose answers are asked for.

    It is looked up before the first piece is sent, so that a wrong address is still an error page.

    Attributes:
        versions: all that were published, the newest first.
        kind: of the sessions whose answers are given: people's, or simulated ones.
    """

    database: Database
    study: Study
    versions: dict[int, Version]
    kind: SessionKind

    @property
    def newest(self) -> Version:
        """The version that new participants see."""
        return next(iter(self.versions.values()))

    @property
    def listed(self) -> list[Version]:
        """All versions, the newest first."""
        return list(self.versions.values())

    def rows(self) -> Iterator[Row]:
        """Every stored answer, one participant's together; one row a figure where each is rated."""
        with self.database.reading() as session:
            for answer, participant, superseded in responses.stream(session, self.study, self.kind):
                version = self.versions.get(participant.version_id)
                if version is None:  # published since then: the table has no columns for it
                    continue
                yield from rows_of(Row(self.study, version, participant, answer, not superseded))

    def by_participant(self) -> Iterator[list[Row]]:
        """The same, a participant at a time."""
        for _, rows in groupby(self.rows(), lambda row: row.participant.id):
            yield list(rows)


def exported(database: Database, slug: str, kind: SessionKind = "participant") -> Exported:
    """The study at this address.

    Raises:
        NotFoundError: there is none, or it was never published.
    """
    with database.reading() as session:
        study = find(session, slug)
        return Exported(database, study, published(session, study), kind)


def responses_csv(found: Exported) -> Iterator[str]:
    """Every stored answer of a study as CSV text, a piece at a time."""
    fields = long_fields(found.listed)
    return csv_pieces([one.column.name for one in fields], map(cells_of(fields), found.rows()))


def wide_csv(found: Exported) -> Iterator[str]:
    """One row a participant: of each clip its place in the order and its newest answer."""
    fields = wide_fields(found.listed)
    people = map(Person.of, found.by_participant())
    return csv_pieces([one.column.name for one in fields], map(cells_of(fields), people))


def responses_jsonl(found: Exported) -> Iterator[bytes]:
    """The long table as JSON lines: numbers are numbers, text stands as it was written."""
    fields = long_fields(found.listed)
    names = [one.column.name for one in fields]
    return _gathered(
        orjson.dumps(dict(zip(names, cells, strict=True)), option=orjson.OPT_APPEND_NEWLINE)
        for cells in map(cells_of(fields), found.rows())
    )


def moves_csv(found: Exported) -> Iterator[str]:
    """Every move of a slider in matches, one row a move, in their order."""
    moves = export_moves.moves(found.rows())
    return csv_pieces(export_moves.HEADS, map(cells_of(export_moves.FIELDS), moves))


def recruiting_csv(found: Exported) -> Iterator[str]:
    """Whom a recruiting service sent and what became of them, to pay them; without pseudonyms.

    They are in the order of their ids and not, like the answers, in that of their coming: so no
    row can be joined with answers. Who withdrew is not in it.
    """
    with found.database.reading() as session:
        people = responses.recruited(session, found.study, found.kind)
    heads = ["id", "submission", "source", "outcome", "code", "minutes"]
    return csv_pieces(heads, sorted(map(_recruited, people), key=lambda row: str(row[0])))


def _recruited(person: StudySession) -> list[object]:
    given = person.external or {}
    ids = (given.get(name) for name in ("PROLIFIC_PID", "workerId", "id", "invitation"))
    submissions = (given.get(name) for name in ("SESSION_ID", "assignmentId"))
    minutes = None
    if person.completed_at and person.consented_at:
        minutes = round((person.completed_at - person.consented_at).total_seconds() / 60, 1)
    return [
        next(filter(None, ids), None), next(filter(None, submissions), None),
        person.source, person.state, person.completion_code, minutes,
    ]  # fmt: skip


def codebook(found: Exported, table: Table = "long") -> Codebook:
    """What the columns of a table mean."""
    fields = wide_fields(found.listed) if table == "wide" else long_fields(found.listed)
    return Codebook(
        study=found.study.slug,
        study_hash=found.newest.hash,
        title=str(found.newest.definition.title),
        table=table,
        columns=tuple(field.column for field in fields),
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


def cells_of(fields: Sequence[Field | WideField]) -> Callable[[Any], list[Any]]:
    """What makes a row's cells."""
    values = [field.value for field in fields]
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
