"""Who belongs to a study."""

from __future__ import annotations

from typing import NamedTuple

from sqlalchemy import delete, func, select
from sqlalchemy.orm import Session

from app.persistence.models import Researcher, Study, StudyMember


class MemberRow(NamedTuple):
    """A member as pages show one."""

    researcher_id: int
    email: str
    name: str
    role: str


def role(db: Session, study_id: int, researcher_id: int) -> str | None:
    """What a researcher is in a study, if anything."""
    member = db.get(StudyMember, (study_id, researcher_id))
    return member.role if member else None


def count(db: Session, study_id: int, role: str | None = None) -> int:
    """How many belong to a study, or have one role in it."""
    query = select(func.count()).select_from(StudyMember).where(StudyMember.study_id == study_id)
    if role is not None:
        query = query.where(StudyMember.role == role)
    return db.scalar(query) or 0


def put(db: Session, study_id: int, researcher_id: int, role: str) -> None:
    """Make a researcher a member, or change what the member may do."""
    db.merge(StudyMember(study_id=study_id, researcher_id=researcher_id, role=role))
    db.flush()


def remove(db: Session, study_id: int, researcher_id: int) -> None:
    """Take a researcher out of a study."""
    db.execute(
        delete(StudyMember).where(
            StudyMember.study_id == study_id, StudyMember.researcher_id == researcher_id
        )
    )


def listed(db: Session, study_id: int) -> list[MemberRow]:
    """A study's members, by address."""
    rows = db.execute(
        select(Researcher.id, Researcher.email, Researcher.name, StudyMember.role)
        .join(StudyMember, StudyMember.researcher_id == Researcher.id)
        .where(StudyMember.study_id == study_id)
        .order_by(Researcher.email)
    )
    return [MemberRow(*row) for row in rows]


def roles_of(db: Session, researcher_id: int) -> dict[int, str]:
    """A researcher's role in each study of theirs."""
    rows = db.execute(
        select(StudyMember.study_id, StudyMember.role).where(
            StudyMember.researcher_id == researcher_id
        )
    )
    return {row.study_id: row.role for row in rows}


def open_to_all(db: Session) -> set[int]:
    """The studies without members: they belong to every researcher."""
    member = select(StudyMember.study_id).where(StudyMember.study_id == Study.id).exists()
    return set(db.scalars(select(Study.id).where(~member)))


def lock(db: Session, study_id: int) -> None:
    """Let no other server process change a study's members until the end of the transaction."""
    db.execute(select(Study.id).where(Study.id == study_id).with_for_update())
