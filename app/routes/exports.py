"""Downloads of a study's raw answers, their codebook, and what computes the results from them."""

from __future__ import annotations

from collections.abc import Iterator

import orjson
from fastapi import APIRouter
from fastapi.responses import Response, StreamingResponse

from app.dependencies import CurrentDatabase, SignedIn
from app.schemas.codebook import Table
from app.services import analysis, exports, psych_ds

router = APIRouter(prefix="/research/studies/{slug}", include_in_schema=False)

CSV = "text/csv; charset=utf-8"


@router.get("/responses.csv")
def download_responses(_: SignedIn, slug: str, database: CurrentDatabase) -> Response:
    """The raw answers, one row an answer."""
    return _sent(exports.responses_csv(database, slug), CSV, f"{slug}-responses.csv")


@router.get("/wide.csv")
def download_wide(_: SignedIn, slug: str, database: CurrentDatabase) -> Response:
    """The same, one row a participant."""
    return _sent(exports.wide_csv(database, slug), CSV, f"{slug}-wide.csv")


@router.get("/responses.jsonl")
def download_lines(_: SignedIn, slug: str, database: CurrentDatabase) -> Response:
    """The same as JSON lines, texts as they were written."""
    found = exports.responses_jsonl(database, slug)
    return _sent(found, "application/jsonl", f"{slug}-responses.jsonl")


@router.get("/codebook.csv")
def download_codebook_table(
    _: SignedIn, slug: str, database: CurrentDatabase, table: Table = "long"
) -> Response:
    """What every column of a table means."""
    book = exports.codebook(database, slug, table)
    return _sent(exports.codebook_csv(book), CSV, f"{slug}-codebook.csv")


@router.get("/codebook.json")
def download_codebook(
    _: SignedIn, slug: str, database: CurrentDatabase, table: Table = "long"
) -> Response:
    """The same for programs."""
    book = exports.codebook(database, slug, table).model_dump(mode="json")
    return _saved(_indented(book), "application/json", f"{slug}-codebook.json")


@router.get("/analysis.R")
def download_r_script(_: SignedIn, slug: str, database: CurrentDatabase) -> Response:
    """A script for R that repeats the results page."""
    script = analysis.r_script(exports.exported(database, slug).definition)
    return _saved(script.encode(), "text/plain; charset=utf-8", f"{slug}-analysis.R")


@router.get("/analysis.ipynb")
def download_notebook(_: SignedIn, slug: str, database: CurrentDatabase) -> Response:
    """A Python notebook that does the same."""
    notebook = analysis.notebook(exports.exported(database, slug).definition)
    return _saved(_indented(notebook), "application/x-ipynb+json", f"{slug}-analysis.ipynb")


@router.get("/psych-ds.zip")
def download_dataset(_: SignedIn, slug: str, database: CurrentDatabase) -> Response:
    """Everything together as a Psych-DS dataset."""
    return _sent(psych_ds.dataset_zip(database, slug), "application/zip", f"{slug}-psych-ds.zip")


def _indented(content: dict[str, object]) -> bytes:
    return orjson.dumps(content, option=orjson.OPT_INDENT_2 | orjson.OPT_APPEND_NEWLINE)


def _saved(content: bytes, media_type: str, name: str) -> Response:
    return Response(content, media_type=media_type, headers=_named(name))


def _sent(pieces: Iterator[str] | Iterator[bytes], media_type: str, name: str) -> Response:
    return StreamingResponse(pieces, media_type=media_type, headers=_named(name))


def _named(name: str) -> dict[str, str]:
    return {"Content-Disposition": f'attachment; filename="{name}"'}
