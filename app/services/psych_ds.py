"""The raw answers as a Psych-DS dataset: a folder that explains itself, zipped while it is sent.

The rules are those of Psych-DS 1.5.1 (https://psychds-docs.readthedocs.io): a description in
schema.org's words that lists every column, and data files named by keyword-value pairs.
"""

from __future__ import annotations

import io
from collections.abc import Iterator
from datetime import datetime
from typing import TYPE_CHECKING
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

import orjson

from app.persistence.models import now
from app.schemas.codebook import Codebook, Column
from app.services import analysis, export_moves
from app.services.export_columns import long_fields
from app.services.exports import (
    Exported,
    cells_of,
    codebook,
    codebook_csv,
    csv_pieces,
)

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer

PIECE = 64_000  # bytes, about
IGNORED = "analysis/\nmaterials/\ndocumentation/\n"
README = """# {title}

The answers of a perception study, one CSV file a participant in data/, one row an answer; where
each of several figures got a number, one row a figure. session, trial_index, revision and figure
together name a row; of each answer the rows with newest = 1 count. Where sliders were moved to
match a target, the participant has a second file (description-moves), one row a move. Participants
are known by a pseudonym alone; those who withdrew are not in here, those with excluded = 1 were
left out of the results by a researcher, for the reason beside it.

- dataset_description.json: what every column means
- documentation/: the same as a table
- materials/: each version of the study as it was run (the newest has the SHA-256 {hash})
- analysis/: an R script and a Python notebook that compute means and tests from data/

Before you publish it, add author, license and citation to dataset_description.json, and read the
column comment: participants may have written about themselves.
"""
CHANGES = """# Changes

- {moment:%Y-%m-%d}: exported from Manner, at {moment:%H:%M} UTC.
"""


def dataset_zip(found: Exported) -> Iterator[bytes]:
    """The whole dataset as a zip archive, a piece at a time; never more than one file in memory."""
    return _zipped(found, now())


def _zipped(found: Exported, moment: datetime) -> Iterator[bytes]:
    out = _Unseekable()
    with ZipFile(out, "w") as archive:
        for name, content in _files(found, moment):
            entry = ZipInfo(f"{found.study.slug}/{name}", moment.timetuple()[:6])
            entry.compress_type = ZIP_DEFLATED
            archive.writestr(entry, content)
            if len(out.written) > PIECE:
                yield out.take()
    yield out.take()


def _files(found: Exported, moment: datetime) -> Iterator[tuple[str, str | bytes]]:
    book = _all_columns(found)
    yield "dataset_description.json", _json(description(book, moment))
    yield "README.md", README.format(title=book.title, hash=book.study_hash)
    yield "CHANGES.md", CHANGES.format(moment=moment)
    yield ".psychdsignore", IGNORED
    yield "documentation/codebook.csv", "".join(codebook_csv(book))
    for version in found.listed:
        content = version.definition.model_dump(mode="json")
        yield f"materials/study-version-{version.number}.json", _json(content)
    yield "analysis/analysis.R", analysis.r_script(found)
    yield "analysis/analysis.ipynb", _json(analysis.notebook(found))
    yield from _data(found)


def _all_columns(found: Exported) -> Codebook:
    """The codebook of all data files: of answers, and of slider paths where the study has them."""
    book = codebook(found)
    more = export_moves.columns_beside(book.columns, found.listed)
    return book.model_copy(update={"columns": (*book.columns, *more)})


def _data(found: Exported) -> Iterator[tuple[str, str]]:
    fields, study = long_fields(found.listed), found.study.slug.replace("-", "")
    heads, cells = [one.column.name for one in fields], cells_of(fields)
    empty = True
    for rows in found.by_participant():
        empty = False
        name = f"data/study-{study}_subject-{rows[0].participant.id.hex}"
        yield f"{name}_data.csv", "".join(csv_pieces(heads, map(cells, rows)))
        if moves := [*map(cells_of(export_moves.FIELDS), export_moves.moves(rows))]:
            yield (
                f"{name}_description-moves_data.csv",
                "".join(csv_pieces(export_moves.HEADS, moves)),
            )
    if empty:  # a dataset needs a data file; this one says that nobody answered yet
        yield f"data/study-{study}_data.csv", "".join(csv_pieces(heads, ()))


def description(book: Codebook, moment: datetime) -> dict[str, object]:
    """The dataset in schema.org's words, every column among them."""
    return {
        "@context": "https://schema.org/",
        "@type": "Dataset",
        "name": book.title,
        "description": (
            f"Raw answers to the study “{book.title}”, one row an answer (or a rated figure), "
            "practice, checks and earlier revisions included and marked."
        ),
        "schemaVersion": "Psych-DS 1.5.1",
        "version": book.study_hash,
        "dateCreated": moment.isoformat(timespec="seconds"),
        "variableMeasured": [_variable(column) for column in book.columns],
    }


def _variable(column: Column) -> dict[str, object]:
    known: dict[str, object] = {
        "@type": "PropertyValue",
        "name": column.name,
        "description": column.meaning,
    }
    if column.unit:
        known["unitText"] = column.unit
    values = [level.value for level in column.levels if isinstance(level.value, int)]
    if values:
        known |= {"minValue": min(values), "maxValue": max(values)}
    if column.levels:
        known["valueReference"] = [
            {"@type": "PropertyValue", "name": level.label, "value": level.value}
            for level in column.levels
        ]
    return known


def _json(content: object) -> bytes:
    return orjson.dumps(content, option=orjson.OPT_INDENT_2 | orjson.OPT_APPEND_NEWLINE)


class _Unseekable(io.RawIOBase):
    """Where the archive is written to: what was written is taken away and sent."""

    def __init__(self) -> None:
        self.written = bytearray()

    def writable(self) -> bool:
        return True

    def write(self, data: ReadableBuffer) -> int:
        before = len(self.written)
        self.written += data
        return len(self.written) - before

    def take(self) -> bytes:
        taken = bytes(self.written)
        self.written.clear()
        return taken
