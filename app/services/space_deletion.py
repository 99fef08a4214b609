"""A space that no study needs is deleted; its clips stay, and so does what was made in it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from sqlalchemy.orm import Session

from app.errors import ConflictError, ForbiddenError
from app.persistence import spaces as store
from app.persistence import studies, study_versions
from app.persistence.models import Study
from app.persistence.spaces import Space
from app.schemas.spaces import Versions
from app.services import audit, rights, spaces, study_spaces
from app.services.spaces import Roles


def delete(db: Session, space_id: str, versions: Versions, researcher_id: int) -> None:
    """Delete a space, or every version of its name; all of them or none.

    Raises:
        NotFoundError: there is no such space.
        ForbiddenError: it is another researcher's, made of a study that one may not change.
        ConflictError: it comes with the server, or a study needs it.
    """
    studies.lock_all(db)
    space = spaces.find(db, space_id)
    going = store.versions(db, space.record.name) if versions == "all" else [space]
    roles = rights.visible(db, researcher_id)
    _refuse_others(going, roles, researcher_id)
    _refuse_used(db, going, roles)
    for one in going:
        record = one.record
        store.delete(db, record)
        if record.study_id is not None:
            audit.note(
                db, record.study_id, "space_deleted", researcher_id,
                name=record.name, number=record.number, space=record.id,
            )  # fmt: skip
    db.commit()


def _refuse_others(going: Sequence[Space], roles: Roles, researcher_id: int) -> None:
    for one in going:
        if one.record.made_by is None:
            raise ConflictError("Samples come with the server and stay.", code="sample_space")
        if not spaces.may_delete(one, roles, researcher_id):
            raise ForbiddenError(
                f"{_called([one])} was made of a study that you may not change.",
                code="role_too_low",
                where={"space": one.record.id},
                mend=f"Ask {one.made_by}, who made it.",
            )


def _refuse_used(db: Session, going: Sequence[Space], roles: Roles) -> None:
    """Raises where a draft or a published version names one of the spaces.

    A name stands for the newest space that has it, so that older ones can go.
    """
    wanted = {one.record.id for one in going}
    wanted |= {one.record.name for one in going if one.record.number == one.newest}
    published = {
        version.study_id
        for version in study_versions.with_spaces(db)
        if wanted & study_spaces.named(version.definition)
    }
    everything = studies.all_studies(db)
    drafted = {one.id for one in everything if wanted & study_spaces.named(one.draft)}
    if needed := [one for one in everything if one.id in published | drafted]:
        raise ConflictError(
            f"{_called(going)} is used by {_listed(needed, roles)}.",
            code="space_in_use",
            where={"studies": [one.slug for one in needed if one.id in roles]},
            mend="What a published study uses stays, so that it can be done again."
            if published
            else "Take it out of the draft first.",
        )


def _called(going: Sequence[Space]) -> str:
    first = going[0].record
    return f"“{first.name}”" if len(going) > 1 else f"“{first.name}”, version {first.number},"


def _listed(needed: Iterable[Study], roles: Roles) -> str:
    """Studies by their titles; of those that are not theirs to see, how many."""
    told = [f"the study “{one.title}”" for one in needed if one.id in roles]
    if others := sum(one.id not in roles for one in needed):
        told.append("a study of others" if others == 1 else f"{others} studies of others")
    return told[0] if len(told) == 1 else f"{', '.join(told[:-1])} and {told[-1]}"
