"""The analysis of adjective pairs: its page, its numbers, what researchers decide in it.

What the template of `templates/research/` is given:

- `impressions.html`: impressions (Impressions, documented in `app/schemas/impressions.py`); study
  {slug, title}; role; section "results". Printed figures: `impressions/figures/<name>.svg` with
  `?mode=light|dark`: `heat-map` and `dendrogram`. Another part: `?part=<id>`; simulated answers:
  `?kind=simulated`; a view that is not saved: `least_peak`, `most_spread`, `clusters`.
"""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Literal
from uuid import UUID

from fastapi import APIRouter, Depends, Query, Request
from fastapi.responses import Response

from app.dependencies import (
    CurrentDatabase,
    CurrentWorkers,
    CurrentWriter,
    Reading,
    StudyEditor,
    StudyViewer,
    Writing,
)
from app.pages import render
from app.schemas.errors import BUSY, ERRORS
from app.schemas.impressions import (
    AnalysisChoices,
    ComparableList,
    Comparison,
    Freeze,
    Impressions,
    Stability,
)
from app.schemas.jobs import JobDetail
from app.schemas.results import SessionKind
from app.schemas.spaces import SpaceLine
from app.services import (
    impression_charts,
    impression_choices,
    impression_comparison,
    impression_space,
    impression_stability,
)
from app.services import impressions as service
from app.services.impressions import Live
from app.services.job_runner import JobRunner

router = APIRouter(prefix="/research/studies/{slug}/impressions", include_in_schema=False)
api = APIRouter(prefix="/api/v1/studies/{slug}/impressions", tags=["impressions"], responses=ERRORS)

Mode = Literal["light", "dark"]
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


@router.get("/figures/{name}.svg")
def show_figure(
    access: StudyViewer,
    name: str,
    db: Reading,
    live: TriedOut,
    mode: Mode = "light",
    part: PartId | None = None,
    kind: SessionKind = "participant",
) -> Response:
    """The matrix or the tree for print."""
    drawn = impression_charts.printed(db, access.slug, name, mode, part, kind, live)
    return Response(drawn, media_type="image/svg+xml")


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


@api.post("/{part}/stability", responses={**BUSY, 202: {"model": JobDetail}})
def draw_stability(
    access: StudyViewer,
    part: str,
    request: Request,
    response: Response,
    database: CurrentDatabase,
    workers: CurrentWorkers,
    live: TriedOut,
    kind: SessionKind = "participant",
    samples: Annotated[int, Query(ge=10, le=10_000)] = 1000,
    seed: Annotated[int, Query(ge=0, lt=2**32)] = 1,
) -> Stability | JobDetail:
    """How the analysis would differ with other participants: a bootstrap, the same by seed.

    A large one becomes a job (202), whose address is in `Location`; its result is at
    `stability/{job}` once it is done.
    """
    found = impression_stability.stability(
        database, workers, access, part, kind, live, samples, seed
    )
    if isinstance(found, JobDetail):
        runner: JobRunner = request.app.state.jobs
        runner.wake()
        response.status_code = 202
        response.headers["Location"] = f"/api/v1/jobs/{found.id}"
    return found


@api.get("/{part}/stability/{job}")
def read_stability(access: StudyViewer, part: str, job: UUID, db: Reading) -> Stability:
    """What a large bootstrap has found."""
    return impression_stability.result(db, access, part, job)


@api.get("/{part}/comparison")
def compare_impressions(
    access: StudyViewer,
    part: str,
    other: Annotated[str, Query(max_length=100)],
    db: Reading,
    other_part: PartId | None = None,
    kind: SessionKind = "participant",
) -> Comparison:
    """The clusters of two studies side by side: how far they agree, which pairs moved."""
    return impression_comparison.comparison(db, access, part, other, other_part, kind)


@api.get("/{part}/comparable")
def list_comparable(
    access: StudyViewer, part: str, db: Reading, kind: SessionKind = "participant"
) -> ComparableList:
    """The parts of your studies that this one can be compared with."""
    return impression_comparison.comparable(db, access, part, kind)


@api.post("/{part}/space", status_code=201, responses=BUSY)
def freeze_impressions(
    access: StudyEditor,
    part: str,
    space: Freeze,
    response: Response,
    database: CurrentDatabase,
    writer: CurrentWriter,
    workers: CurrentWorkers,
    kind: SessionKind = "participant",
) -> SpaceLine:
    """Make an authoring space of the saved analysis, as the next version of its name."""
    line = impression_space.freeze(database, writer, workers, access, part, space.name, kind)
    response.headers["Location"] = f"/api/v1/spaces/{line.id}"
    return line


@api.put("/{part}")
def choose_impressions(
    access: StudyEditor,
    part: str,
    choices: AnalysisChoices,
    db: Writing,
    kind: SessionKind = "participant",
    seen: Annotated[
        datetime | None, Query(description="`saved_at` of the choices that these were made from")
    ] = None,
) -> Impressions:
    """Save thresholds, cut, names and moves by hand. What changed is written down.

    With `seen`, choices that somebody else saved since then are not written over.
    """
    return impression_choices.save(db, access, part, choices, kind, seen)
