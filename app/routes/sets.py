"""The page on which a researcher makes many clips at once.

The template `research/sets.html` is given nothing: clips, presets and jobs come over the API.
"""

from __future__ import annotations

from fastapi import APIRouter, Request
from fastapi.responses import Response

from app.dependencies import SignedIn
from app.pages import render

router = APIRouter(prefix="/research/sets", include_in_schema=False)


@router.get("")
def show_sets(request: Request, _: SignedIn) -> Response:
    """Choose clips and presets, see what they come to, make it."""
    return render(request, "research/sets.html")
