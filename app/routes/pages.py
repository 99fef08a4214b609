"""The pages that are about motion: the first page, the library, one clip."""

from __future__ import annotations

import json

from fastapi import APIRouter, Request
from fastapi.responses import HTMLResponse

from app import i18n
from app.dependencies import MaybeResearcher, Reading
from app.pages import render, wanted_languages
from app.schemas.study import LANGUAGES
from app.services import catalogue, landing, library

router = APIRouter(include_in_schema=False)


@router.get("/")
def first_page(request: Request, db: Reading, _: MaybeResearcher) -> HTMLResponse:
    """What this is, and the ways on."""
    found = landing.find(db)
    return render(request, "landing.html", clip=found.clip, study=found.study)


@router.get("/library")
def library_page(request: Request, _: MaybeResearcher) -> HTMLResponse:
    """Every clip; a script asks the API for them."""
    return render(request, "library.html", section="library")


@router.get("/library/{clip_id}")
def clip_page(
    request: Request, clip_id: str, db: Reading, researcher: MaybeResearcher
) -> HTMLResponse:
    """One clip in the viewer."""
    clip = library.detail(db, clip_id, signed_in=researcher is not None)
    recipe = clip.provenance.recipe if clip.provenance else []
    steps = catalogue.in_words(db, recipe) if recipe else []
    written = json.dumps([step.model_dump() for step in recipe], indent=2)
    return render(request, "clip.html", clip=clip, steps=steps, recipe=written, section="library")


@router.get("/no-webgl")
def no_webgl_page(request: Request) -> HTMLResponse:
    """What to do when the browser cannot draw the figure."""
    language = i18n.best(LANGUAGES, wanted_languages(request))
    return render(request, "no_webgl.html", language=language)
