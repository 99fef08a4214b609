"""Researchers' accounts: made by a one-time link, entered by a password."""

from __future__ import annotations

import hashlib
import secrets
from datetime import timedelta
from functools import cache
from threading import BoundedSemaphore
from typing import NamedTuple

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerifyMismatchError
from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError, NotFoundError
from app.persistence import researchers
from app.persistence.models import Researcher, now

SHORTEST_PASSWORD = 12
LINK_LIFETIME = timedelta(days=3)

_hasher = PasswordHasher()
# Each hash takes 64 MB: many at once, which a stranger can ask for, would exhaust a small machine.
_at_once = BoundedSemaphore(4)


class Identity(NamedTuple):
    """What a sign-in cookie says: who, and a mark that changes with the password."""

    researcher_id: int
    password_mark: str


def any_exists(db: Session) -> bool:
    """Whether somebody can sign in at all."""
    return researchers.count(db) > 0


def make_setup_link(db: Session, public_url: str) -> str:
    """A fresh one-time link; the database keeps its hash only."""
    token = secrets.token_urlsafe(24)
    researchers.add_token(db, _hash(token))
    db.commit()
    return f"{public_url}/research/set-up/{token}"


def check_setup_link(db: Session, token: str) -> None:
    """Raise NotFoundError unless the link still leads somewhere."""
    if not researchers.token_is_open(db, _hash(token), now() - LINK_LIFETIME):
        raise _link_used_up()


def set_up(db: Session, token: str, *, email: str, name: str, password: str) -> Identity:
    """Make an account with a one-time link, which is then used up."""
    email, name = email.strip(), name.strip()
    _check_account(email, name)
    password_hash = _hash_password(password)
    if not researchers.use_token(db, _hash(token), now() - LINK_LIFETIME):
        raise _link_used_up()
    if researchers.by_email(db, email):
        raise ConflictError(
            f"There is an account for {email} already.",
            code="email_taken",
            where={"field": "email"},
            mend="Sign in, or use another address.",
        )
    researcher = researchers.add(db, email=email, name=name, password_hash=password_hash)
    db.commit()
    return _identity(researcher)


def sign_in(db: Session, email: str, password: str) -> Identity:
    """The researcher's identity, if address and password fit together.

    Raises:
        InvalidError: if not; it does not say which of the two is wrong.
    """
    researcher = researchers.by_email(db, email.strip())
    # An unknown address costs the same time as a wrong password, so that none can be found out.
    known_hash = researcher.password_hash if researcher else _nobodys_hash()
    try:
        with _at_once:
            _hasher.verify(known_hash, password)
    except (VerifyMismatchError, InvalidHashError):
        researcher = None
    if researcher is None:
        raise InvalidError(
            "This address and password do not fit together.",
            code="sign_in_failed",
            mend="Check both. Whoever runs the server can reset a password: manner reset-password.",
        )
    return _identity(researcher)


def signed_in(db: Session, researcher_id: int, password_mark: str) -> Researcher | None:
    """The researcher of a cookie; a changed password ends all earlier sign-ins."""
    researcher = researchers.by_id(db, researcher_id)
    if researcher is None or _identity(researcher).password_mark != password_mark:
        return None
    return researcher


def reset_password(db: Session, email: str, password: str) -> None:
    """Give an account a new password."""
    researcher = researchers.by_email(db, email)
    if researcher is None:
        raise NotFoundError(f"There is no account for {email}.", code="researcher_not_found")
    researcher.password_hash = _hash_password(password)
    db.commit()


def _identity(researcher: Researcher) -> Identity:
    return Identity(researcher.id, _hash(researcher.password_hash)[:16])


def _check_account(email: str, name: str) -> None:
    local, at, host = email.partition("@")
    if not (local and at and "." in host) or len(email) > 254 or " " in email:
        raise InvalidError(f"“{email}” is no e-mail address.", where={"field": "email"})
    if not 1 <= len(name) <= 200:
        raise InvalidError("Please give your name.", where={"field": "name"})


def _hash_password(password: str) -> str:
    if not SHORTEST_PASSWORD <= len(password) <= 1000:
        raise InvalidError(
            f"The password needs at least {SHORTEST_PASSWORD} characters.",
            code="password_too_short",
            where={"field": "password"},
            mend="Take a few words in a row: easy to keep in mind, hard to guess.",
        )
    with _at_once:
        return _hasher.hash(password)


@cache
def _nobodys_hash() -> str:
    return _hasher.hash(secrets.token_urlsafe(16))


def _link_used_up() -> NotFoundError:
    return NotFoundError(
        "This set-up link was used already, or is older than three days.",
        code="setup_link_used_up",
        mend="Sign in, or let whoever runs the server make a new link: manner set-up-link.",
    )


def _hash(secret: str) -> str:
    return hashlib.sha256(secret.encode()).hexdigest()
