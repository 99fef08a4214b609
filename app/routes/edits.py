"""Editing over the API: clips from recipes, tried out or kept."""

from __future__ import annotations

from fastapi import APIRouter, Depends
from fastapi.responses import Response

from app.dependencies import CurrentDatabase, CurrentWorkers, CurrentWriter, key_writer, reader
from app.schemas.edits import Checked, ClipRequest, EasedOff, Edit, Rebuilt
from app.schemas.errors import BUSY, ERRORS
from app.schemas.library import ClipDetail
from app.services import edits

router = APIRouter(prefix="/api/v1/clips", tags=["editing"], responses={**ERRORS, **BUSY})
readers = [Depends(reader)]
writers = [Depends(key_writer)]
GLB = "model/gltf-binary"
_GLB_ANSWER = {
    "description": "The edited clip without a figure",
    "content": {GLB: {"schema": {"type": "string", "format": "binary"}}},
    "headers": {"X-Manner-Recipe": {"schema": {"type": "string"}, "description": "Recipe's hash"}},
}


@router.post("", status_code=201, dependencies=writers, responses={200: {"model": ClipDetail}})
def create_clip(
    edit: ClipRequest,
    response: Response,
    database: CurrentDatabase,
    writer: CurrentWriter,
    workers: CurrentWorkers,
) -> ClipDetail:
    """Make a clip by a recipe and keep it: 201.

    The same recipe on the same source gives the same clip; 200 if it is there already, under the
    name and the tags that it has.
    """
    clip, is_new = edits.create(database, writer, workers, edit)
    response.headers["Location"] = f"/api/v1/clips/{clip.id}"
    if not is_new:
        response.status_code = 200
    return clip


@router.post(
    "/preview", response_class=Response, dependencies=readers, responses={200: _GLB_ANSWER}
)
def preview_clip(edit: Edit, database: CurrentDatabase, workers: CurrentWorkers) -> Response:
    """The edited clip as GLB without a figure. Nothing is stored."""
    recipe, glb = edits.preview(database, workers, edit)
    return Response(glb, 200, {"X-Manner-Recipe": recipe}, GLB)


@router.post("/check", dependencies=readers)
def check_clip(edit: Edit, database: CurrentDatabase, workers: CurrentWorkers) -> Checked:
    """What an edit would break, and when its feet would stand. Nothing is stored."""
    return edits.check(database, workers, edit)


@router.post("/ease-off", dependencies=readers)
def ease_off_clip(edit: Edit, database: CurrentDatabase, workers: CurrentWorkers) -> EasedOff:
    """The recipe, lowered as little as needed for a report without findings. Nothing is stored."""
    return edits.ease_off(database, workers, edit)


@router.get("/{clip_id}/quality", dependencies=readers)
def clip_quality(
    clip_id: str, database: CurrentDatabase, writer: CurrentWriter, workers: CurrentWorkers
) -> Checked:
    """What the edit of a kept clip broke; the clip's JSON tells it from then on."""
    return edits.quality(database, writer, workers, clip_id)


@router.post("/{clip_id}/rebuild", dependencies=writers)
def rebuild_clip(
    clip_id: str, database: CurrentDatabase, writer: CurrentWriter, workers: CurrentWorkers
) -> Rebuilt:
    """Make an edited clip again from its recipe and compare the two motions bit by bit.

    If the engine is a newer one, the clip that it makes is kept beside the old one.
    """
    return edits.rebuild(database, writer, workers, clip_id)
