"""GLB files by the hash of their content: whoever knows the hash may have them, for ever."""

from __future__ import annotations

import re
from typing import Annotated

from fastapi import APIRouter, Depends, Path, Request
from fastapi.responses import Response

from app.assets import YEAR
from app.services.media import MediaStore

router = APIRouter(include_in_schema=False)

# No file has more digits; Python refuses to read some thousands of them as a number.
_RANGE = re.compile(r"bytes=(\d{0,18})-(\d{0,18})$", re.ASCII)


def _store(request: Request) -> MediaStore:
    store: MediaStore = request.app.state.media
    return store


Digest = Annotated[str, Path(pattern="^[0-9a-f]{64}$")]


@router.api_route("/media/{digest}.glb", methods=["GET", "HEAD"])
def media(
    request: Request, digest: Digest, store: Annotated[MediaStore, Depends(_store)]
) -> Response:
    """The file, compressed where the browser can take it, or the part that it asks for."""
    file = store.get(digest)
    wants_part = "range" in request.headers
    compress = not wants_part and "gzip" in request.headers.get("accept-encoding", "")
    # The compressed bytes are other bytes, so a strong tag must tell the two apart.
    tag = f'"{digest}-gzip"' if compress else f'"{digest}"'
    headers = {
        "Cache-Control": YEAR,
        "ETag": tag,
        "Vary": "Accept-Encoding",
        "Accept-Ranges": "bytes",
    }
    if compress:
        headers["Content-Encoding"] = "gzip"
    if _is_known(request.headers.get("if-none-match", ""), digest):
        headers.pop("Content-Encoding", None)
        return Response(status_code=304, headers=headers)
    if wants_part and request.headers.get("if-range", tag) == tag:
        return _part(file.plain, request.headers["range"], headers)
    content = file.compressed if compress else file.plain
    return Response(content, media_type="model/gltf-binary", headers=headers)


def _is_known(if_none_match: str, digest: str) -> bool:
    known = {tag.strip().removeprefix("W/").strip('"') for tag in if_none_match.split(",")}
    return bool(known & {digest, f"{digest}-gzip", "*"})


def _part(content: bytes, wanted: str, headers: dict[str, str]) -> Response:
    size = len(content)
    match = _RANGE.match(wanted.strip())
    if match is None or match.groups() == ("", ""):  # several parts, another unit: give it all
        return Response(content, media_type="model/gltf-binary", headers=headers)
    first, last = match.groups()
    start = int(first) if first else max(size - int(last), 0)
    end = min(int(last) + 1, size) if first and last else size
    if start >= end:
        return Response(status_code=416, headers={**headers, "Content-Range": f"bytes */{size}"})
    headers["Content-Range"] = f"bytes {start}-{end - 1}/{size}"
    return Response(content[start:end], 206, headers, "model/gltf-binary")
