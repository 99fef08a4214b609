"""One study's results and figures.

What the templates of `templates/research/` are given:

- `results.html`: results (StudyResults, documented in `app/schemas/results.py`); counts (its
  counts); charts, name to {"light": Vega-Lite specification, "dark": the same}: of each axis
  `shares-<axis>` and `means-<axis>`, of choices `chosen-<choice>`, none while fewer than
  `results.needed` are complete; study {slug, title}; role; section "results". Printed charts:
  `figures/<name>.svg?mode=light|dark`. The other comparison: `?against=all` (the thesis: all clips
  of the body) or `others`; another part: `?part=<id>`; simulated answers: `?kind=simulated`.
  Columns whose numbers are None mean "needs five";
- `counts.html`: counts and study, a fragment that the results page asks for anew while it is open.
"""

from __future__ import annotations

from typing import Annotated, Literal

from fastapi import APIRouter, Query, Request
from fastapi.responses import RedirectResponse, Response

from app.dependencies import Reading, SignedIn, StudyViewer
from app.pages import render
from app.schemas.errors import ErrorResponse
from app.schemas.results import SessionKind, StudyResults
from app.services import charts, drafts, studies
from app.services import results as results_service

router = APIRouter(prefix="/research", include_in_schema=False)
api = APIRouter(prefix="/api/v1/studies", tags=["studies"])

Against = Literal["others", "all"]
Mode = Literal["light", "dark"]
PartId = Annotated[str, Query(max_length=60)]


@router.get("/results")
def show_first_results(researcher: SignedIn, db: Reading) -> Response:
    """The results of the researcher's only study; with several, the list to choose from."""
    found = drafts.listed(db, researcher.id).studies
    address = f"/research/studies/{found[0].slug}" if len(found) == 1 else "/research"
    return RedirectResponse(address, 303)


@router.get("/studies/{slug}")
def show_results(
    request: Request,
    access: StudyViewer,
    slug: str,
    db: Reading,
    against: Against = "others",
    part: PartId | None = None,
    kind: SessionKind = "participant",
) -> Response:
    """The results page of one part."""
    found = results_service.results(db, slug, against, part, kind)
    return render(
        request, "research/results.html", results=found, counts=found.counts, study=found,
        charts=charts.page_charts(found), role=access.role, section="results",
        adjectives=studies.asks_pairs(db, slug),
    )  # fmt: skip


@router.get("/studies/{slug}/counts")
def show_counts(
    request: Request, _: StudyViewer, slug: str, db: Reading, kind: SessionKind = "participant"
) -> Response:
    """The live counts alone."""
    study, counts = studies.find(db, slug), results_service.counts(db, slug, kind)
    return render(request, "research/counts.html", counts=counts, study=study, kind=kind)


@router.get("/studies/{slug}/figures/{name}.svg")
def show_figure(
    _: StudyViewer,
    slug: str,
    name: str,
    db: Reading,
    mode: Mode = "light",
    part: PartId | None = None,
    kind: SessionKind = "participant",
) -> Response:
    """One chart for print."""
    found = results_service.results(db, slug, part=part, kind=kind)
    return Response(charts.printed(found, name, mode), media_type="image/svg+xml")


@api.get(
    "/{slug}/results",
    responses={
        401: {"model": ErrorResponse, "description": "An API key or signing in is needed."},
        404: {"model": ErrorResponse, "description": "There is no such study."},
    },
)
def read_results(
    _: StudyViewer,
    slug: str,
    db: Reading,
    against: Against = "others",
    part: PartId | None = None,
    kind: SessionKind = "participant",
) -> StudyResults:
    """All numbers of the results page, of one part; without its name of the first."""
    return results_service.results(db, slug, against, part, kind)
