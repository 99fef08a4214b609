"""The page on which researchers edit how a motion feels; its data come over the API."""

from __future__ import annotations

from fastapi import APIRouter, Request
from fastapi.responses import Response

from app.dependencies import SignedIn
from app.pages import render

router = APIRouter(include_in_schema=False)


@router.get("/studio")
def show_studio(request: Request, _: SignedIn, clip: str = "") -> Response:
    """The studio, with a clip on its stage or the question which one."""
    return render(request, "studio.html", clip=clip)
