"""Motions and other bodies, over the API."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Query

from app.dependencies import CurrentDatabase, CurrentWorkers, Reading, reader
from app.schemas.errors import BUSY, ERRORS
from app.schemas.retargets import CycleCut, Retargeting, SkeletonList
from app.services import retargets

router = APIRouter(prefix="/api/v1", tags=["editing"], responses={**ERRORS, **BUSY})
readers = [Depends(reader)]
Onto = Annotated[str, Query(max_length=64, description="A clip that moves the other skeleton")]
Cycle = Annotated[
    CycleCut,
    Query(description="`cycle@1` goes first: on the stride it finds, or on the whole motion"),
]


@router.get("/skeletons", dependencies=readers)
def list_skeletons(db: Reading) -> SkeletonList:
    """The skeletons that clips of the library share, each with an example."""
    return retargets.skeletons(db)


@router.get("/clips/{clip_id}/retargeting", dependencies=readers)
def clip_retargeting(
    clip_id: str,
    onto: Onto,
    database: CurrentDatabase,
    workers: CurrentWorkers,
    cycle: Cycle = "none",
) -> Retargeting:
    """How well a clip's motion would fit another skeleton. Nothing is stored.

    The recipe `[{"operation": "retarget@1", "parameters": {"clip": "<onto>"}}]` makes the clip;
    for one cycle, `cycle@1` stands before it, with the whole motion's start and end if it is one.
    """
    return retargets.retargeting(database, workers, clip_id, onto, cycle)
