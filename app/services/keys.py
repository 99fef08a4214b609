"""API keys: programs call the API with them in a researcher's name."""

from __future__ import annotations

import hashlib
import secrets
import threading
from datetime import timedelta
from functools import partial

from sqlalchemy.orm import Session

from app.errors import InvalidError, NotFoundError, SignInNeededError
from app.persistence import keys
from app.persistence.models import ApiKey, now
from app.persistence.writer import Writer
from app.schemas.keys import KeyView, NewKey, Scope

PREFIX = "mnr_"  # by which people and secret scanners know what they have found
NOTED_EVERY = timedelta(minutes=1)


def make(db: Session, researcher_id: int, name: str, scope: Scope) -> NewKey:
    """A fresh key. The database keeps its hash only: nobody can be shown it again.

    Raises:
        InvalidError: the name is empty or too long.
    """
    name = name.strip()
    if not 1 <= len(name) <= 200:
        raise InvalidError(
            "The key needs a name.",
            code="key_name",
            where={"field": "name"},
            mend="Say what it is for, in 200 characters or fewer.",
        )
    secret = PREFIX + secrets.token_urlsafe(32)
    key = ApiKey(
        researcher_id=researcher_id, name=name, hint=secret[-4:], key_hash=_hash(secret),
        scope=scope,
    )  # fmt: skip
    keys.add(db, key)
    db.commit()
    return NewKey(secret=secret, key=KeyView.model_validate(key))


def listed(db: Session, researcher_id: int) -> list[KeyView]:
    """A researcher's keys, the newest first; revoked ones stay, so that their use can be traced."""
    return [KeyView.model_validate(key) for key in keys.of_researcher(db, researcher_id)]


def revoke(db: Session, researcher_id: int, key_id: int) -> None:
    """Let a key open nothing from now on.

    Raises:
        NotFoundError: the researcher has no such key.
    """
    if not keys.revoke(db, researcher_id, key_id, now()):
        raise NotFoundError("There is no such key.", code="key_not_found")
    db.commit()


def find(db: Session, secret: str) -> ApiKey:
    """The key that a program has shown.

    There is no brake on guessing as there is for passwords: a key has 256 random bits, and a
    million guesses a second would take longer than the sun lasts.

    Raises:
        SignInNeededError: it is none of ours, or was revoked. Which of the two is not said.
    """
    key = keys.by_hash(db, _hash(secret))
    if key is None or key.revoked_at is not None:
        raise SignInNeededError(
            "This API key is unknown, or was revoked.",
            code="key_unknown",
            mend="Check that it was copied whole, or make another one under API keys.",
        )
    return key


class KeyUses:
    """Writes down when keys were last used: to the minute, and behind the requests' backs.

    A request that only reads should not wait for the database's one write lock, so the note goes
    to the writer's queue and nobody waits for it. One that is lost is replaced by the next.
    """

    def __init__(self) -> None:
        self._under_way: set[int] = set()
        self._gate = threading.Lock()

    def note(self, writer: Writer, key: ApiKey) -> None:
        """Queue the note, unless one was made within the last minute or is being made."""
        at = now()
        due = at - NOTED_EVERY
        if key.last_used_at is not None and key.last_used_at > due:
            return
        with self._gate:
            if key.id in self._under_way:
                return
            self._under_way.add(key.id)
        job = partial(keys.set_last_used, key_id=key.id, at=at, unless_since=due)
        noted = writer.submit(job)
        noted.add_done_callback(lambda _: self._under_way.discard(key.id))


def _hash(secret: str) -> str:
    # A fast hash is right here. A slow one protects what people choose and others may guess from
    # a stolen table; nobody guesses 256 random bits, and every request would pay for it.
    return hashlib.sha256(secret.encode()).hexdigest()
