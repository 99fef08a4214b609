"""GLB files by the hash of their content: whoever knows the hash may have them, for ever."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Path, Request
from fastapi.responses import Response

from app.assets import YEAR
from app.routes import files
from app.services.media import MediaStore

router = APIRouter(include_in_schema=False)


def _store(request: Request) -> MediaStore:
    store: MediaStore = request.app.state.media
    return store


Digest = Annotated[str, Path(pattern="^[0-9a-f]{64}$")]


@router.api_route("/media/{digest}.glb", methods=["GET", "HEAD"])
def media(
    request: Request, digest: Digest, store: Annotated[MediaStore, Depends(_store)]
) -> Response:
    """The file, which never changes."""
    file = store.get(digest)
    headers = {"Cache-Control": YEAR}
    return files.answer(request, digest, "model/gltf-binary", file.content, headers)
