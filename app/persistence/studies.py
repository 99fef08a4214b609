"""Studies and the clips that they show."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from sqlalchemy import func, null, select
from sqlalchemy.orm import Session

from app.persistence.models import ClipRecord, FigureRecord, Study, StudySession, StudyVersion


class Media(NamedTuple):
    """What the viewer needs of a clip: content hashes of its bytes and of its figure's."""

    glb: str
    figure: str | None
    cyclic: bool


def by_slug(session: Session, slug: str, *, lock: bool = False) -> Study | None:
    """The study at this address; locked, one newcomer after the other looks for a free slot."""
    found = select(Study).where(Study.slug == slug)
    if lock:  # SQLite has one writer at a time anyway and leaves FOR UPDATE out
        found = found.with_for_update().execution_options(populate_existing=True)
    return session.scalar(found)


def by_id(session: Session, study_id: int) -> Study:
    """The study that a session belongs to."""
    return session.get_one(Study, study_id)


def newest_version(session: Session, study: Study) -> StudyVersion | None:
    """The version that new participants see."""
    return session.scalar(
        select(StudyVersion)
        .where(StudyVersion.study_id == study.id)
        .order_by(StudyVersion.number.desc())
        .limit(1)
    )


def version_by_id(session: Session, version_id: int) -> StudyVersion:
    """The version that a session belongs to."""
    return session.get_one(StudyVersion, version_id)


def all_studies(session: Session) -> list[Study]:
    """Every study, oldest first."""
    return list(session.scalars(select(Study).order_by(Study.id)))


def lock_all(session: Session) -> None:
    """Let nobody change a draft or publish until we are done; answers still come in."""
    session.execute(select(Study.id).order_by(Study.id).with_for_update(key_share=True))


def has_sessions(session: Session, study: Study) -> bool:
    """Whether anybody ever began the study."""
    found = select(StudySession.id).where(StudySession.study_id == study.id).limit(1)
    return session.scalar(found) is not None


def state_counts(session: Session) -> dict[tuple[int, str], int]:
    """How many participants each study has in each state; whom a researcher left out in none."""
    left_out = select(StudySession.id).where(StudySession.excluded.is_not(null()))
    rows = session.execute(
        select(StudySession.study_id, StudySession.state, func.count())
        .where(StudySession.kind == "participant", StudySession.id.not_in(left_out))
        .group_by(StudySession.study_id, StudySession.state)
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
