"""A study while it runs: the live page, one participant's replay, members and the audit trail.

What the templates of `templates/research/` are given:

- `live.html`: view (LiveView), charts (name to its specification in both modes), trail, role,
  study, page; section "studies";
- `live_now.html`: the same, a fragment that the page asks for anew while it is open;
- `session.html`: detail (SessionDetail), study {slug, title}, role.
"""

from __future__ import annotations

from typing import Annotated
from uuid import UUID

import orjson
from fastapi import APIRouter, Query, Request
from fastapi.responses import Response

from app.dependencies import (
    CurrentDatabase,
    CurrentWriter,
    Reading,
    StudyEditor,
    StudyOwner,
    StudyViewer,
    Writing,
)
from app.pages import render
from app.schemas.errors import ERRORS
from app.schemas.live import (
    AuditTrail,
    Kind,
    LiveView,
    MemberList,
    MemberRole,
    Reason,
    SessionDetail,
)
from app.services import (
    audit,
    live,
    live_charts,
    participants,
    person_export,
    replay,
    rights,
    studies,
    summaries,
)

router = APIRouter(prefix="/research/studies/{slug}", include_in_schema=False)
api = APIRouter(prefix="/api/v1/studies/{slug}", tags=["running studies"], responses=ERRORS)

Page = Annotated[int, Query(ge=1, le=1_000_000)]
Before = Annotated[int | None, Query(ge=1, le=2**62)]
EVERYTHING = "All that is stored of one participant"


@router.get("/live")
def show_live(
    request: Request,
    access: StudyViewer,
    database: CurrentDatabase,
    writer: CurrentWriter,
    db: Reading,
    kind: Kind = "participant",
    page: Page = 1,
) -> Response:
    """The live page."""
    summaries.catch_up(database, writer)
    view = live.overview(db, access, kind, page)
    return render(
        request, "research/live.html", view=view, study=view, role=access.role, page=page,
        charts=live_charts.page_charts(view), trail=audit.trail(db, access.study_id),
        section="studies", adjectives=studies.asks_pairs(db, access.slug),
    )  # fmt: skip


@router.get("/live/now")
def show_live_now(
    request: Request,
    access: StudyViewer,
    database: CurrentDatabase,
    writer: CurrentWriter,
    db: Reading,
    kind: Kind = "participant",
    page: Page = 1,
) -> Response:
    """What of the live page changes."""
    summaries.catch_up(database, writer)
    view = live.overview(db, access, kind, page)
    return render(
        request, "research/live_now.html", view=view, role=access.role, page=page,
        charts=live_charts.page_charts(view), trail=audit.trail(db, access.study_id),
    )  # fmt: skip


@router.get("/sessions/{session_id}")
def show_session(
    request: Request,
    access: StudyViewer,
    session_id: UUID,
    database: CurrentDatabase,
    writer: CurrentWriter,
    db: Reading,
) -> Response:
    """One participant's way through the study."""
    summaries.catch_up(database, writer)
    detail = replay.replay(db, access, session_id)
    return render(
        request, "research/session.html", detail=detail, role=access.role, section="studies",
        study={"slug": access.slug, "title": detail.study},
        adjectives=studies.asks_pairs(db, access.slug),
    )  # fmt: skip


@api.get("/live")
def read_live(
    access: StudyViewer,
    database: CurrentDatabase,
    writer: CurrentWriter,
    db: Reading,
    kind: Kind = "participant",
    page: Page = 1,
) -> LiveView:
    """How a study is going: who stands where, where they leave, who is suspicious and why."""
    summaries.catch_up(database, writer)
    return live.overview(db, access, kind, page)


@api.get("/audit")
def read_audit(access: StudyViewer, db: Reading, before: Before = None) -> AuditTrail:
    """Who did what with the study, the newest first; `before` is the `older` of the last page."""
    return audit.trail(db, access.study_id, before)


@api.get("/sessions/{session_id}")
def read_session(
    access: StudyViewer,
    session_id: UUID,
    database: CurrentDatabase,
    writer: CurrentWriter,
    db: Reading,
) -> SessionDetail:
    """One participant's way through the study: order, answers, times."""
    summaries.catch_up(database, writer)
    return replay.replay(db, access, session_id)


@api.get(
    "/sessions/{session_id}/export.json",
    response_class=Response,
    responses={200: {"content": {"application/json": {}}, "description": EVERYTHING}},
)
def export_session(access: StudyOwner, session_id: UUID, db: Writing) -> Response:
    """All that is stored of one participant, to hand out to the person. It is written down."""
    found = person_export.export(db, access, session_id)
    name = f"{access.slug}-{live.session_name(session_id)}.json"
    content = orjson.dumps(found, option=orjson.OPT_INDENT_2 | orjson.OPT_APPEND_NEWLINE)
    return Response(
        content,
        media_type="application/json",
        headers={"Content-Disposition": f'attachment; filename="{name}"'},
    )


@api.post("/sessions/{session_id}/exclude", status_code=204)
def exclude_session(access: StudyEditor, session_id: UUID, why: Reason, db: Writing) -> None:
    """Leave a participant out of results and groups. The answers stay; it can be taken back."""
    participants.exclude(db, access, session_id, why.reason)


@api.post("/sessions/{session_id}/include", status_code=204)
def include_session(access: StudyEditor, session_id: UUID, db: Writing) -> None:
    """Count a participant again."""
    participants.include(db, access, session_id)


@api.post("/sessions/{session_id}/flag", status_code=204)
def flag_session(access: StudyEditor, session_id: UUID, why: Reason, db: Writing) -> None:
    """Mark a participant to be looked at again. It changes nothing else."""
    participants.flag(db, access, session_id, why.reason)


@api.post("/sessions/{session_id}/unflag", status_code=204)
def unflag_session(access: StudyEditor, session_id: UUID, db: Writing) -> None:
    """Take the mark off a participant."""
    participants.unflag(db, access, session_id)


@api.delete("/sessions/{session_id}", status_code=204)
def delete_session(access: StudyOwner, session_id: UUID, db: Writing) -> None:
    """Delete a participant's answers and all that is known of them, for good."""
    participants.delete(db, access, session_id)


@api.get("/members")
def list_members(access: StudyViewer, db: Reading) -> MemberList:
    """Who works on the study, as what."""
    return rights.member_list(db, access)


@api.put("/members/{email}")
def put_member(access: StudyOwner, email: str, member: MemberRole, db: Writing) -> MemberList:
    """Add a researcher of this server by address, or change what a member may do."""
    return rights.put_member(db, access, email, member.role)


@api.delete("/members/{email}", status_code=204)
def remove_member(access: StudyViewer, email: str, db: Writing) -> None:
    """Take a member out of the study; who is no owner only themselves."""
    rights.remove_member(db, access, email)
