"""The API by which studies are made, published, opened and closed."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Any, Literal

from fastapi import APIRouter, Query, Request, Response

from app.dependencies import (
    CurrentDatabase,
    CurrentWorkers,
    CurrentWriter,
    KeyWriter,
    Reader,
    Reading,
    StudyEditor,
    StudyOwner,
    StudyViewer,
    Writing,
)
from app.routes.sessions_api import StepIndex, motion_response
from app.schemas.errors import BUSY, ERRORS
from app.schemas.sessions import Moved, SessionView
from app.schemas.studies_api import (
    Changes,
    ClipsAdded,
    DraftList,
    InvitationList,
    InvitationRequest,
    NewClips,
    NewStudy,
    SavedDraft,
    StateChange,
    StudyDetail,
    StudyList,
    TemplateList,
)
from app.schemas.study import Language, Running
from app.services import draft_clips, drafts, new_studies, previews, publishing

api = APIRouter(prefix="/api/v1/studies", tags=["studies"], responses=ERRORS)
templates = APIRouter(prefix="/api/v1/study-templates", tags=["studies"], responses=ERRORS)
in_the_making = APIRouter(prefix="/api/v1/study-drafts", tags=["studies"], responses=ERRORS)

Seen = Annotated[
    datetime | None, Query(description="`saved_at` of the draft that this one was made from")
]
MEDIA_TYPES = {"yaml": "application/yaml", "json": "application/json"}
FILE: dict[int | str, dict[str, Any]] = {
    200: {
        "description": "The study file",
        "content": {
            "application/yaml": {"schema": {"type": "string"}},
            "application/json": {"schema": {"type": "object"}},
        },
    }
}


@templates.get("")
def list_study_templates(_: Reader) -> TemplateList:
    """The studies that come with the server to begin with."""
    return new_studies.templates()


@in_the_making.get("")
def list_study_drafts(caller: Reader, db: Reading) -> DraftList:
    """What is being edited of every study that the caller may change: which parts take clips."""
    return draft_clips.listed(db, caller.researcher_id)


@api.get("")
def list_studies(caller: Reader, db: Reading) -> StudyList:
    """Every study that the caller may see, with its state and counts."""
    return drafts.listed(db, caller.researcher_id)


@api.post("", status_code=201)
def create_study(
    wanted: NewStudy, caller: KeyWriter, db: Writing, response: Response
) -> StudyDetail:
    """Make a study: from a template, a definition, a study file, or with nothing in it.

    It begins as a draft that only its members see. Its address is the definition's `slug`, with a
    number added where that is taken.
    """
    made = new_studies.make(db, wanted, caller.researcher_id)
    response.headers["Location"] = f"/api/v1/studies/{made.slug}"
    return drafts.view(db, made)


@api.get("/{slug}")
def show_study(access: StudyViewer, db: Reading) -> StudyDetail:
    """A study: its draft and what is wrong with it, its versions, and how it is run."""
    return drafts.view(db, access)


@api.delete("/{slug}", status_code=204)
def delete_study(access: StudyOwner, db: Writing) -> None:
    """Delete a study that was never published."""
    drafts.delete(db, access)


@api.put("/{slug}/draft")
def save_draft(
    access: StudyEditor, draft: dict[str, Any], db: Writing, seen: Seen = None
) -> SavedDraft:
    """Keep a draft, whatever is still wrong with it; the answer tells what is.

    With `seen`, a draft that somebody else saved since then is not written over.
    """
    return drafts.save(db, access, draft, seen)


@api.post("/{slug}/draft/clips")
def add_clips(access: StudyEditor, wanted: NewClips, db: Writing, seen: Seen = None) -> ClipsAdded:
    """Give a part of the draft more clips; those that it has already are not added again.

    Nothing changes for participants until the draft is published.
    """
    return draft_clips.add(db, access, wanted, seen)


@api.delete("/{slug}/draft")
def discard_draft(access: StudyEditor, db: Writing) -> StudyDetail:
    """Go back to the newest version."""
    drafts.discard(db, access)
    return drafts.view(db, access)


@api.get("/{slug}/changes")
def show_changes(access: StudyEditor, db: Reading) -> Changes:
    """What publishing the draft would change, in sentences, and the hash that it would have."""
    return publishing.changes(db, access)


@api.post("/{slug}/publish", responses=BUSY)
def publish_study(
    access: StudyEditor, database: CurrentDatabase, writer: CurrentWriter, workers: CurrentWorkers
) -> Changes:
    """Freeze the draft as the next version, which new participants see from then on.

    A draft without changes makes no version. The first version opens the study.
    """
    return publishing.publish(database, writer, workers, access)


@api.put("/{slug}/running")
def change_running(access: StudyEditor, running: Running, db: Writing) -> StudyDetail:
    """Change who may come and when, and where participants go at the end."""
    publishing.run(db, access, running)
    return drafts.view(db, access)


@api.post("/{slug}/state")
def change_state(access: StudyEditor, wanted: StateChange, db: Writing) -> StudyDetail:
    """Open, pause or close a study. Who has begun can go on."""
    publishing.set_state(db, access, wanted.state)
    return drafts.view(db, access)


@api.post("/{slug}/duplicate", status_code=201)
def duplicate_study(
    access: StudyViewer, caller: KeyWriter, db: Writing, response: Response
) -> StudyDetail:
    """Make another study with the same content, owned by the caller."""
    made = new_studies.duplicate(db, access)
    response.headers["Location"] = f"/api/v1/studies/{made.slug}"
    return drafts.view(db, made)


@api.post("/{slug}/invitations", status_code=201)
def make_invitations(
    access: StudyEditor, wanted: InvitationRequest, db: Writing, request: Request
) -> InvitationList:
    """Make personal links, one participant each. The same label gives the same link again."""
    settings = request.app.state.settings
    made = publishing.invite(
        db, access, wanted.labels, wanted.count, settings.signing_key, settings.public_url
    )
    return InvitationList(invitations=made)


@api.get("/{slug}/file", response_class=Response, responses=FILE)
def download_study_file(
    access: StudyViewer,
    db: Reading,
    version: Annotated[int | None, Query(ge=1, le=2**31 - 1)] = None,
    file_format: Annotated[Literal["yaml", "json"], Query(alias="format")] = "yaml",
) -> Response:
    """A version as a study file; without a number, what is being edited."""
    name, text = drafts.file(db, access, version, file_format)
    return Response(
        text,
        media_type=MEDIA_TYPES[file_format],
        headers={"Content-Disposition": f'attachment; filename="{name}"'},
    )


@api.get("/{slug}/preview")
def preview_study(
    access: StudyViewer,
    db: Reading,
    language: Language | None = None,
    part: Annotated[str | None, Query(max_length=60)] = None,
) -> SessionView:
    """A participant's whole way through what is being edited. Nothing is stored or counted."""
    return previews.session(db, access, language, part)


@api.post(
    "/{slug}/preview/steps/{index}/motion",
    response_class=Response,
    responses={200: {"description": "The motion", "content": {"model/gltf-binary": {}}}},
)
def preview_motion(
    access: StudyViewer,
    index: StepIndex,
    moved: Moved,
    db: Reading,
    part: Annotated[str | None, Query(max_length=60)] = None,
) -> Response:
    """The motion that the sliders of a preview's step make; `part` as the preview was asked for."""
    return motion_response(previews.motion(db, access, index, moved.values, part))
