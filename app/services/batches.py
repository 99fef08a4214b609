"""Many clips at once: asked for, looked at, cancelled.

Everything is checked before anything is made. What is stored is complete: operations instead of
names of presets, so that a job that goes on after an update makes what was asked for.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.errors import InvalidError, MannerError, NotFoundError
from app.persistence import clips, jobs, poses
from app.persistence.models import ClipRecord, Job
from app.schemas.edits import ClipRequest
from app.schemas.jobs import MOST, Batch, JobDetail, JobItem, JobList, JobView
from app.services import edits, sets

if TYPE_CHECKING:  # it brings SciPy, for which the server's start shall not wait
    from motion.recipe import Recipe


def submit(db: Session, researcher_id: int | None, batch: Batch) -> JobDetail:
    """Queue a job; the server's runner, or that of another server, takes it from there.

    Raises:
        InvalidError: an item cannot be made; message and ``where`` name it.
    """
    requests = batch.items or sets.requests(db, batch)
    if len(requests) > MOST:
        raise InvalidError(
            f"These are {len(requests):,} clips; a job takes {MOST:,} at most.",
            code="too_many_clips",
            mend="Choose fewer, or make several jobs.",
        )
    job = Job(
        kind="clips",
        researcher_id=researcher_id,
        request={"items": _orders(db, requests)},
        items=[{"clip": None, "error": None}] * len(requests),
        total=len(requests),
    )
    jobs.add(db, job)
    db.commit()
    return detail(job)


def listed(db: Session) -> JobList:
    """The last jobs, the newest first."""
    return JobList(jobs=[JobView.model_validate(job) for job in jobs.newest(db)])


def find(db: Session, job_id: UUID) -> JobDetail:
    """A job and what became of each of its clips.

    Raises:
        NotFoundError: there is no such job.
    """
    job = jobs.by_id(db, job_id)
    if job is None:
        raise NotFoundError("There is no such job.", code="job_not_found")
    return detail(job)


def cancel(db: Session, job_id: UUID) -> JobDetail:
    """Stop a job; what it has made stays. One that has ended stays as it is."""
    find(db, job_id)
    jobs.end(db, job_id, "cancelled")
    db.commit()
    return find(db, job_id)


def detail(job: Job) -> JobDetail:
    """What the API tells of a job. Only a job of clips has items."""
    if job.kind != "clips":
        return JobDetail.model_validate({**JobView.model_validate(job).model_dump(), "items": []})
    items = [
        JobItem(source=order["source"], name=order["name"], **outcome)
        for order, outcome in zip(job.request["items"], job.items, strict=True)
    ]
    return JobDetail.model_validate({**JobView.model_validate(job).model_dump(), "items": items})


def _orders(db: Session, requests: Sequence[ClipRequest]) -> list[dict[str, Any]]:
    """Each request as the job keeps it, checked."""
    sources: dict[str, ClipRecord] = {}
    orders: list[dict[str, Any]] = []
    for index, request in enumerate(requests):
        try:
            if request.source not in sources:
                sources[request.source] = edits.source_clip(db, request.source)
            recipe = edits.read_recipe(request)
            _check_supplied(db, recipe)
        except MannerError as error:
            raise _in_item(index, error) from error
        source = sources[request.source]
        name = request.name or edits.name_for(source, request, recipe)
        orders.append(
            {"source": source.id, "operations": recipe.to_list(), "name": name,
             "tags": request.tags}
        )  # fmt: skip
    return orders


def _check_supplied(db: Session, recipe: Recipe) -> None:
    present = {pose.id for pose in poses.by_ids(db, recipe.poses)}
    if recipe.clips:
        present |= clips.present(db, recipe.clips)
    for kind, names in (("pose", recipe.poses), ("clip", recipe.clips)):
        for missing in sorted(names - present):
            raise InvalidError(
                f"The recipe refers to the {kind} {missing}, which is not there.",
                code="recipe_invalid",
                mend=f"Choose another {kind}.",
            )


def _in_item(index: int, error: MannerError) -> InvalidError:
    where = {"item": index, **(error.where or {})}
    message = f"Item {index + 1}: {error.message}"
    return InvalidError(message, code=error.code, where=where, mend=error.mend, extra=error.extra)
