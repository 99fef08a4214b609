"""Files as HTTP wants them: known by strong tags, compressed, in parts, or only described."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from fastapi import HTTPException, Request
from fastapi.responses import Response

# No file has more digits; Python refuses to read some thousands of them as a number.
_RANGE = re.compile(r"bytes=(\d{0,18})-(\d{0,18})$", re.ASCII)


def answer(
    request: Request,
    tag: str,
    media_type: str,
    content: Callable[[bool], bytes],
    headers: Mapping[str, str],
) -> Response:
    """The file, compressed where the client can take it, or the part that it asks for.

    Args:
        request: a GET or a HEAD.
        tag: the same for the same bytes only.
        media_type: of the file.
        content: gives the bytes, compressed by gzip or as they are; called only when needed.
        headers: more for the answer.
    """
    wants_part = "range" in request.headers and request.method == "GET"
    compress = not wants_part and "gzip" in request.headers.get("accept-encoding", "")
    # The compressed bytes are other bytes, so a strong tag must tell the two apart.
    own_tag = f'"{tag}-gzip"' if compress else f'"{tag}"'
    vary = ", ".join(filter(None, [headers.get("Vary"), "Accept-Encoding"]))
    headers = {**headers, "ETag": own_tag, "Vary": vary, "Accept-Ranges": "bytes"}
    if _is_known(request.headers.get("if-none-match", ""), tag):
        return Response(status_code=304, headers=headers)
    body = content(compress)
    if compress:
        headers["Content-Encoding"] = "gzip"
    if wants_part and request.headers.get("if-range", own_tag) == own_tag:
        return _part(body, request.headers["range"], headers, media_type)
    if request.method == "HEAD":
        headers["Content-Length"] = str(len(body))
        return Response(None, 200, headers, media_type)
    return Response(body, 200, headers, media_type)


def _is_known(if_none_match: str, tag: str) -> bool:
    known = {one.strip().removeprefix("W/").strip('"') for one in if_none_match.split(",")}
    return bool(known & {tag, f"{tag}-gzip", "*"})


def _part(content: bytes, wanted: str, headers: dict[str, str], media_type: str) -> Response:
    size = len(content)
    match = _RANGE.match(wanted.strip())
    if match is None or match.groups() == ("", ""):  # several parts, another unit: give it all
        return Response(content, 200, headers, media_type)
    first, last = match.groups()
    start = int(first) if first else max(size - int(last), 0)
    end = min(int(last) + 1, size) if first and last else size
    if start >= end:
        raise HTTPException(416, "The file has no such part.", {"Content-Range": f"bytes */{size}"})
    headers["Content-Range"] = f"bytes {start}-{end - 1}/{size}"
    return Response(content[start:end], 206, headers, media_type)
