"""A participant's pages: welcome, the trials, thanks, withdrawal.

What the templates of `templates/participant/` are given besides `language`:

- `welcome.html`: study (StudyDefinition, texts in the page's language), languages (id and name of
  each that the study has), carried (parameters of the address that are handed on), clip {glb_url,
  figure_url, cyclic} or None, problem (an error's code or None), previewing;
- `closed.html`: study, languages, carried, reason (`app.services.admission.Closed`), opens_at;
- `take.html`: study, token; the steps come over the API;
- `thanks.html`: study, token, state, going (`app.services.recruiting.Return`), answers (how many
  clips were judged), clip or None; also for who was screened out;
- `withdraw.html`: study, token, answers (how many clips have an answer);
- `withdrawn.html`: study, token.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Form, Request
from fastapi.responses import RedirectResponse, Response

from app.dependencies import CsrfChecked, CurrentWriter, Reading, SigningKey
from app.errors import ConflictError, InvalidError
from app.pages import render, wanted_languages
from app.schemas.study import LANGUAGE_NAMES
from app.services import recruiting, sessions, studies
from app.services.recruiting import PARAMETERS, Arrival
from app.services.sessions import Beginning, Standing
from app.services.studies import WelcomePage

router = APIRouter(include_in_schema=False)
ENDED = ("complete", "screened_out", "failed_attention")


async def _handed_on(request: Request) -> dict[str, str]:
    """The parameters of the address that the welcome page's form has handed on."""
    given = await request.form()
    return {name: value for name in PARAMETERS if isinstance(value := given.get(name), str)}


HandedOn = Annotated[dict[str, str], Depends(_handed_on)]


@router.get("/studies/{slug}")
def show_welcome(request: Request, slug: str, db: Reading, secret: SigningKey) -> Response:
    """What a person reads before taking part. Opening it changes nothing."""
    given = request.query_params
    coming = _coming(given, slug, db, secret)
    token = recruiting.personal_token(secret, slug, coming)
    if sessions.known(db, token):
        return RedirectResponse(f"/take/{token}", 303)
    page = studies.welcome(db, slug, coming, wanted_languages(request))
    return _welcome(request, page, coming, given)


@router.post("/studies/{slug}/begin", dependencies=[CsrfChecked])
def begin(
    request: Request, slug: str, db: Reading, writer: CurrentWriter, secret: SigningKey,
    given: HandedOn, agree: Annotated[str, Form()] = "",
    consent_version: Annotated[str, Form()] = "", lang: Annotated[str, Form()] = "",
) -> Response:  # fmt: skip
    """Start a session for someone who agreed, and lead to its personal link."""
    coming = _coming(given, slug, db, secret)
    languages = wanted_languages(request, lang)
    page = studies.welcome(db, slug, coming, languages)
    if agree != "yes" or coming.previewing:
        return _welcome(request, page, coming, given, "not_agreed")
    beginning = Beginning(
        consent_version=consent_version,
        user_agent=request.headers.get("user-agent", ""),
        languages=languages,
        coming=coming,
        token=recruiting.personal_token(secret, slug, coming),
    )
    try:
        token = writer.write(partial(sessions.begin, slug=slug, beginning=beginning))
    except InvalidError as error:
        return _welcome(request, page, coming, given, error.code)
    except ConflictError:  # the last place went to somebody else meanwhile
        return _welcome(request, studies.welcome(db, slug, coming, languages), coming, given)
    return RedirectResponse(f"/take/{token}", 303)


@router.get("/take/{token}")
def show_trials(request: Request, token: str, db: Reading) -> Response:
    """The page on which a person answers, where he stopped."""
    found = sessions.standing(db, token)
    if found.state in ENDED:
        return RedirectResponse(f"/take/{token}/thanks", 303)
    if found.state == "withdrawn":
        return _page(request, "withdrawn", token, found)
    return _page(request, "take", token, found)


@router.get("/take/{token}/thanks")
def show_thanks(request: Request, token: str, db: Reading) -> Response:
    """The last page, once every answer has arrived; before that, back to the trials."""
    found = sessions.standing(db, token)
    if found.state not in ENDED:
        return RedirectResponse(f"/take/{token}", 303)
    return _page(
        request, "thanks", token, found, state=found.state, going=found.going,
        answers=found.answers, clip=found.clip,
    )  # fmt: skip


@router.get("/take/{token}/withdraw")
def ask_withdrawal(request: Request, token: str, db: Reading) -> Response:
    """Ask before deleting."""
    found = sessions.standing(db, token)
    if found.state == "withdrawn":
        return _page(request, "withdrawn", token, found)
    return _page(request, "withdraw", token, found, answers=found.answers)


@router.post("/take/{token}/withdraw", dependencies=[CsrfChecked])
def withdraw(request: Request, token: str, db: Reading, writer: CurrentWriter) -> Response:
    """Delete the answers, now and for good."""
    language = sessions.standing(db, token).language
    writer.write(partial(sessions.withdraw, token=token))
    return _page(request, "withdrawn", token, sessions.standing(db, token), language=language)


def _coming(given: Mapping[str, str], slug: str, db: Reading, secret: str) -> Arrival:
    study = studies.find(db, slug)
    return recruiting.arrival(given, studies.running_of(study), slug, secret)


def _welcome(
    request: Request, page: WelcomePage, coming: Arrival, given: Mapping[str, str],
    problem: str | None = None,
) -> Response:  # fmt: skip
    """The welcome page, or why the study takes nobody now."""
    shown: dict[str, Any] = {
        "language": page.language,
        "study": page.study,
        "languages": [(one, LANGUAGE_NAMES[one]) for one in page.study.languages],
        "carried": {name: given[name] for name in PARAMETERS if given.get(name)},
    }
    if page.closed:
        return render(
            request, "participant/closed.html", reason=page.closed, opens_at=page.opens_at, **shown
        )
    return render(
        request, "participant/welcome.html", status=422 if problem else 200,
        clip=page.clip, problem=problem, previewing=coming.previewing, **shown,
    )  # fmt: skip


def _page(request: Request, name: str, token: str, found: Standing, **context: object) -> Response:
    given: dict[str, Any] = {
        "language": found.language, "study": found.study, "token": token, **context,
    }  # fmt: skip
    return render(request, f"participant/{name}.html", **given)
