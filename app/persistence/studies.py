"""Studies and the clips that they show."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.persistence.models import ClipRecord, FigureRecord, Study, StudySession


class Media(NamedTuple):
    """What the viewer needs of a clip: content hashes of its bytes and of its figure's."""

    glb: str
    figure: str | None
    cyclic: bool


def by_slug(session: Session, slug: str) -> Study | None:
    """The study at this address."""
    return session.scalar(select(Study).where(Study.slug == slug))


def by_id(session: Session, study_id: int) -> Study:
    """The study that a session belongs to."""
    return session.get_one(Study, study_id)


def all_studies(session: Session) -> list[Study]:
    """Every study, oldest first."""
    return list(session.scalars(select(Study).order_by(Study.id)))


def has_sessions(session: Session, study: Study) -> bool:
    """Whether anybody ever began the study."""
    found = select(StudySession.id).where(StudySession.study_id == study.id).limit(1)
    return session.scalar(found) is not None


def state_counts(session: Session) -> dict[tuple[int, str], int]:
    """How many sessions each study has in each state."""
    rows = session.execute(
        select(StudySession.study_id, StudySession.state, func.count()).group_by(
            StudySession.study_id, StudySession.state
        )
    )
    return {(study, state): count for study, state, count in rows}


def sample_clips(session: Session, sample_set: str) -> list[ClipRecord]:
    """The library's sample clips of one set, by name."""
    found = session.scalars(
        select(ClipRecord)
        .where(ClipRecord.source == "sample", ClipRecord.state == "kept")
        .order_by(ClipRecord.name)
    )
    return [clip for clip in found if clip.tags.get("set") == sample_set]


def media(session: Session, clips: Iterable[str]) -> dict[str, Media]:
    """What the viewer needs, by clip."""
    rows = session.execute(
        select(ClipRecord.id, ClipRecord.glb_blob, FigureRecord.glb_blob, ClipRecord.cyclic)
        .outerjoin(FigureRecord, FigureRecord.skeleton_hash == ClipRecord.skeleton_hash)
        .where(ClipRecord.id.in_(set(clips)))
    )
    return {clip: Media(glb, figure, cyclic) for clip, glb, figure, cyclic in rows}
