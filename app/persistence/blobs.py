"""Bytes under the hash of their content."""

from __future__ import annotations

import hashlib
from functools import cache
from typing import Any

from sqlalchemy import Insert, bindparam, delete, select
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.orm import Session

from app.persistence.models import Base, Blob, ClipRecord, FigureRecord, now

GLB = "model/gltf-binary"
CLIP = "application/x-manner-clip"
BVH = "text/x-bvh"


def put(db: Session, content: bytes, media_type: str) -> str:
    """Store the bytes unless they are there already; their hash."""
    digest = hashlib.sha256(content).hexdigest()
    values = {"hash": digest, "media_type": media_type, "content": content, "created_at": now()}
    insert_if_new(db, Blob, values)
    return digest


def insert_if_new(db: Session, table: type[Base], values: dict[str, Any]) -> bool:
    """Store a row unless one with its key is there; whether it was stored.

    Left to the database, because another server may store the same at the same moment. The
    statement is the same each time, without its values: SQLAlchemy then prepares it but once.
    """
    insert = _insert(db.get_bind().dialect.name, table, frozenset(values))
    return bool(db.connection().execute(insert, values).rowcount)


@cache
def _insert(dialect: str, table: type[Base], columns: frozenset[str]) -> Insert:
    kind = postgresql if dialect == "postgresql" else sqlite
    row: dict[str, Any] = {name: bindparam(name) for name in columns}
    insert = kind.insert(table.__table__).values(row).on_conflict_do_nothing()
    # PostgreSQL's driver has forgotten the number by the time that we ask, unless told to keep it.
    return insert.execution_options(preserve_rowcount=True)


def content(db: Session, digest: str, media_type: str | None = None) -> bytes | None:
    """The bytes with this hash, if they are of that type."""
    query = select(Blob.content).where(Blob.hash == digest)
    if media_type:
        query = query.where(Blob.media_type == media_type)
    return db.scalar(query)


def delete_orphans(db: Session, digests: set[str]) -> None:
    """Delete those of the named blobs that nothing refers to any more."""
    db.flush()
    if not digests:
        return
    columns = (
        ClipRecord.clip_blob,
        ClipRecord.glb_blob,
        ClipRecord.source_blob,
        FigureRecord.glb_blob,
    )
    orphans = delete(Blob).where(Blob.hash.in_(digests))
    for column in columns:
        orphans = orphans.where(~select(column).where(column == Blob.hash).exists())
    db.execute(orphans)
