"""Whether the server can work."""

from __future__ import annotations

from fastapi import APIRouter
from fastapi.responses import JSONResponse

from app.dependencies import CurrentDatabase
from app.services import health

router = APIRouter()


@router.get("/health", include_in_schema=False)
def show_health(database: CurrentDatabase) -> JSONResponse:
    """200 when the database answers in its newest form, 503 otherwise."""
    state = health.check(database)
    return JSONResponse(state, 200 if state["status"] == "ok" else 503)
