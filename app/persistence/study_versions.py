"""Published versions of studies, and what hangs on a study that was never published."""

from __future__ import annotations

from sqlalchemy import Text, cast, delete, func, select
from sqlalchemy.orm import Session

from app.persistence.models import (
    AuditEntry,
    ImpressionChoices,
    Study,
    StudyMember,
    StudySession,
    StudyVersion,
)


def versions(session: Session, study: Study) -> list[StudyVersion]:
    """Every version of the study, the newest first."""
    return list(
        session.scalars(
            select(StudyVersion)
            .where(StudyVersion.study_id == study.id)
            .order_by(StudyVersion.number.desc())
        )
    )


def version(session: Session, study: Study, number: int) -> StudyVersion | None:
    """The version of this number."""
    return session.scalar(
        select(StudyVersion).where(StudyVersion.study_id == study.id, StudyVersion.number == number)
    )


def with_spaces(session: Session) -> list[StudyVersion]:
    """Every version, of any study, that may name an authoring space."""
    query = select(StudyVersion).where(cast(StudyVersion.definition, Text).contains('"space"'))
    return list(session.scalars(query))


def newest_numbers(session: Session) -> dict[int, int]:
    """The number of each study's newest version."""
    rows = session.execute(
        select(StudyVersion.study_id, func.max(StudyVersion.number)).group_by(StudyVersion.study_id)
    )
    return dict(rows.all())


def begun(session: Session, study: Study) -> dict[int, int]:
    """How many participants began each version, by the version's id."""
    rows = session.execute(
        select(StudySession.version_id, func.count())
        .where(StudySession.study_id == study.id, StudySession.kind == "participant")
        .group_by(StudySession.version_id)
    )
    return dict(rows.all())


def drop(session: Session, study: Study) -> None:
    """Delete a study with its members, versions and history; nobody may have begun it."""
    for kind in (StudyMember, AuditEntry, StudyVersion, ImpressionChoices):
        session.execute(delete(kind).where(kind.study_id == study.id))
    session.delete(study)
    session.flush()
