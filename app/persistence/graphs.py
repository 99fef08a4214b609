"""Motion graphs."""

from __future__ import annotations

import uuid
from collections.abc import Iterable

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.persistence.models import Blob, ClipRecord, FigureRecord, GraphRecord


def listed(db: Session) -> list[GraphRecord]:
    """All graphs, oldest first."""
    return list(db.scalars(select(GraphRecord).order_by(GraphRecord.created_at, GraphRecord.id)))


def by_id(db: Session, graph_id: uuid.UUID) -> GraphRecord | None:
    """The graph with this id."""
    return db.get(GraphRecord, graph_id)


def add(db: Session, graph: GraphRecord) -> GraphRecord:
    """Store a new graph."""
    db.add(graph)
    db.flush()
    return graph


def delete(db: Session, graph: GraphRecord) -> None:
    """Delete a graph; its clips stay."""
    db.delete(graph)
    db.flush()


def members(db: Session, clip_ids: Iterable[str]) -> dict[str, tuple[ClipRecord, str | None]]:
    """Clips by id, each with its figure's hash; those that are gone are left out."""
    rows = db.execute(
        select(ClipRecord, FigureRecord.glb_blob)
        .outerjoin(FigureRecord, FigureRecord.skeleton_hash == ClipRecord.skeleton_hash)
        .where(ClipRecord.id.in_(set(clip_ids)))
    )
    return {clip.id: (clip, figure) for clip, figure in rows}


def contents(db: Session, hashes: Iterable[str]) -> dict[str, bytes]:
    """Stored bytes by their hash."""
    rows = db.execute(select(Blob.hash, Blob.content).where(Blob.hash.in_(set(hashes))))
    return {row.hash: row.content for row in rows}
