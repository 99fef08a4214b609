"""Set-up by a one-time link, signing in and out."""

from __future__ import annotations

from typing import Annotated
from urllib.parse import quote

from fastapi import APIRouter, Depends, Form, Request
from fastapi.responses import HTMLResponse, RedirectResponse, Response

from app.dependencies import CsrfChecked, MaybeResearcher, Reading, Writing
from app.dependencies import attempt_limiter as limiter_dependency
from app.dependencies import sign_in_cookies as cookies_dependency
from app.errors import InvalidError, MannerError
from app.pages import render
from app.security import AttemptLimiter, SignInCookies
from app.services import researchers
from app.services.researchers import Identity

router = APIRouter(prefix="/research", include_in_schema=False)

Cookies = Annotated[SignInCookies, Depends(cookies_dependency)]
Limiter = Annotated[AttemptLimiter, Depends(limiter_dependency)]
Field = Annotated[str, Form()]


@router.get("/set-up/{token}")
def show_set_up(request: Request, token: str, db: Reading) -> HTMLResponse:
    """The form that makes an account."""
    researchers.check_setup_link(db, token)
    return render(request, "set_up.html", error=None, email="", name="")


@router.post("/set-up/{token}", dependencies=[CsrfChecked])
def set_up(
    request: Request, token: str, db: Writing, cookies: Cookies,
    email: Field, name: Field, password: Field,
) -> Response:  # fmt: skip
    """Make the account and sign in."""
    researchers.check_setup_link(db, token)
    try:
        identity = researchers.set_up(db, token, email=email, name=name, password=password)
    except MannerError as error:
        return render(request, "set_up.html", status=422, error=error, email=email, name=name)
    return _signed_in(cookies, identity, "/research")


@router.get("/sign-in")
def show_sign_in(
    request: Request, researcher: MaybeResearcher, next: str = "/research"  # noqa: A002 -- its name in addresses
) -> Response:  # fmt: skip
    """The sign-in form."""
    if researcher:
        return RedirectResponse(_own_page(next), 303)
    return render(request, "sign_in.html", error=None, email="", next=_own_page(next))


@router.post("/sign-in", dependencies=[CsrfChecked])
def sign_in(
    request: Request, db: Reading, cookies: Cookies, limiter: Limiter,
    email: Field, password: Field, next: Field = "/research",  # noqa: A002 -- the form's name for it
) -> Response:  # fmt: skip
    """Check address and password."""
    address = request.client.host if request.client else "unknown"
    limiter.check(address)
    try:
        identity = researchers.sign_in(db, email, password)
    except InvalidError as error:
        limiter.count_failure(address)
        return render(
            request, "sign_in.html", status=422, error=error, email=email, next=_own_page(next)
        )
    return _signed_in(cookies, identity, _own_page(next))


@router.post("/sign-out", dependencies=[CsrfChecked])
def sign_out(cookies: Cookies) -> Response:
    """Forget who sits at this browser."""
    response = RedirectResponse("/", 303)
    response.delete_cookie(cookies.name, secure=cookies.secure, httponly=True)
    return response


def _signed_in(cookies: SignInCookies, identity: Identity, page: str) -> Response:
    response = RedirectResponse(page, 303)
    response.set_cookie(
        cookies.name,
        cookies.make(*identity),
        max_age=cookies.seconds,
        httponly=True,
        secure=cookies.secure,
        samesite="lax",
    )
    return response


def _own_page(address: str) -> str:
    """``address`` if it leads to a page of this server, so that no link can lure elsewhere."""
    inside = address.startswith("/") and not address.startswith(("//", "/\\"))
    return quote(address, safe="/?=&") if inside else "/research"
