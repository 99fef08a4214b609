"""API keys: what opens, what does not, and what is kept of them."""

from __future__ import annotations

from datetime import timedelta

import pytest
from sqlalchemy import update
from sqlalchemy.orm import Session

from app.errors import InvalidError, NotFoundError, SignInNeededError
from app.persistence import keys as stored
from app.persistence import researchers
from app.persistence.engine import Database, make_engine
from app.persistence.models import ApiKey, now
from app.persistence.writer import Writer
from app.services import keys


@pytest.fixture
def owner(db: Session) -> int:
    added = researchers.add(db, email="rosa@example.org", name="Rosa", password_hash="-")
    return added.id


def test_a_key_is_long_random_and_known_again_by_its_last_characters(
    db: Session, owner: int
) -> None:
    made = [keys.make(db, owner, "notebook", "read") for _ in range(2)]
    assert made[0].secret != made[1].secret
    for new in made:
        assert new.secret.startswith("mnr_")
        assert len(new.secret.removeprefix("mnr_")) == 43  # 32 bytes
        assert new.key.hint == new.secret[-4:]
        assert keys.find(db, new.secret).id == new.key.id


def test_the_database_does_not_hold_the_key(db: Session, owner: int) -> None:
    made = keys.make(db, owner, "notebook", "write")
    kept = keys.find(db, made.secret)
    values = [str(getattr(kept, column.key)) for column in ApiKey.__table__.columns]
    assert all(made.secret not in value for value in values)


@pytest.mark.parametrize("spoil", [lambda key: key[:-1], lambda key: key + "x", lambda _: ""])
def test_a_key_that_is_not_whole_opens_nothing(db: Session, owner: int, spoil) -> None:
    made = keys.make(db, owner, "notebook", "read")
    with pytest.raises(SignInNeededError, match="unknown"):
        keys.find(db, spoil(made.secret))


def test_a_revoked_key_opens_nothing_and_stays_listed(db: Session, owner: int) -> None:
    made = keys.make(db, owner, "notebook", "read")
    keys.revoke(db, owner, made.key.id)
    with pytest.raises(SignInNeededError) as refused:
        keys.find(db, made.secret)
    assert refused.value.code == "key_unknown"
    (shown,) = keys.listed(db, owner)
    assert shown.revoked_at is not None
    keys.revoke(db, owner, made.key.id)
    assert keys.listed(db, owner) == [shown]  # the first time counts


def test_nobody_sees_or_revokes_the_keys_of_others(db: Session, owner: int) -> None:
    other = researchers.add(db, email="max@example.org", name="Max", password_hash="-")
    made = keys.make(db, owner, "notebook", "read")
    assert keys.listed(db, other.id) == []
    with pytest.raises(NotFoundError):
        keys.revoke(db, other.id, made.key.id)
    assert keys.find(db, made.secret).id == made.key.id


@pytest.mark.parametrize("name", ["", "  ", "x" * 201])
def test_a_key_needs_a_name_that_fits(db: Session, owner: int, name: str) -> None:
    with pytest.raises(InvalidError):
        keys.make(db, owner, name, "read")
    assert keys.listed(db, owner) == []


def test_use_is_noted_behind_the_request_and_at_most_once_a_minute(database_url: str) -> None:
    database = Database(make_engine(database_url))
    with database.writing() as db:
        owner = researchers.add(db, email="rosa@example.org", name="Rosa", password_hash="-").id
        secret = keys.make(db, owner, "notebook", "read").secret
    uses = keys.KeyUses()

    def use() -> ApiKey:
        writer = Writer(database)
        with database.reading() as db:
            uses.note(writer, keys.find(db, secret))
        writer.close()
        with database.reading() as db:
            return keys.find(db, secret)

    first = use().last_used_at
    assert first is not None
    assert abs(now() - first) < timedelta(minutes=5)
    assert use().last_used_at == first
    long_ago = now() - timedelta(minutes=2)
    with database.writing() as db:
        stored.set_last_used(db, keys.find(db, secret).id, long_ago, unless_since=now())
        db.commit()
    assert use().last_used_at >= first
    database.engine.dispose()


def test_while_the_database_is_busy_a_use_waits_once_and_nobody_with_it(
    database_url: str,
) -> None:
    database = Database(make_engine(database_url))
    with database.writing() as db:
        owner = researchers.add(db, email="rosa@example.org", name="Rosa", password_hash="-").id
        secret = keys.make(db, owner, "notebook", "read").secret
    writer, uses = Writer(database), keys.KeyUses()
    queued = []
    submit = writer.submit
    writer.submit = lambda job: queued.append(job) or submit(job)  # type: ignore[method-assign] -- listens
    with database.writing() as busy:
        busy.execute(update(ApiKey).values(name="busy"))  # holds SQLite's write lock
        with database.reading() as db:
            for _ in range(50):
                uses.note(writer, keys.find(db, secret))
        assert len(queued) == 1
        busy.rollback()
    writer.close()
    with database.reading() as db:
        assert keys.find(db, secret).last_used_at is not None
    database.engine.dispose()
