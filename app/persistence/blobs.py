"""Bytes under the hash of their content."""

from __future__ import annotations

import hashlib

from sqlalchemy import delete, select
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.orm import Session

from app.persistence.models import Blob, ClipRecord, FigureRecord

GLB = "model/gltf-binary"
CLIP = "application/x-manner-clip"
BVH = "text/x-bvh"


def put(db: Session, content: bytes, media_type: str) -> str:
    """Store the bytes unless they are there already; their hash."""
    digest = hashlib.sha256(content).hexdigest()
    dialect = postgresql if db.get_bind().dialect.name == "postgresql" else sqlite
    statement = dialect.insert(Blob).values(hash=digest, media_type=media_type, content=content)
    db.execute(statement.on_conflict_do_nothing(index_elements=[Blob.hash]))
    return digest


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
