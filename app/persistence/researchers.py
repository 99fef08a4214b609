"""Researchers and the links by which their accounts are made."""

from __future__ import annotations

from datetime import datetime

from sqlalchemy import func, select, update
from sqlalchemy.orm import Session

from app.persistence.models import Researcher, SetupToken, now


def count(db: Session) -> int:
    """How many researchers there are."""
    return db.scalar(select(func.count()).select_from(Researcher)) or 0


def by_id(db: Session, researcher_id: int) -> Researcher | None:
    """The researcher with this number."""
    return db.get(Researcher, researcher_id)


def by_email(db: Session, email: str) -> Researcher | None:
    """The researcher with this address, which is stored in lower case."""
    return db.scalar(select(Researcher).where(Researcher.email == email.lower()))


def earliest(db: Session) -> Researcher | None:
    """Whoever set the server up."""
    return db.scalar(select(Researcher).order_by(Researcher.id).limit(1))


def add(db: Session, *, email: str, name: str, password_hash: str) -> Researcher:
    """Store a researcher."""
    researcher = Researcher(email=email.lower(), name=name, password_hash=password_hash)
    db.add(researcher)
    db.flush()
    return researcher


def add_token(db: Session, token_hash: str) -> None:
    """Store a set-up link's hash."""
    db.add(SetupToken(token_hash=token_hash))
    db.flush()


def token_is_open(db: Session, token_hash: str, since: datetime) -> bool:
    """Whether the link was made after ``since`` and not used yet."""
    token = db.get(SetupToken, token_hash)
    return token is not None and token.used_at is None and token.created_at >= since


def use_token(db: Session, token_hash: str, since: datetime) -> bool:
    """Mark the link used; false if it was not open. Of two at the same time one wins."""
    used = db.execute(
        update(SetupToken)
        .where(
            SetupToken.token_hash == token_hash,
            SetupToken.used_at.is_(None),
            SetupToken.created_at >= since,
        )
        .values(used_at=now())
        .returning(SetupToken.token_hash)
    )
    return used.first() is not None
