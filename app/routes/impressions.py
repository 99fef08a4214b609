"""The analysis of adjective pairs: its page, its numbers, what researchers decide in it.

What the template of `templates/research/` is given:

- `impressions.html`: impressions (Impressions, documented in `app/schemas/impressions.py`); study
  {slug, title}; role; section "results". Printed figures: `impressions/figures/<name>.svg` with
  `?mode=light|dark`: `heat-map` and `dendrogram`. Another part: `?part=<id>`; simulated answers:
  `?kind=simulated`; a view that is not saved: `least_peak`, `most_spread`, `clusters`.
"""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Query, Request
from fastapi.responses import Response

from app.dependencies import Reading, StudyEditor, StudyViewer, Writing
from app.pages import render
from app.schemas.errors import ERRORS
from app.schemas.impressions import Choices, Impressions
from app.schemas.results import SessionKind
from app.services import impression_choices
from app.services import impressions as service
from app.services.impressions import Live

router = APIRouter(prefix="/research/studies/{slug}/impressions", include_in_schema=False)
api = APIRouter(prefix="/api/v1/studies/{slug}/impressions", tags=["impressions"], responses=ERRORS)

PartId = Annotated[str, Query(max_length=60)]
Threshold = Annotated[float | None, Query(ge=0, le=10)]


def _live(
    least_peak: Threshold = None,
    most_spread: Threshold = None,
    clusters: Annotated[int | None, Query(ge=1, le=50)] = None,
) -> Live:
    return Live(least_peak, most_spread, clusters)


TriedOut = Annotated[Live, Depends(_live)]


@router.get("")
def show_impressions(
    request: Request,
    access: StudyViewer,
    db: Reading,
    live: TriedOut,
    part: PartId | None = None,
    kind: SessionKind = "participant",
) -> Response:
    """The page of one part's analysis."""
    found = service.impressions(db, access.slug, access.role, part, kind, live)
    return render(
        request, "research/impressions.html", impressions=found, role=access.role,
        study={"slug": found.slug, "title": found.title}, section="results",
    )  # fmt: skip


@api.get("")
def read_impressions(
    access: StudyViewer,
    db: Reading,
    live: TriedOut,
    part: PartId | None = None,
    kind: SessionKind = "participant",
) -> Impressions:
    """Which pairs of adjectives say something, and which of them go together.

    Thresholds and cut that are given stand in for the saved ones; nothing is stored.
    """
    return service.impressions(db, access.slug, access.role, part, kind, live)


@api.put("/{part}")
def choose_impressions(
    access: StudyEditor, part: str, choices: Choices, db: Writing, kind: SessionKind = "participant"
) -> Impressions:
    """Save thresholds, cut, names and moves by hand. What changed is written down."""
    return impression_choices.save(db, access, part, choices, kind)
