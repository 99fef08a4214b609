"""A participant's pages: welcome, the trials, thanks, withdrawal.

What the templates of `templates/participant/` are given:

- `welcome.html`: study (StudyDefinition), clip {glb_url, figure_url, cyclic} or None, problem (text
  or None);
- `take.html`: study, token; the trials come over the API;
- `thanks.html`: study, token, completion_code, answers (how many clips were judged), clip or None;
- `withdraw.html`: study, token, answers (how many clips have an answer);
- `withdrawn.html`: study, token.
"""

from __future__ import annotations

from functools import partial
from typing import Annotated

from fastapi import APIRouter, Form, Request
from fastapi.responses import RedirectResponse, Response

from app.dependencies import CsrfChecked, CurrentWriter, Reading
from app.errors import InvalidError
from app.pages import render
from app.services import sessions, studies
from app.services.sessions import Standing

router = APIRouter(include_in_schema=False)


@router.get("/studies/{slug}")
def show_welcome(request: Request, slug: str, db: Reading) -> Response:
    """What a person reads before taking part. Opening it changes nothing."""
    return _welcome(request, studies.welcome(db, slug))


@router.post("/studies/{slug}/begin", dependencies=[CsrfChecked])
def begin(
    request: Request, slug: str, db: Reading, writer: CurrentWriter,
    agree: Annotated[str, Form()] = "", consent_version: Annotated[str, Form()] = "",
) -> Response:  # fmt: skip
    """Start a session for someone who agreed, and lead to its personal link."""
    if agree != "yes":
        page = studies.welcome(db, slug)
        return _welcome(request, page, "Please tick the box if you agree to take part.")
    agent = request.headers.get("user-agent", "")
    job = partial(sessions.begin, slug=slug, consent_version=consent_version, user_agent=agent)
    try:
        token = writer.write(job)
    except InvalidError as error:
        return _welcome(request, studies.welcome(db, slug), f"{error.message} {error.mend}")
    return RedirectResponse(f"/take/{token}", 303)


@router.get("/take/{token}")
def show_trials(request: Request, token: str, db: Reading) -> Response:
    """The page on which a person answers, where he stopped."""
    found = sessions.standing(db, token)
    if found.state == "complete":
        return RedirectResponse(f"/take/{token}/thanks", 303)
    if found.state == "withdrawn":
        return _withdrawn(request, token, found)
    return render(request, "participant/take.html", study=found.study, token=token)


@router.get("/take/{token}/thanks")
def show_thanks(request: Request, token: str, db: Reading) -> Response:
    """The last page, once every answer has arrived; before that, back to the trials."""
    found = sessions.standing(db, token)
    if found.state != "complete":
        return RedirectResponse(f"/take/{token}", 303)
    return render(
        request, "participant/thanks.html", study=found.study, token=token,
        completion_code=found.completion_code, answers=found.answers, clip=found.clip,
    )  # fmt: skip


@router.get("/take/{token}/withdraw")
def ask_withdrawal(request: Request, token: str, db: Reading) -> Response:
    """Ask before deleting."""
    found = sessions.standing(db, token)
    if found.state == "withdrawn":
        return _withdrawn(request, token, found)
    return render(
        request, "participant/withdraw.html", study=found.study, token=token, answers=found.answers
    )


@router.post("/take/{token}/withdraw", dependencies=[CsrfChecked])
def withdraw(request: Request, token: str, db: Reading, writer: CurrentWriter) -> Response:
    """Delete the answers, now and for good."""
    writer.write(partial(sessions.withdraw, token=token))
    return _withdrawn(request, token, sessions.standing(db, token))


def _welcome(request: Request, page: studies.WelcomePage, problem: str | None = None) -> Response:
    return render(
        request, "participant/welcome.html", status=422 if problem else 200,
        study=page.study, clip=page.clip, problem=problem,
    )  # fmt: skip


def _withdrawn(request: Request, token: str, found: Standing) -> Response:
    return render(request, "participant/withdrawn.html", study=found.study, token=token)
