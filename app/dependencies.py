"""What routes ask for: database sessions, settings, the signed-in researcher."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from fastapi import Depends, Request
from sqlalchemy.orm import Session

from app.errors import SignInNeededError
from app.persistence.engine import Database
from app.persistence.models import Researcher
from app.persistence.writer import Writer
from app.security import AttemptLimiter, SignInCookies
from app.services import researchers

# Those that only look something up are async: a plain function would cost a turn in a thread.


async def _database(request: Request) -> Database:
    database: Database = request.app.state.database
    return database


def _reading(database: Annotated[Database, Depends(_database)]) -> Iterator[Session]:
    with database.reading() as session:
        yield session


def _writing(database: Annotated[Database, Depends(_database)]) -> Iterator[Session]:
    with database.writing() as session:
        yield session


async def _writer(request: Request) -> Writer:
    writer: Writer = request.app.state.writer
    return writer


CurrentDatabase = Annotated[Database, Depends(_database)]
CurrentWriter = Annotated[Writer, Depends(_writer)]
Reading = Annotated[Session, Depends(_reading)]
Writing = Annotated[Session, Depends(_writing)]


async def sign_in_cookies(request: Request) -> SignInCookies:
    """The maker and reader of sign-in cookies."""
    cookies: SignInCookies = request.app.state.sign_in_cookies
    return cookies


async def attempt_limiter(request: Request) -> AttemptLimiter:
    """The brake on guessing passwords."""
    limiter: AttemptLimiter = request.app.state.attempt_limiter
    return limiter


def maybe_researcher(request: Request, database: CurrentDatabase) -> Researcher | None:
    """The researcher who is signed in on this browser; pages show the name."""
    cookies: SignInCookies = request.app.state.sign_in_cookies
    known = cookies.read(request.cookies.get(cookies.name))
    researcher = None
    if known:
        with database.reading() as session:
            researcher = researchers.signed_in(session, *known)
    request.state.researcher = researcher
    return researcher


MaybeResearcher = Annotated[Researcher | None, Depends(maybe_researcher)]


def signed_in_researcher(researcher: MaybeResearcher) -> Researcher:
    """The signed-in researcher, or an answer that leads to the sign-in page."""
    if researcher is None:
        raise SignInNeededError(
            "Only a signed-in researcher may do this.", mend="Sign in and try again."
        )
    return researcher


SignedIn = Annotated[Researcher, Depends(signed_in_researcher)]


async def csrf_checked(request: Request) -> None:
    """Refuse a write that did not start on one of our own pages.

    Scripts send the token as ``X-CSRF-Token``, forms as the field ``csrf_token``.
    """
    token = request.headers.get("x-csrf-token")
    if token is None:
        field = (await request.form()).get("csrf_token")
        token = field if isinstance(field, str) else None
    request.state.csrf.check(token)


CsrfChecked = Depends(csrf_checked)
