"""What recipes are made of, over the API: operations, presets, poses."""

from __future__ import annotations

from fastapi import APIRouter, Depends

from app.dependencies import (
    CurrentDatabase,
    CurrentWorkers,
    Reading,
    Writing,
    key_writer,
    reader,
)
from app.schemas.edits import (
    OperationList,
    OperationView,
    PoseList,
    PoseRequest,
    PoseView,
    PresetList,
)
from app.schemas.errors import BUSY, ERRORS
from app.services import catalogue

router = APIRouter(prefix="/api/v1", tags=["editing"], responses=ERRORS)
readers = [Depends(reader)]
writers = [Depends(key_writer)]


@router.get("/operations", dependencies=readers)
def list_operations(workers: CurrentWorkers) -> OperationList:
    """Everything that a recipe's steps can do: units, ranges and defaults as JSON Schema."""
    workers.start()  # whoever asks this will want a motion soon
    return catalogue.operations()


@router.get("/operations/{name}", dependencies=readers)
def show_operation(name: str) -> OperationView:
    """One operation, by name and version: `grid@1`."""
    return catalogue.operation(name)


@router.get("/presets", dependencies=readers)
def list_presets() -> PresetList:
    """The recipes that come with the server, each with the emotion that it is meant to show."""
    return catalogue.presets()


@router.get("/poses", dependencies=readers)
def list_poses(db: Reading) -> PoseList:
    """The poses that posture offsets can be made of: stances, then those captured from clips."""
    return catalogue.listed_poses(db)


@router.post("/poses", status_code=201, dependencies=writers, responses=BUSY)
def capture_pose(
    wanted: PoseRequest, database: CurrentDatabase, workers: CurrentWorkers
) -> PoseView:
    """Keep the pose of one frame of a clip. The same pose again only changes its name."""
    return catalogue.capture_pose(database, workers, wanted)


@router.delete("/poses/{pose_id}", status_code=204, dependencies=writers)
def delete_pose(pose_id: str, db: Writing) -> None:
    """Delete a captured pose that no clip was made with."""
    catalogue.delete_pose(db, pose_id)
