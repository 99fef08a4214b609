"""Turns every failure into one JSON shape (``/api``) or a page that says what to do next."""

from __future__ import annotations

from collections.abc import Mapping
from http import HTTPStatus
from urllib.parse import quote

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse, PlainTextResponse, RedirectResponse, Response
from starlette.exceptions import HTTPException

from app import error_texts, errors, i18n
from app.pages import render, wanted_languages
from app.schemas.study import LANGUAGES, Language

STATUSES: dict[type[errors.MannerError], int] = {
    errors.InvalidError: 422,
    errors.SignInNeededError: 401,
    errors.ForbiddenError: 403,
    errors.NotFoundError: 404,
    errors.ConflictError: 409,
    errors.TooLargeError: 413,
    errors.TooManyError: 429,
    errors.BusyError: 503,
}
CODES = {413: errors.TooLargeError.default_code}
# A participant's script sends the page's language as Accept-Language.
PARTICIPANTS = ("/take/", "/studies/", "/api/v1/sessions/")
CHALLENGE = {"WWW-Authenticate": "Bearer"}  # how programs may make themselves known
MENDS = {
    404: "Check the address, or start again from the first page.",
    405: "Use the links and buttons of the pages.",
    413: "Send a smaller file.",
    503: "Try again in a moment.",
    500: "Try again in a moment. If it happens again, tell whoever runs this server the number.",
}


def install(app: FastAPI) -> None:
    """Register the handlers; unforeseen exceptions come through ``answer_unforeseen``."""
    app.add_exception_handler(errors.MannerError, answer_error)
    app.add_exception_handler(HTTPException, _answer_http_exception)
    app.add_exception_handler(RequestValidationError, _answer_validation_error)


def answer_unforeseen(request: Request, request_id: str) -> Response:
    """The answer to a fault of ours; the log has the rest under the same number."""
    error = errors.MannerError(
        "Something went wrong on our side.",
        code="internal",
        where={"request": request_id},
        mend=MENDS[500],
    )
    try:
        return _answer(request, error, 500)
    except Exception:  # the templates themselves may be what is broken
        return PlainTextResponse(f"{error.message} {error.mend} ({request_id})", 500)


def answer_error(request: Request, error: Exception) -> Response:
    """The answer to an error of ours; who must sign in first is led there."""
    if not isinstance(error, errors.MannerError):  # for the type checker: we register only these
        raise error
    status = next((s for kind, s in STATUSES.items() if isinstance(error, kind)), 400)
    if status == 401 and not _is_api(request):
        query = f"?{request.url.query}" if request.url.query else ""
        wanted = request.url.path + query if request.method == "GET" else "/research"
        return RedirectResponse(f"/research/sign-in?next={quote(wanted)}", 303)
    return _answer(request, error, status, CHALLENGE if status == 401 else None)


def _answer_http_exception(request: Request, error: Exception) -> Response:
    if not isinstance(error, HTTPException):
        raise error
    status = error.status_code
    phrase = HTTPStatus(status).phrase
    detail = str(error.detail)
    message = "There is nothing at this address." if detail == "Not Found" else detail
    code = CODES.get(status) or phrase.lower().replace(" ", "_").replace("-", "_")
    told = errors.MannerError(message, code=code, mend=MENDS.get(status))
    return _answer(request, told, status, error.headers)


def _answer_validation_error(request: Request, error: Exception) -> Response:
    if not isinstance(error, RequestValidationError):
        raise error
    # Only place and problem: the input itself may be personal and would end up in logs.
    fields = [
        {"field": ".".join(str(part) for part in fault["loc"][1:]), "problem": fault["msg"]}
        for fault in error.errors()
    ]
    listed = "; ".join(f"{f['field'] or 'body'}: {f['problem']}" for f in fields[:5])
    told = errors.InvalidError(
        f"The request does not make sense: {listed}.",
        code="invalid_request",
        where={"fields": fields},
        mend="Mend the named fields and send it again.",
    )
    return _answer(request, told, 422)


def _answer(
    request: Request,
    error: errors.MannerError,
    status: int,
    headers: Mapping[str, str] | None = None,
) -> Response:
    language = _language(request)
    mend = error.mend or MENDS.get(status)
    message, mend = error_texts.told(error.code, error.message, mend, language)
    body = {
        "code": error.code,
        "message": message,
        "where": error.where,
        "mend": mend,
        **error.extra,
    }
    if _is_api(request):
        return JSONResponse({"error": body}, status, headers)
    told = {**body, "phrase": HTTPStatus(status).phrase}
    return render(
        request, "error.html", status=status, headers=headers, language=language, error=told
    )


def _language(request: Request) -> Language:
    """A participant is answered in the page's language, a researcher in English."""
    for_participant = request.url.path.startswith(PARTICIPANTS)
    return i18n.best(LANGUAGES, wanted_languages(request)) if for_participant else i18n.SOURCE


def _is_api(request: Request) -> bool:
    return request.url.path.startswith("/api/")
