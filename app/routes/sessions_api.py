"""What a participant's page asks of the server. The token in the address is all the authority."""

from __future__ import annotations

from asyncio import wrap_future
from functools import partial
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Path, Response
from fastapi.concurrency import run_in_threadpool

from app.dependencies import CurrentDatabase, CurrentWriter, Reading, motion_limiter
from app.schemas.errors import ErrorResponse
from app.schemas.sessions import Answer, AnswerReceipt, Completion, Moved, SessionView
from app.security import MotionLimiter
from app.services import answers, matching, session_views, sessions
from app.services.matching import Made

router = APIRouter(prefix="/api/v1/sessions/{token}", tags=["sessions"])

StepIndex = Annotated[int, Path(ge=0, le=100_000)]
Documented = dict[int | str, dict[str, Any]]
NOT_FOUND: Documented = {
    404: {"model": ErrorResponse, "description": "The personal link is not known."}
}
CONFLICT: Documented = {
    409: {"model": ErrorResponse, "description": "It contradicts what is stored."}
}
TOO_MANY: Documented = {
    429: {"model": ErrorResponse, "description": "Asked more often than a hand moves a slider."}
}


@router.get("", responses={**NOT_FOUND})
def show_session(token: str, db: Reading) -> SessionView:
    """The study, this participant's steps in order, the answers so far and where to go on."""
    return session_views.view(db, token)


@router.post(
    "/responses",
    status_code=201,
    responses={
        200: {"model": AnswerReceipt, "description": "The same answer was stored before."},
        **NOT_FOUND,
        **CONFLICT,
    },
)
async def record_response(
    token: str,
    answer: Answer,
    database: CurrentDatabase,
    writer: CurrentWriter,
    response: Response,
) -> AnswerReceipt:
    """Store one answer. Acknowledged only once it is on the disk; safe to send again."""
    if matching.is_match(answer.answers):
        await run_in_threadpool(matching.prepare, database, token, answer.trial_index)
    job = partial(answers.record, token=token, answer=answer)
    receipt, new = await wrap_future(writer.submit(job))
    response.status_code = 201 if new else 200
    return receipt


@router.post(
    "/steps/{index}/motion",
    response_class=Response,
    responses={
        200: {
            "description": "The motion, with its distance from the target in `Manner-Distance`",
            "content": {"model/gltf-binary": {}},
        },
        **NOT_FOUND,
        **CONFLICT,
        **TOO_MANY,
    },
)
def show_motion(
    token: str,
    index: StepIndex,
    moved: Moved,
    db: Reading,
    limiter: Annotated[MotionLimiter, Depends(motion_limiter)],
) -> Response:
    """The motion that the sliders make, in a step that matches a target and whose turn it is."""
    limiter.count(token)
    made = matching.motion(db, token, index, moved.values)
    return motion_response(made)


@router.post("/complete", responses={**NOT_FOUND, **CONFLICT})
async def complete(token: str, writer: CurrentWriter) -> Completion:
    """Close the session once every step has an answer, and give the completion code."""
    return await wrap_future(writer.submit(partial(sessions.complete, token=token)))


def motion_response(made: Made) -> Response:
    """A motion with what is measured of it."""
    return Response(
        made.glb,
        media_type="model/gltf-binary",
        headers={
            "Manner-Distance": f"{made.distance:.4f}",
            "Manner-Outside": f"{made.outside:.4f}",
            "Manner-Solved": str(int(made.solved)),
        },
    )
