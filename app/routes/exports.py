"""Downloads of a study's raw answers, their codebook, and what computes the results from them.

All take `?kind=simulated`, which gives what simulated participants answered instead of people.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

import orjson
from fastapi import APIRouter, Depends
from fastapi.responses import Response, StreamingResponse

from app.dependencies import CurrentDatabase, StudyOwner, StudyViewer
from app.schemas.codebook import Table
from app.schemas.results import SessionKind
from app.services import analysis, exports, psych_ds
from app.services.exports import Exported

router = APIRouter(prefix="/research/studies/{slug}", include_in_schema=False)

CSV = "text/csv; charset=utf-8"


def asked_for(
    _: StudyViewer, slug: str, database: CurrentDatabase, kind: SessionKind = "participant"
) -> Exported:
    """The study whose answers are asked for, by someone who may see them."""
    return exports.exported(database, slug, kind)


Wanted = Annotated[Exported, Depends(asked_for)]


@router.get("/responses.csv")
def download_responses(found: Wanted) -> Response:
    """The raw answers, one row an answer."""
    return _sent(exports.responses_csv(found), CSV, _name(found, "responses.csv"))


@router.get("/wide.csv")
def download_wide(found: Wanted) -> Response:
    """The same, one row a participant."""
    return _sent(exports.wide_csv(found), CSV, _name(found, "wide.csv"))


@router.get("/responses.jsonl")
def download_lines(found: Wanted) -> Response:
    """The same as JSON lines, texts as they were written."""
    lines = exports.responses_jsonl(found)
    return _sent(lines, "application/jsonl", _name(found, "responses.jsonl"))


@router.get("/moves.csv")
def download_moves(found: Wanted) -> Response:
    """Every move of a slider in matches, one row a move."""
    return _sent(exports.moves_csv(found), CSV, _name(found, "moves.csv"))


@router.get("/recruiting.csv")
def download_recruiting(_: StudyOwner, found: Wanted) -> Response:
    """Whom a recruiting service sent, to pay them: for owners alone, and without pseudonyms."""
    return _sent(exports.recruiting_csv(found), CSV, _name(found, "recruiting.csv"))


@router.get("/codebook.csv")
def download_codebook_table(found: Wanted, table: Table = "long") -> Response:
    """What every column of a table means."""
    book = exports.codebook(found, table)
    return _sent(exports.codebook_csv(book), CSV, _name(found, "codebook.csv"))


@router.get("/codebook.json")
def download_codebook(found: Wanted, table: Table = "long") -> Response:
    """The same for programs."""
    book = exports.codebook(found, table).model_dump(mode="json")
    return _saved(_indented(book), "application/json", _name(found, "codebook.json"))


@router.get("/analysis.R")
def download_r_script(found: Wanted) -> Response:
    """A script for R that repeats the results page."""
    script = analysis.r_script(found).encode()
    return _saved(script, "text/plain; charset=utf-8", _name(found, "analysis.R"))


@router.get("/analysis.ipynb")
def download_notebook(found: Wanted) -> Response:
    """The same as a Python notebook."""
    notebook = _indented(analysis.notebook(found))
    return _saved(notebook, "application/x-ipynb+json", _name(found, "analysis.ipynb"))


@router.get("/psych-ds.zip")
def download_dataset(found: Wanted) -> Response:
    """All of it as a Psych-DS dataset."""
    return _sent(psych_ds.dataset_zip(found), "application/zip", _name(found, "psych-ds.zip"))


def _name(found: Exported, file: str) -> str:
    """Which answers a file holds is told by its name."""
    simulated = "" if found.kind == "participant" else "simulated-"
    return f"{found.study.slug}-{simulated}{file}"


def _indented(content: object) -> bytes:
    return orjson.dumps(content, option=orjson.OPT_INDENT_2)


def _saved(content: bytes, media_type: str, name: str) -> Response:
    return Response(content, media_type=media_type, headers=_named(name))


def _sent(pieces: Iterator[str] | Iterator[bytes], media_type: str, name: str) -> Response:
    return StreamingResponse(pieces, media_type=media_type, headers=_named(name))


def _named(name: str) -> dict[str, str]:
    return {"Content-Disposition": f'attachment; filename="{name}"'}
