"""The one shape of every JSON error."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ConfigDict


class ErrorDetail(BaseModel):
    """What is wrong, where, and what to do."""

    model_config = ConfigDict(
        extra="allow",
        json_schema_extra={
            "example": {
                "code": "clip_not_found",
                "message": "There is no such clip.",
                "where": None,
                "mend": "Look for it in the library; it may have been deleted.",
            }
        },
    )

    code: str
    message: str
    where: dict[str, Any] | None = None
    mend: str | None = None


class ErrorResponse(BaseModel):
    """Every answer of the API with a status of 400 or above."""

    error: ErrorDetail


# For the OpenAPI document: the statuses a JSON route may answer with besides its own.
ERRORS: dict[int | str, dict[str, Any]] = {
    status: {"model": ErrorResponse, "description": description}
    for status, description in {
        401: "Needs an API key, or a signed-in researcher",
        403: "The API key may only read, or the request lacks its token against forgery",
        404: "Not found",
        409: "Contradicts what is stored",
        413: "More bytes than the server takes",
        422: "Does not make sense",
    }.items()
}
# Besides, where motions are computed.
BUSY: dict[int | str, dict[str, Any]] = {
    503: {"model": ErrorResponse, "description": "Too much to do at this moment"}
}
