"""Slots: least filled first, leased and given back, each clip answered equally often."""

from __future__ import annotations

from collections import Counter
from datetime import timedelta
from typing import Any

import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.errors import ConflictError
from app.persistence.models import ClipRecord, Response, Study, StudySession, now
from app.schemas.study import StudyDefinition
from app.services import answers, sessions
from tests.support.published import add_published
from tests.support.simulate import add_study, answer_with
from tests.support.study_files import study_file, trials
from tests.support.taking_part import begin

GROUPS = [{"id": "a", "label": "A"}, {"id": "b", "label": "B"}, {"id": "c", "label": "C"}]
VALUES = {"sad_happy": 1, "weak_strong": -1}


@pytest.fixture
def study(db: Session) -> Study:
    """Three groups; each participant judges two of six clips."""
    add_study(db)
    return add(db, subset=2, number=6, groups=GROUPS)


def add(db: Session, number: int, groups: Any = (), running: Any = None, **more: Any) -> Study:
    part = trials(number=number, **more)
    clips = db.scalars(select(ClipRecord.id).order_by(ClipRecord.name).limit(number)).all()
    for stimulus, clip in zip(part["stimuli"], clips, strict=True):
        stimulus["clip"] = clip
    definition = StudyDefinition.model_validate(study_file(part, groups=groups))
    return add_published(db, definition, **(running or {}))


def come(db: Session, **more: Any) -> str:
    return begin(db, "small", **more)


def finish(db: Session, token: str) -> None:
    for index in range(2):
        answers.record(db, token, answer_with(VALUES, index))
    sessions.complete(db, token)


def session_of(db: Session, token: str) -> StudySession:
    return sessions.open_session(db, token)


def go_away(db: Session, token: str) -> None:
    """As if all signs of this participant were two hours old."""
    session = session_of(db, token)
    session.created_at -= timedelta(hours=2)
    for row in db.scalars(select(Response).where(Response.session_id == session.id)):
        row.received_at -= timedelta(hours=2)
    db.flush()


def test_newcomers_take_slot_after_slot_and_groups_in_turn(db: Session, study: Study) -> None:
    found = [session_of(db, come(db)) for _ in range(7)]
    assert [session.slot for session in found] == list(range(7))
    assert [session.group for session in found] == ["a", "b", "c", "a", "b", "c", "a"]


def test_a_slot_comes_back_when_the_lease_has_run_out_and_goes_to_the_next(
    db: Session, study: Study
) -> None:
    gone, stays, done = come(db), come(db), come(db)
    finish(db, done)
    for token in (gone, done):
        go_away(db, token)
    answers.record(db, stays, answer_with(VALUES, 0))  # a sign renews the lease
    session_of(db, stays).created_at -= timedelta(hours=2)
    db.flush()
    assert session_of(db, come(db)).slot == 0
    assert session_of(db, come(db)).slot == 3


def test_whoever_comes_back_after_the_lease_can_still_finish(db: Session, study: Study) -> None:
    late = come(db)
    go_away(db, late)
    assert session_of(db, come(db)).slot == session_of(db, late).slot == 0
    finish(db, late)
    assert session_of(db, late).state == "complete"


@pytest.mark.parametrize("leave", ["withdrawn", "excluded", "screened_out"])
def test_a_slot_of_somebody_who_does_not_count_is_free(
    db: Session, study: Study, leave: str
) -> None:
    token = come(db)
    session = session_of(db, token)
    if leave == "withdrawn":
        sessions.withdraw(db, token)
    elif leave == "excluded":
        session.excluded = {"reason": "slept"}
    else:
        session.state = leave
    db.flush()
    assert session_of(db, come(db)).slot == 0


def test_previews_and_simulated_participants_take_no_slot_and_no_place(
    db: Session, study: Study
) -> None:
    study.running = {"quota": 1}
    for kind in ("preview", "simulated", "simulated"):
        come(db, kind=kind)
    assert session_of(db, come(db)).slot == 0
    slots = db.scalars(select(StudySession.slot).where(StudySession.kind == "simulated"))
    assert sorted(slots) == [0, 1]


def test_no_more_than_the_quota_are_let_in_until_one_leaves(db: Session, study: Study) -> None:
    study.running = {"quota": 2}
    first, _ = come(db), come(db)
    with pytest.raises(ConflictError) as caught:
        come(db)
    assert caught.value.code == "study_full"
    sessions.withdraw(db, first)
    assert session_of(db, come(db)).slot == 0


def test_with_a_fifth_dropping_out_the_complete_are_balanced_once_their_slots_are_done_again(
    db: Session, study: Study
) -> None:
    arrivals = 0
    while complete(db) < 18:
        token = come(db)
        arrivals += 1
        if arrivals % 5 == 0:  # answers half and leaves
            answers.record(db, token, answer_with(VALUES, 0))
            go_away(db, token)
        else:
            finish(db, token)
    done = db.scalars(select(StudySession).where(StudySession.state == "complete")).all()
    groups = Counter(session.group for session in done)
    assert set(groups.values()) == {6}
    shown = Counter(
        db.scalars(
            select(Response.clip_id).join(StudySession).where(StudySession.state == "complete")
        )
    )
    assert set(shown.values()) == {18 * 2 // 6}
    assert arrivals == 22


def complete(db: Session) -> int:
    return len(db.scalars(select(StudySession).where(StudySession.state == "complete")).all())


def test_the_same_identity_goes_on_with_its_session(db: Session, study: Study) -> None:
    token = come(db, token="of p1")
    assert come(db, token="of p1") == token
    assert len(db.scalars(select(StudySession)).all()) == 1


@pytest.mark.parametrize(
    ("state", "running", "reason"),
    [
        ("draft", {}, "not_published"),
        ("paused", {}, "paused"),
        ("closed", {}, "closed"),
        ("open", {"open_link": False}, "by_invitation"),
        ("open", {"opens_at": "2999-01-01T00:00:00Z"}, "not_yet_open"),
        ("open", {"closes_at": "2001-01-01T00:00:00Z"}, "closed"),
    ],
)
def test_a_study_that_takes_nobody_says_why_and_keeps_nothing(
    db: Session, study: Study, state: str, running: dict[str, Any], reason: str
) -> None:
    study.state, study.running = state, running
    db.flush()
    with pytest.raises(ConflictError) as caught:
        come(db)
    assert caught.value.where == {"reason": reason}
    assert db.scalars(select(StudySession)).all() == []


def test_a_link_can_be_gone_on_with_for_as_long_as_the_study_says(
    db: Session, study: Study
) -> None:
    token = come(db)
    session = session_of(db, token)
    session.created_at = now() - timedelta(days=29)
    sessions.refuse_late(session)
    session.created_at = now() - timedelta(days=31)
    with pytest.raises(ConflictError) as caught:
        sessions.refuse_late(session)
    assert caught.value.code == "session_expired"
