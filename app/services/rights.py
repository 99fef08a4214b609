"""What a researcher may do with a study, and who its members are.

A viewer sees everything, an editor also changes the study and decides who counts, an owner also
decides who the members are and deletes. A study without members, such as the demonstration, belongs
to every researcher of the server.
"""

from __future__ import annotations

from typing import Literal, NamedTuple, cast

from sqlalchemy.orm import Session

from app.errors import ConflictError, ForbiddenError, NotFoundError
from app.persistence import members, researchers
from app.persistence import studies as store
from app.persistence.models import Researcher, Study
from app.schemas.live import Member, MemberList, Role
from app.services import audit
from app.services.studies import no_such_study

Act = Literal["view", "edit", "own"]
NEEDED: dict[Act, tuple[Role, ...]] = {
    "view": ("viewer", "editor", "owner"),
    "edit": ("editor", "owner"),
    "own": ("owner",),
}


class Access(NamedTuple):
    """A researcher who may do what was asked of a study."""

    study_id: int
    slug: str
    researcher_id: int
    role: Role


def role_of(db: Session, study_id: int, researcher_id: int) -> Role | None:
    """What a researcher is in a study; None for strangers."""
    role = members.role(db, study_id, researcher_id)
    if role is None and not members.count(db, study_id):
        return "owner"
    return cast("Role | None", role)


def may(db: Session, study: Study, researcher_id: int, act: Act) -> Role:
    """The researcher's role, if it allows the act.

    Raises:
        NotFoundError: no member; that there is such a study is nobody else's business.
        ForbiddenError: a member, but not of the role that this needs.
    """
    role = role_of(db, study.id, researcher_id)
    if role is None:
        raise no_such_study(study.slug)
    if role not in NEEDED[act]:
        needed = NEEDED[act][0]
        raise ForbiddenError(
            f"You are {role} of this study; this takes an {needed}.",
            code="role_too_low",
            where={"study": study.slug, "role": role},
            mend="Ask an owner of the study, who can change your role in its settings.",
        )
    return role


def access(db: Session, slug: str, researcher_id: int, act: Act) -> Access:
    """The same by the study's address.

    Raises:
        NotFoundError: no such study, or not the researcher's.
        ForbiddenError: as in `may`.
    """
    study = store.by_slug(db, slug)
    if study is None:
        raise no_such_study(slug)
    return Access(study.id, study.slug, researcher_id, may(db, study, researcher_id, act))


def visible(db: Session, researcher_id: int) -> dict[int, Role]:
    """Every study that a researcher may see, and as what."""
    everybodys: dict[int, Role] = dict.fromkeys(members.open_to_all(db), "owner")
    own = {study: cast("Role", role) for study, role in members.roles_of(db, researcher_id).items()}
    return {**everybodys, **own}


def make_owner(db: Session, study: Study, researcher_id: int) -> None:
    """Give a fresh study to who made it; the commit is the caller's."""
    members.put(db, study.id, researcher_id, "owner")


def member_list(db: Session, access: Access) -> MemberList:
    """A study's members, and what the asking one is."""
    found = members.listed(db, access.study_id)
    return MemberList(
        members=[
            Member(email=m.email, name=m.name, role=cast("Role", m.role),
                   you=m.researcher_id == access.researcher_id)
            for m in found
        ],
        role=access.role,
        everybodys=not found,
    )  # fmt: skip


def put_member(db: Session, access: Access, email: str, role: Role) -> MemberList:
    """Add a researcher of this server to a study, or change a member's role.

    In a study that was everybody's, who adds the first member stays in it as owner.

    Raises:
        NotFoundError: nobody has an account with this address.
        ConflictError: nobody would own the study any more.
    """
    members.lock(db, access.study_id)
    person = _person(db, email)
    if not members.count(db, access.study_id):
        _join(db, access, _known(db, access.researcher_id), "owner")
    before = members.role(db, access.study_id, person.id)
    if before == "owner" and role != "owner":
        _keep_an_owner(db, access.study_id)
    if before is None:
        _join(db, access, person, role)
    elif before != role:
        members.put(db, access.study_id, person.id, role)
        audit.note(
            db, access.study_id, "member_changed", access.researcher_id,
            email=person.email, role=role, before=before,
        )  # fmt: skip
    db.commit()
    return member_list(db, _again(db, access))


def remove_member(db: Session, access: Access, email: str) -> None:
    """Take a member out of a study. Whoever is no owner can take out only themselves.

    Raises:
        NotFoundError: nobody of this address is a member.
        ForbiddenError: another than oneself, and no owner.
        ConflictError: nobody would own the study any more.
    """
    members.lock(db, access.study_id)
    person = researchers.by_email(db, email)
    role = person and members.role(db, access.study_id, person.id)
    if person is None or role is None:
        raise NotFoundError(f"{email[:254]} is no member of this study.", code="member_not_found")
    if person.id != access.researcher_id and access.role != "owner":
        raise ForbiddenError(
            "Only an owner can take others out of a study.",
            code="role_too_low",
            mend="Ask an owner of the study.",
        )
    if role == "owner":
        _keep_an_owner(db, access.study_id)
    members.remove(db, access.study_id, person.id)
    audit.note(db, access.study_id, "member_removed", access.researcher_id, email=person.email)
    db.commit()


def _person(db: Session, email: str) -> Researcher:
    person = researchers.by_email(db, email.strip())
    if person is None:
        raise NotFoundError(
            f"Nobody with the address {email[:254]} has an account on this server.",
            code="researcher_not_found",
            where={"field": "email"},
            mend="Whoever runs the server can make them a link for one: manner set-up-link.",
        )
    return person


def _known(db: Session, researcher_id: int) -> Researcher:
    person = researchers.by_id(db, researcher_id)
    if person is None:
        raise NotFoundError("Your account is gone.", code="researcher_not_found")
    return person


def _join(db: Session, access: Access, person: Researcher, role: Role) -> None:
    members.put(db, access.study_id, person.id, role)
    audit.note(
        db, access.study_id, "member_added", access.researcher_id, email=person.email, role=role
    )


def _keep_an_owner(db: Session, study_id: int) -> None:
    if members.count(db, study_id, "owner") < 2:
        raise ConflictError(
            "This is the only owner, and a study needs one.",
            code="last_owner",
            mend="Make another member an owner first.",
        )


def _again(db: Session, access: Access) -> Access:
    """The same access with the role that the researcher has by now."""
    role = role_of(db, access.study_id, access.researcher_id)
    return access if role is None else access._replace(role=role)
