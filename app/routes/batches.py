"""Many clips at once over the API, and the jobs that make them."""

from __future__ import annotations

from uuid import UUID

from fastapi import APIRouter, Depends, Request, Response

from app.dependencies import KeyWriter, Reading, Writing, key_writer, reader
from app.schemas.errors import ERRORS
from app.schemas.jobs import Batch, Choice, JobDetail, JobList, Plan
from app.services import batches, sets
from app.services.job_runner import JobRunner

router = APIRouter(prefix="/api/v1", tags=["jobs"], responses=ERRORS)
readers = [Depends(reader)]
writers = [Depends(key_writer)]


@router.post("/clips/batch", status_code=202)
def create_batch(
    batch: Batch, request: Request, response: Response, caller: KeyWriter, db: Writing
) -> JobDetail:
    """Make up to 2000 clips. All are checked first; then a job makes them one after the other.

    Ask for the job, whose address is in `Location`, to see how far it is. Clips that are in the
    library already are not made again. A job outlives a restart of the server.
    """
    job = batches.submit(db, caller.researcher_id, batch)
    runner: JobRunner = request.app.state.jobs
    runner.wake()
    response.headers["Location"] = f"/api/v1/jobs/{job.id}"
    return job


@router.post("/clips/batch/plan", dependencies=readers)
def plan_batch(choice: Choice, db: Reading) -> Plan:
    """The clips that sources by presets come to, with names and tags. Nothing is made."""
    return sets.plan(db, choice)


@router.get("/sets/foerger", dependencies=readers)
def plan_foerger(db: Reading) -> Plan:
    """Förger's twenty modified clips, from the sample library's two neutral ones."""
    return sets.foerger(db)


@router.get("/jobs", dependencies=readers)
def list_jobs(db: Reading) -> JobList:
    """The last fifty jobs, the newest first."""
    return batches.listed(db)


@router.get("/jobs/{job_id}", dependencies=readers)
def show_job(job_id: UUID, db: Reading) -> JobDetail:
    """How far a job is, and what became of each of its clips."""
    return batches.find(db, job_id)


@router.delete("/jobs/{job_id}", dependencies=writers)
def cancel_job(job_id: UUID, db: Writing) -> JobDetail:
    """Stop a job. What it has made stays; one that has ended stays as it is."""
    return batches.cancel(db, job_id)
