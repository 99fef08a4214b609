"""What routes ask for: database sessions, settings, the signed-in researcher."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, NamedTuple

from fastapi import Depends, Request, Security
from fastapi.security import HTTPBearer
from sqlalchemy.orm import Session

from app.errors import ForbiddenError, SignInNeededError
from app.persistence.engine import Database
from app.persistence.models import Researcher
from app.persistence.writer import Writer
from app.security import AttemptLimiter, MotionLimiter, SignInCookies
from app.services import keys, researchers, rights
from app.services.keys import KeyUses
from app.services.rights import Access
from app.settings import Settings
from app.workers import Workers

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


async def _workers(request: Request) -> Workers:
    workers: Workers = request.app.state.workers
    return workers


async def _signing_key(request: Request) -> str:
    settings: Settings = request.app.state.settings
    return settings.signing_key


SigningKey = Annotated[str, Depends(_signing_key)]
CurrentDatabase = Annotated[Database, Depends(_database)]
CurrentWriter = Annotated[Writer, Depends(_writer)]
CurrentWorkers = Annotated[Workers, Depends(_workers)]
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


async def motion_limiter(request: Request) -> MotionLimiter:
    """The brake on asking for motions."""
    limiter: MotionLimiter = request.app.state.motion_limiter
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


class Caller(NamedTuple):
    """Who calls the API: a signed-in researcher, or a program with a key of one."""

    researcher_id: int
    may_write: bool
    by_key: bool


def maybe_caller(
    request: Request, database: CurrentDatabase, writer: CurrentWriter
) -> Caller | None:
    """Who calls, if anybody known. A key goes before the cookie.

    Raises:
        SignInNeededError: the key is wrong or revoked. Also where none is needed: the program
            believes that it is known, and would otherwise wonder why it sees so little.
    """
    secret = _bearer(request)
    if secret is None:
        researcher = maybe_researcher(request, database)
        return Caller(researcher.id, may_write=True, by_key=False) if researcher else None
    with database.reading() as session:
        key = keys.find(session, secret)
    uses: KeyUses = request.app.state.key_uses
    uses.note(writer, key)
    return Caller(key.researcher_id, may_write=key.scope == "write", by_key=True)


_key_scheme = HTTPBearer(
    scheme_name="API key",
    bearerFormat="mnr_…",
    description="Made in the researchers' pages under API keys, for reading or also for writing.",
    auto_error=False,  # only tells the OpenAPI document; our own check tells more
)
MaybeCaller = Annotated[Caller | None, Depends(maybe_caller)]


async def reader(caller: MaybeCaller, _: Annotated[object, Security(_key_scheme)]) -> Caller:
    """Whoever has a key of either scope, or is signed in."""
    if caller is None:
        raise SignInNeededError(
            "This needs an API key.",
            code="key_needed",
            mend="Send the header “Authorization: Bearer mnr_…”, or sign in on this browser.",
        )
    return caller


Reader = Annotated[Caller, Depends(reader)]


async def key_writer(request: Request, caller: Reader) -> Caller:
    """Whoever has a key for writing, or is signed in and calls from one of our own pages."""
    if not caller.may_write:
        raise ForbiddenError(
            "This API key may only read.",
            code="read_only_key",
            mend="Use a key that may write; they are made under API keys.",
        )
    # Browsers send cookies along with requests that foreign pages start, but never keys.
    if not caller.by_key:
        request.state.csrf.check(request.headers.get("x-csrf-token"))
    return caller


KeyWriter = Annotated[Caller, Depends(key_writer)]


async def study_caller(request: Request, caller: Reader) -> Caller:
    """Whoever calls about a study. A change needs a key for writing, or comes from our own pages.

    The token against forgery may stand in the header or, of a form, in its field.
    """
    if request.method in ("GET", "HEAD"):
        return caller
    if caller.by_key:
        return await key_writer(request, caller)
    await csrf_checked(request)
    return caller


StudyCaller = Annotated[Caller, Depends(study_caller)]


def study_viewer(slug: str, caller: StudyCaller, database: CurrentDatabase) -> Access:
    """Whoever may see the study of this address."""
    return _access(slug, caller, database, "view")


def study_editor(slug: str, caller: StudyCaller, database: CurrentDatabase) -> Access:
    """Whoever may change the study of this address."""
    return _access(slug, caller, database, "edit")


def study_owner(slug: str, caller: StudyCaller, database: CurrentDatabase) -> Access:
    """Whoever owns the study of this address."""
    return _access(slug, caller, database, "own")


# For pages as well as for the API: of a page, who is not signed in is led to the sign-in page.
StudyViewer = Annotated[Access, Depends(study_viewer)]
StudyEditor = Annotated[Access, Depends(study_editor)]
StudyOwner = Annotated[Access, Depends(study_owner)]


def _access(slug: str, caller: Caller, database: Database, act: rights.Act) -> Access:
    with database.reading() as session:
        return rights.access(session, slug, caller.researcher_id, act)


async def maybe_reader(caller: MaybeCaller) -> bool:
    """Whether the caller may see more than samples."""
    return caller is not None


MaybeReader = Annotated[bool, Depends(maybe_reader)]


def _bearer(request: Request) -> str | None:
    """The key in the header; a header of another kind may be meant for a proxy before us."""
    scheme, _, secret = request.headers.get("authorization", "").partition(" ")
    return secret.strip() if scheme.lower() == "bearer" else None
