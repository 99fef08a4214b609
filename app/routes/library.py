"""The library's JSON API."""

from __future__ import annotations

from typing import Annotated
from urllib.parse import quote

from fastapi import APIRouter, Depends, Query
from fastapi.responses import Response

from app.dependencies import CsrfChecked, MaybeResearcher, Reading, Writing, signed_in_researcher
from app.schemas.errors import ERRORS
from app.schemas.library import ClipDetail, ClipList
from app.services import downloads, library

router = APIRouter(prefix="/api/v1/clips", tags=["library"], responses=ERRORS)
researchers_only = [Depends(signed_in_researcher), CsrfChecked]


@router.get("")
def list_clips(
    db: Reading,
    researcher: MaybeResearcher,
    query: Annotated[str, Query(max_length=200, description="Words of name or tags")] = "",
    tag: Annotated[list[str], Query(description="`emotion:sad`, or a value alone")] = [],  # noqa: B006 -- FastAPI copies it
) -> ClipList:
    """The clips: samples for everybody, imported ones for researchers."""
    return library.listed(db, query, tag, signed_in=researcher is not None)


@router.get("/{clip_id}/download.bvh", response_class=Response)
def download_bvh(clip_id: str, db: Reading, researcher: MaybeResearcher) -> Response:
    """The clip as a BVH file, in centimetres."""
    return _file(downloads.as_bvh(db, clip_id, signed_in=researcher is not None), "text/plain")


@router.get("/{clip_id}/download.glb", response_class=Response)
def download_glb(clip_id: str, db: Reading, researcher: MaybeResearcher) -> Response:
    """The clip as a GLB file with its figure."""
    file = downloads.as_glb(db, clip_id, signed_in=researcher is not None)
    return _file(file, "model/gltf-binary")


@router.get("/{clip_id}")
def show_clip(clip_id: str, db: Reading, researcher: MaybeResearcher) -> ClipDetail:
    """One clip and the report of its import."""
    return library.detail(db, clip_id, signed_in=researcher is not None)


@router.post("/{clip_id}/confirm", dependencies=researchers_only)
def confirm_clip(clip_id: str, db: Writing) -> ClipDetail:
    """Keep an imported clip as its report describes it."""
    return library.confirm(db, clip_id)


@router.delete("/{clip_id}", status_code=204, dependencies=researchers_only)
def delete_clip(clip_id: str, db: Writing) -> None:
    """Delete an imported clip."""
    library.delete(db, clip_id)


def _file(file: tuple[str, bytes], media_type: str) -> Response:
    name, content = file
    disposition = f"attachment; filename*=UTF-8''{quote(name, safe='')}"
    return Response(content, 200, {"Content-Disposition": disposition}, media_type)
