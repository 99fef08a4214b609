"""API keys, found by their hashes."""

from __future__ import annotations

from datetime import datetime

from sqlalchemy import or_, select, update
from sqlalchemy.orm import Session

from app.persistence.models import ApiKey


def add(db: Session, key: ApiKey) -> ApiKey:
    """Store a key."""
    db.add(key)
    db.flush()
    return key


def by_hash(db: Session, key_hash: str) -> ApiKey | None:
    """The key with this hash, revoked or not."""
    return db.scalar(select(ApiKey).where(ApiKey.key_hash == key_hash))


def of_researcher(db: Session, researcher_id: int) -> list[ApiKey]:
    """A researcher's keys, the newest first, revoked ones too."""
    query = select(ApiKey).where(ApiKey.researcher_id == researcher_id)
    return list(db.scalars(query.order_by(ApiKey.created_at.desc(), ApiKey.id.desc())))


def revoke(db: Session, researcher_id: int, key_id: int, at: datetime) -> bool:
    """Mark a researcher's key revoked; false if this researcher has none with this number."""
    key = db.get(ApiKey, key_id)
    if key is None or key.researcher_id != researcher_id:
        return False
    key.revoked_at = key.revoked_at or at
    db.flush()
    return True


def set_last_used(db: Session, key_id: int, at: datetime, unless_since: datetime) -> None:
    """Write down when a key was used, unless another server has done so since."""
    stale = or_(ApiKey.last_used_at.is_(None), ApiKey.last_used_at < unless_since)
    db.execute(update(ApiKey).where(ApiKey.id == key_id, stale).values(last_used_at=at))
