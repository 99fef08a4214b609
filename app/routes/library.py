"""The library's JSON API."""

from __future__ import annotations

from typing import Annotated, Any
from urllib.parse import quote

from fastapi import APIRouter, Depends, Query, Request
from fastapi.responses import Response

from app.dependencies import MaybeReader, Reading, Writing, key_writer
from app.routes import files
from app.schemas.edits import Label
from app.schemas.errors import BUSY, ERRORS, ErrorResponse
from app.schemas.library import ClipDetail, ClipDocument, ClipList
from app.services import library
from app.services.downloads import MEDIA_TYPES, ClipFile, ClipFiles, Format

router = APIRouter(prefix="/api/v1/clips", tags=["library"], responses=ERRORS)
writers = [Depends(key_writer)]
BY_TYPE: dict[str, Format] = {
    **{media_type: wanted for wanted, media_type in MEDIA_TYPES.items()},
    "application/x-bvh": "bvh",
    "application/*": "json",
    "*/*": "json",
}
_BINARY = {"schema": {"type": "string", "format": "binary"}}
_NOT_SENT: dict[int | str, dict[str, Any]] = {
    206: {"description": "The part that was asked for"},
    304: {"description": "What the client has is what there is"},
    416: {"model": ErrorResponse, "description": "The file has no such part"},
}


async def _clip_files(request: Request) -> ClipFiles:
    found: ClipFiles = request.app.state.clip_files
    return found


Files = Annotated[ClipFiles, Depends(_clip_files)]
WithMotion = Annotated[bool, Query(alias="motion", description="The motion as well")]
WithFigure = Annotated[bool, Query(alias="figure", description="The figure as well")]


def _answers(*formats: Format) -> dict[int | str, dict[str, Any]]:
    """What the OpenAPI document says about a clip in these formats."""
    answer: dict[str, Any] = {
        "description": "The clip",
        "content": {MEDIA_TYPES[f]: _BINARY for f in formats if f != "json"},
    }
    if "json" in formats:
        answer["model"] = ClipDocument
    return {200: answer, **_NOT_SENT, **BUSY}


@router.get("")
def list_clips(
    db: Reading,
    may_see_all: MaybeReader,
    query: Annotated[str, Query(max_length=200, description="Words of name or tags")] = "",
    tag: Annotated[list[str], Query(description="`emotion:sad`, or a value alone")] = [],  # noqa: B006 -- FastAPI copies it
) -> ClipList:
    """The clips: samples for everybody, the others for researchers and their API keys."""
    return library.listed(db, query, tag, signed_in=may_see_all)


@router.get("/{clip_id}.json", response_class=Response, responses=_answers("json"))
def clip_as_json(
    request: Request,
    clip_id: str,
    clip_files: Files,
    may_see_all: MaybeReader,
    motion: WithMotion = True,
) -> Response:
    """The clip as a JSON file, its motion in metres, seconds and quaternions w, x, y, z."""
    file = clip_files.find(clip_id, "json", whole=motion, signed_in=may_see_all)
    return _sent(request, file, attached=True)


@router.get("/{clip_id}.glb", response_class=Response, responses=_answers("glb"))
def clip_as_glb(
    request: Request,
    clip_id: str,
    clip_files: Files,
    may_see_all: MaybeReader,
    figure: WithFigure = True,
) -> Response:
    """The clip as a GLB file, with its figure."""
    file = clip_files.find(clip_id, "glb", whole=figure, signed_in=may_see_all)
    return _sent(request, file, attached=True)


@router.get("/{clip_id}.bvh", response_class=Response, responses=_answers("bvh"))
def clip_as_bvh(
    request: Request, clip_id: str, clip_files: Files, may_see_all: MaybeReader
) -> Response:
    """The clip as a BVH file, in centimetres."""
    file = clip_files.find(clip_id, "bvh", whole=True, signed_in=may_see_all)
    return _sent(request, file, attached=True)


@router.get("/{clip_id}", response_class=Response, responses=_answers("json", "glb", "bvh"))
def show_clip(
    request: Request,
    clip_id: str,
    clip_files: Files,
    may_see_all: MaybeReader,
    motion: WithMotion = True,
    figure: WithFigure = True,
) -> Response:
    """The clip as `Accept` wants it: JSON, GLB or BVH. The same with `.json`, `.glb`, `.bvh`."""
    wanted = accepted(request.headers.get("accept", ""))
    whole = {"json": motion, "glb": figure, "bvh": True}[wanted]
    file = clip_files.find(clip_id, wanted, whole=whole, signed_in=may_see_all)
    return _sent(request, file, attached=False)


@router.post("/{clip_id}/confirm", dependencies=writers)
def confirm_clip(clip_id: str, db: Writing) -> ClipDetail:
    """Keep an imported clip as its report describes it."""
    return library.confirm(db, clip_id)


@router.put("/{clip_id}/label", dependencies=writers)
def label_clip(clip_id: str, label: Label, db: Writing) -> ClipDetail:
    """Give an imported or edited clip another name, and other tags if any are given."""
    return library.label(db, clip_id, label.name, label.tags)


@router.delete("/{clip_id}", status_code=204, dependencies=writers)
def delete_clip(clip_id: str, db: Writing) -> None:
    """Delete an imported or edited clip that nothing else needs."""
    library.delete(db, clip_id)


for _path, _show in (
    ("/{clip_id}.json", clip_as_json),
    ("/{clip_id}.glb", clip_as_glb),
    ("/{clip_id}.bvh", clip_as_bvh),
    ("/{clip_id}", show_clip),
):
    router.head(_path, include_in_schema=False)(_show)


def accepted(accept: str) -> Format:
    """The format that an ``Accept`` header likes best; JSON where it names none of ours."""
    liked: list[tuple[float, Format]] = []
    for part in accept.split(","):
        kind, *parameters = (piece.strip().lower() for piece in part.split(";"))
        if kind in BY_TYPE:
            liked.append((_weight(parameters), BY_TYPE[kind]))
    best = max(liked, key=lambda one: one[0], default=(0.0, "json"))
    return best[1] if best[0] > 0 else "json"


def _weight(parameters: list[str]) -> float:
    """How much a kind is liked, from 0 to 1."""
    for parameter in parameters:
        name, _, value = parameter.partition("=")
        if name.strip() == "q":
            try:
                return float(value)
            except ValueError:
                return 0.0
    return 1.0


def _sent(request: Request, file: ClipFile, *, attached: bool) -> Response:
    headers = {"Cache-Control": "private, no-cache", "Vary": "Accept, Authorization, Cookie"}
    if attached:
        name = quote(file.name, safe="")
        headers["Content-Disposition"] = f"attachment; filename*=UTF-8''{name}"
    return files.answer(request, file.tag, file.media_type, file.content, headers)
