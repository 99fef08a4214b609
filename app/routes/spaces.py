"""Authoring spaces: their pages, and the API by which sliders become motion."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Query, Request, Response
from fastapi.responses import HTMLResponse

from app.dependencies import (
    CurrentDatabase,
    CurrentWorkers,
    CurrentWriter,
    KeyWriter,
    Reader,
    Reading,
    SignedIn,
    Writing,
    reader,
)
from app.pages import render
from app.schemas.errors import BUSY, ERRORS
from app.schemas.spaces import (
    KeytimesView,
    NewSpace,
    NewVersion,
    Point,
    Prediction,
    SpaceDetail,
    SpaceList,
    SpaceRecipe,
    TargetList,
    TargetRequest,
    Versions,
    Weighed,
)
from app.services import new_spaces, space_deletion, space_versions, spaces

router = APIRouter(prefix="/studio/spaces", include_in_schema=False)
api = APIRouter(prefix="/api/v1/spaces", tags=["spaces"], responses={**ERRORS, **BUSY})
keytimes_api = APIRouter(prefix="/api/v1/clips", tags=["spaces"], responses={**ERRORS, **BUSY})
readers = [Depends(reader)]
Which = Annotated[
    Versions, Query(description="The space alone, or all versions of its name: all or none")
]
GLB = "model/gltf-binary"
_TEXT = {"schema": {"type": "string"}}
_MOTION = {
    "description": "The motion without a figure",
    "content": {GLB: {"schema": {"type": "string", "format": "binary"}}},
    "headers": {
        "Manner-Weights": {**_TEXT, "description": "Of each example, in the space's order"},
        "Manner-Outside": {**_TEXT, "description": "How far outside of the examples, 0 within"},
    },
}


@router.get("")
def spaces_page(request: Request, _: SignedIn) -> HTMLResponse:
    """Every space; a script asks the API for them."""
    return render(request, "spaces.html")


@router.get("/{space_id}")
def space_page(request: Request, space_id: str, db: Reading, _: SignedIn) -> HTMLResponse:
    """One space to author motions in."""
    return render(request, "space.html", space=spaces.line(db, space_id))


@api.get("")
def list_spaces(db: Reading, caller: Reader) -> SpaceList:
    """All authoring spaces, newest first."""
    return spaces.listed(db, caller.researcher_id)


@api.post("", status_code=201)
def create_space(
    space: NewSpace,
    response: Response,
    caller: KeyWriter,
    database: CurrentDatabase,
    writer: CurrentWriter,
    workers: CurrentWorkers,
) -> SpaceDetail:
    """Make a space of clips that nobody judged; its sliders are motion features.

    The clips have one skeleton, and all of them are cycles or none.
    """
    made = new_spaces.create(database, writer, workers, space, caller.researcher_id)
    response.headers["Location"] = f"/api/v1/spaces/{made.id}"
    return made


@api.get("/{space_id}", dependencies=readers)
def show_space(space_id: str, database: CurrentDatabase) -> SpaceDetail:
    """A space with all its numbers."""
    return spaces.detail(database, space_id)


@api.delete("/{space_id}", status_code=204)
def delete_space(space_id: str, db: Writing, caller: KeyWriter, versions: Which = "one") -> None:
    """Delete a space that no study needs. Its clips stay, and so do clips that were made in it."""
    space_deletion.delete(db, space_id, versions, caller.researcher_id)


@api.post("/{space_id}/weights", dependencies=readers)
def weigh_point(space_id: str, point: Point, database: CurrentDatabase) -> Weighed:
    """The examples' weights at a point. Nothing is stored."""
    return spaces.weights(database, space_id, point)


@api.post(
    "/{space_id}/motion",
    response_class=Response,
    dependencies=readers,
    responses={200: _MOTION},
)
def move_point(space_id: str, point: Point, database: CurrentDatabase) -> Response:
    """The motion at a point as GLB without a figure. Nothing is stored."""
    weighed, glb = spaces.motion(database, space_id, point)
    headers = {
        "Manner-Weights": ",".join(f"{weight:.4f}" for weight in weighed.weights),
        "Manner-Outside": f"{weighed.outside:.4f}",
    }
    return Response(glb, 200, headers, GLB)


@api.post("/{space_id}/recipe", dependencies=readers)
def write_recipe(space_id: str, point: Point, database: CurrentDatabase) -> SpaceRecipe:
    """A point as a recipe: `POST /api/v1/clips` makes the clip, which then needs no space."""
    return spaces.recipe(database, space_id, point)


@api.post("/{space_id}/versions", status_code=201)
def create_space_version(
    space_id: str,
    version: NewVersion,
    response: Response,
    caller: KeyWriter,
    database: CurrentDatabase,
    writer: CurrentWriter,
    workers: CurrentWorkers,
) -> SpaceDetail:
    """Make the next version, with other keytimes or with clips that nobody judged.

    The impressions of joining clips are predicted from their motion. Pairs that cannot be
    predicted are left out of the new version, and its note says so.
    """
    made = space_versions.create(database, writer, workers, space_id, version, caller.researcher_id)
    response.headers["Location"] = f"/api/v1/spaces/{made.id}"
    return made


@api.get("/{space_id}/predictions/{clip_id}", dependencies=readers)
def predict_clip(
    space_id: str, clip_id: str, database: CurrentDatabase, workers: CurrentWorkers
) -> Prediction:
    """The impressions that a clip would have in a space, predicted from its motion."""
    return space_versions.predict(database, workers, space_id, clip_id)


@api.post("/{space_id}/targets", dependencies=readers)
def draw_targets(
    space_id: str, request: TargetRequest, database: CurrentDatabase, workers: CurrentWorkers
) -> TargetList:
    """Motions to be matched: far from each other, and the same for the same seed."""
    return spaces.targets(database, workers, space_id, request)


@keytimes_api.get("/{clip_id}/keytimes", dependencies=readers)
def clip_keytimes(clip_id: str, database: CurrentDatabase, workers: CurrentWorkers) -> KeytimesView:
    """When a clip's feet strike and leave the floor; nothing for one that is no cycle."""
    return spaces.keytimes(database, workers, clip_id)
