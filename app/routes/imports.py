"""Files into the library."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, File, Form, Response, UploadFile
from pydantic import ValidationError

from app.dependencies import CurrentDatabase, key_writer
from app.errors import InvalidError
from app.schemas.errors import ERRORS
from app.schemas.library import Imported, ImportOptions
from app.services import imports

router = APIRouter(
    prefix="/api/v1",
    tags=["library"],
    responses=ERRORS,
    dependencies=[Depends(key_writer)],
)


@router.post("/imports", status_code=201)
def import_motion(
    database: CurrentDatabase,
    response: Response,
    file: Annotated[UploadFile, File(description="A BVH file")],
    options: Annotated[str, Form(description="ImportOptions as JSON")] = "{}",
) -> Imported:
    """Read a BVH file; its clip then waits to be confirmed.

    201 for a new clip, 200 when the same motion is in the library already.
    """
    result = imports.import_file(database, file.filename or "", file.file.read(), _parsed(options))
    if result.already_there:
        response.status_code = 200
    return result


@router.patch("/clips/{clip_id}")
def correct_clip(clip_id: str, changes: ImportOptions, database: CurrentDatabase) -> Imported:
    """Read the clip's file again with corrections. The clip gets another id."""
    return imports.revise(database, clip_id, changes.model_dump(exclude_unset=True))


def _parsed(options: str) -> ImportOptions:
    try:
        return ImportOptions.model_validate_json(options)
    except ValidationError as error:
        fault = error.errors()[0]
        raise InvalidError(
            f"The options do not make sense: {fault['msg']}.",
            code="invalid_request",
            where={"field": ".".join(str(part) for part in ("options", *fault["loc"]))},
        ) from error
