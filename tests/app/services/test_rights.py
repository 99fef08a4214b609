"""Who may do what with a study."""

from __future__ import annotations

from datetime import timedelta

import pytest
from sqlalchemy.orm import Session

from app.errors import ConflictError, ForbiddenError, NotFoundError
from app.persistence.models import Researcher, Study
from app.schemas.study import Running
from app.services import audit, publishing, rights

MAY = {"owner": {"view", "edit", "own"}, "editor": {"view", "edit"}, "viewer": {"view"}}


@pytest.fixture
def people(db: Session) -> dict[str, int]:
    names = ("olga", "edith", "vera", "sam")
    found = [Researcher(email=f"{n}@example.org", name=n, password_hash="-") for n in names]
    db.add_all(found)
    db.flush()
    return {one.name: one.id for one in found}


@pytest.fixture
def study(db: Session, people: dict[str, int]) -> Study:
    study = Study(slug="walks", title="Walks")
    db.add(study)
    db.flush()
    rights.make_owner(db, study, people["olga"])
    olga = rights.access(db, "walks", people["olga"], "own")
    rights.put_member(db, olga, "edith@example.org", "editor")
    rights.put_member(db, olga, "VERA@example.org", "viewer")
    return study


@pytest.mark.parametrize(
    ("name", "role"), [("olga", "owner"), ("edith", "editor"), ("vera", "viewer")]
)
def test_a_role_allows_its_acts_and_no_other(db, people, study, name, role):
    for act in sorted(MAY["owner"]):
        if act in MAY[role]:
            assert rights.may(db, study, people[name], act) == role
        else:
            with pytest.raises(ForbiddenError, match=f"You are {role}"):
                rights.may(db, study, people[name], act)


def test_a_stranger_is_told_that_there_is_no_such_study(db, people, study):
    with pytest.raises(NotFoundError) as stranger:
        rights.access(db, "walks", people["sam"], "view")
    with pytest.raises(NotFoundError) as nothing:
        rights.access(db, "walkz", people["sam"], "view")
    assert stranger.value.message.replace("walks", "walkz") == nothing.value.message


def test_a_study_without_members_belongs_to_everybody(db, people, study):
    demonstration = Study(slug="demo", title="Demo")
    db.add(demonstration)
    db.flush()
    assert rights.may(db, demonstration, people["sam"], "own") == "owner"
    assert rights.visible(db, people["sam"]) == {demonstration.id: "owner"}
    assert rights.visible(db, people["vera"]) == {demonstration.id: "owner", study.id: "viewer"}


def test_who_adds_the_first_member_to_everybodys_study_stays_its_owner(db, people):
    db.add(Study(slug="demo", title="Demo"))
    db.flush()
    sam = rights.access(db, "demo", people["sam"], "own")
    listed = rights.put_member(db, sam, "vera@example.org", "viewer")
    told = {one.email: (one.role, one.you) for one in listed.members}
    assert told == {
        "sam@example.org": ("owner", True),
        "vera@example.org": ("viewer", False),
    }
    with pytest.raises(NotFoundError):
        rights.access(db, "demo", people["olga"], "view")


def test_the_last_owner_can_neither_leave_nor_step_down(db, people, study):
    olga = rights.access(db, "walks", people["olga"], "own")
    with pytest.raises(ConflictError, match="only owner"):
        rights.remove_member(db, olga, "olga@example.org")
    with pytest.raises(ConflictError, match="only owner"):
        rights.put_member(db, olga, "olga@example.org", "viewer")
    rights.put_member(db, olga, "edith@example.org", "owner")
    rights.remove_member(db, olga, "olga@example.org")
    assert rights.role_of(db, study.id, people["olga"]) is None
    assert rights.role_of(db, study.id, people["edith"]) == "owner"


def test_a_viewer_may_leave_but_take_nobody_along(db, people, study):
    vera = rights.access(db, "walks", people["vera"], "view")
    with pytest.raises(ForbiddenError):
        rights.remove_member(db, vera, "edith@example.org")
    rights.remove_member(db, vera, "vera@example.org")
    assert rights.role_of(db, study.id, people["vera"]) is None


def test_only_who_has_an_account_can_be_added(db, people, study):
    olga = rights.access(db, "walks", people["olga"], "own")
    with pytest.raises(NotFoundError) as nobody:
        rights.put_member(db, olga, "nobody@example.org", "viewer")
    assert "set-up-link" in (nobody.value.mend or "")


def test_every_change_of_members_is_in_the_audit_trail(db, people, study):
    olga = rights.access(db, "walks", people["olga"], "own")
    rights.put_member(db, olga, "vera@example.org", "editor")
    rights.put_member(db, olga, "vera@example.org", "editor")  # changes nothing
    rights.remove_member(db, olga, "vera@example.org")
    told = [(one.who, one.sentence) for one in audit.trail(db, study.id).entries]
    assert told == [
        ("olga", "took vera@example.org out of the study"),
        ("olga", "made vera@example.org editor instead of viewer"),
        ("olga", "made vera@example.org viewer"),
        ("olga", "made edith@example.org editor"),
    ]


def test_the_trail_is_read_page_by_page_without_a_gap(db, people, study):
    for number in range(2 * audit.PAGE):
        audit.note(db, study.id, "published", people["olga"], number=number)
    first = audit.trail(db, study.id)
    second = audit.trail(db, study.id, first.older)
    third = audit.trail(db, study.id, second.older)
    ids = [one.id for page in (first, second, third) for one in page.entries]
    assert ids == sorted(ids, reverse=True)
    assert len(set(ids)) == 2 * audit.PAGE + 2
    assert third.older is None


def test_what_is_saved_with_every_key_stroke_is_noted_once_in_a_while(db, people, study):
    for _ in range(3):
        audit.note(
            db, study.id, "draft_saved", people["edith"], unless_within=timedelta(minutes=10)
        )
    audit.note(db, study.id, "draft_saved", people["olga"], unless_within=timedelta(minutes=10))
    acts = [(one.act, one.who) for one in audit.trail(db, study.id).entries]
    assert acts[:2] == [("draft_saved", "olga"), ("draft_saved", "edith")]
    assert acts[2][0] == "member_added"


def test_a_detail_that_looks_like_a_place_to_fill_in_stays_as_it_was_written(db, people, study):
    audit.note(
        db, study.id, "session_excluded", people["olga"], name="ab", reason="{name} {0} {reason}"
    )
    assert audit.trail(db, study.id).entries[0].sentence.endswith("out: {name} {0} {reason}")


def test_only_an_owner_changes_for_how_long_anything_is_kept(db, people, study):
    edith = rights.access(db, "walks", people["edith"], "edit")
    publishing.run(db, edith, Running(quota=5))
    with pytest.raises(ForbiddenError):
        publishing.run(db, edith, Running(quota=5, retention_days=1))
    assert Running.model_validate(study.running) == Running(quota=5)
    olga = rights.access(db, "walks", people["olga"], "own")
    publishing.run(db, olga, Running(retention_days=365))
    assert study.running["retention_days"] == 365
