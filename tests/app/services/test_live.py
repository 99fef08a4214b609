"""A study while it runs, and what researchers do with its participants."""

from __future__ import annotations

import json
from datetime import timedelta

import numpy as np
import orjson
import pytest
from sqlalchemy.orm import Session

from app.errors import ConflictError, NotFoundError
from app.persistence import live as store
from app.persistence import responses
from app.persistence.engine import Database
from app.persistence.models import Researcher, SessionSummary, Study, StudySession, now
from app.persistence.writer import Writer
from app.schemas.effects import Effects
from app.services import (
    audit,
    drafts,
    effects,
    live,
    participants,
    person_export,
    replay,
    retention,
    rights,
    sessions,
    simulation,
    studies,
    summaries,
)
from app.services.results import results
from app.services.rights import Access
from app.studies import emotion
from tests.support import kinds, simulate
from tests.support.simulate import answer_with
from tests.support.taking_part import NEUTRAL


@pytest.fixture
def access(db: Session) -> Access:
    simulate.add_study(db)
    db.add(Researcher(email="rosa@example.org", name="Rosa", password_hash="-"))
    db.commit()
    rosa = db.query(Researcher).one()
    return rights.access(db, emotion.SLUG, rosa.id, "own")


class Fixed:
    """A writer and a database that are the test's one session."""

    def __init__(self, db: Session) -> None:
        self.db = db

    def reading(self) -> Fixed:
        return self

    def __enter__(self) -> Session:
        return self.db

    def __exit__(self, *_: object) -> None:
        pass

    def write(self, job):
        return job(self.db)


def summarise(db: Session) -> None:
    while summaries.catch_up(Fixed(db), Fixed(db)):
        db.commit()


def seen(db: Session, access: Access):
    summarise(db)
    return live.overview(db, access)


def session_of(db: Session, token: str) -> StudySession:
    return sessions.open_session(db, token)


def take_part(db: Session, seed: int = 1, **how) -> StudySession:
    write = simulate.directly(db)
    return session_of(db, simulate.take_part(write, np.random.default_rng(seed), **how))


def test_everybody_is_counted_where_they_stand(db, access):
    for seed in range(3):
        take_part(db, seed)
    take_part(db, 4, answered=5)
    gone = take_part(db, 5, answered=2)
    gone.created_at = gone.consented_at = now() - timedelta(days=2)
    sessions.erase(db, take_part(db, 6))
    summarise(db)
    db.get(SessionSummary, gone.id).last_at = now() - timedelta(days=2)
    view = live.overview(db, access)
    counts = view.counts
    assert (counts.complete, counts.under_way, counts.left_early, counts.withdrawn) == (3, 1, 1, 1)
    assert counts.answers == 3 * 22 + 5 + 2
    assert view.latest.total == 5
    assert view.dropout.of == 4
    assert [step.still for step in view.dropout.steps][:4] == [4, 4, 4, 3]


def test_a_page_left_open_for_months_is_counted_like_any_other(db, access):
    token = simulate.begin(simulate.directly(db))
    for index in range(3):  # the third is the first that is no practice
        simulate.answers.record(db, token, answer_with(NEUTRAL, index, rt_ms=1e10))
    assert seen(db, access).counts.answers == 3
    assert db.get(SessionSummary, session_of(db, token).id).median_ms == 10**10


def test_every_clip_has_as_many_answers_as_participants_and_practice_is_none(db, access):
    for seed in range(3):
        take_part(db, seed)
    take_part(db, 9, answered=2)  # practice alone
    clips = seen(db, access).clips
    assert len(clips) == 20
    assert {(clip.complete, clip.others) for clip in clips} == {(3, 0)}


def test_x_counts_as_the_one_clip_that_it_is(db):
    study = kinds.add_every_kind(db)
    tastes = effects.tastes(studies.definition_of(studies.newest(db, study)), Effects())
    generator = np.random.default_rng(1)
    raters = simulation.raters(tastes, Effects(), 2, generator)
    within = simulate.directly(db)
    assert list(simulation.run(within, within, kinds.SLUG, raters, 0, generator))
    summarise(db)
    view = live.overview(db, Access(study.id, study.slug, 0, "viewer"), "simulated")
    # Of four clips each stands in three pairs of A/B and of A/B/X, and once in each other part.
    assert [clip.complete for clip in view.clips] == [2 * (8 + 3 + 3)] * 4


def test_a_summary_equals_its_session_however_the_answers_came_in(db, access):
    take_part(db, 1)
    token = simulate.begin(simulate.directly(db))
    steps = sessions.planned_steps(session_of(db, token).plan)
    values = dict.fromkeys([scale["id"] for scale in emotion.SCALES], 1)
    write = simulate.directly(db)
    for index in (2, 0, 1):
        write(lambda d, i=index: simulate.answers.record(d, token, answer_with(values, i)))
        summarise(db)
    write(lambda d: simulate.answers.record(d, token, answer_with(values, 2, revision=2)))
    summarise(db)
    piecewise = db.get(SessionSummary, session_of(db, token).id)
    names = [column.key for column in SessionSummary.__table__.c if column.key != "upto"]
    before = {name: getattr(piecewise, name) for name in names}
    db.delete(piecewise)
    db.query(SessionSummary).delete()
    db.commit()
    db.expire_all()
    summarise(db)
    at_once = db.get(SessionSummary, session_of(db, token).id)
    assert {name: getattr(at_once, name) for name in before} == before
    assert (at_once.answered, at_once.steps, at_once.judged) == (3, len(steps), 1)


def test_windows_smaller_than_a_session_lose_no_answer(db, access):
    for seed in range(3):
        take_part(db, seed)
    while summaries.catch_up(Fixed(db), Fixed(db), window=7):
        db.commit()
    assert {one.answered for one in db.query(SessionSummary)} == {22}


def test_answers_that_get_the_numbers_of_deleted_ones_are_not_overlooked(db, access):
    write = simulate.directly(db)
    token = simulate.begin(write)
    values = dict.fromkeys([scale["id"] for scale in emotion.SCALES], 1)
    write(lambda d: simulate.answers.record(d, token, answer_with(values, 0)))
    gone = take_part(db, 2, answered=5)
    summarise(db)
    sessions.erase(db, gone)
    write(lambda d: simulate.answers.record(d, token, answer_with(values, 1)))
    summarise(db)
    db.expire_all()
    assert db.get(SessionSummary, session_of(db, token).id).answered == 2


def test_a_straight_liner_is_suspicious_and_leaves_the_results_and_comes_back(db, access):
    write = simulate.directly(db)
    for seed in range(5):
        take_part(db, seed)
    token = simulate.begin(write)
    values = dict.fromkeys([scale["id"] for scale in emotion.SCALES], 2)
    for index in range(22):
        write(lambda d, i=index: simulate.answers.record(d, token, answer_with(values, i)))
    write(lambda d: sessions.complete(d, token))
    session = session_of(db, token)
    view = seen(db, access)
    assert [one.id for one in view.suspicious.sessions] == [session.id]
    told = {one.id: one.number for one in view.suspicious.sessions[0].suspicions}
    assert told["same_answers"] == "20 trials in a row were answered exactly alike"
    assert told["flat_answers"] == "In 20 of 20 trials every scale has the same step"
    before = results(db, access.slug).participants

    participants.exclude(db, access, session.id, "answered 2 to everything")
    without = seen(db, access)
    assert (without.counts.complete, without.counts.excluded) == (5, 1)
    assert without.suspicious.total == 0
    assert {clip.complete for clip in without.clips} == {5}
    (marked,) = without.marked.sessions
    assert (marked.excluded.reason, marked.excluded.by) == ("answered 2 to everything", "Rosa")
    assert results(db, access.slug).participants == before - 1
    (line,) = drafts.listed(db, access.researcher_id).studies
    assert line.counts.complete == 5

    participants.include(db, access, session.id)
    assert seen(db, access).counts.complete == 6
    assert results(db, access.slug).participants == before
    acts = [(one.act, one.who) for one in audit.trail(db, access.study_id).entries]
    assert acts == [("session_included", "Rosa"), ("session_excluded", "Rosa")]


def test_a_mark_by_hand_changes_nothing_else(db, access):
    session = take_part(db)
    participants.flag(db, access, session.id, "wrote to us")
    view = seen(db, access)
    assert view.counts.complete == 1
    assert view.marked.sessions[0].flag.reason == "wrote to us"
    participants.unflag(db, access, session.id)
    assert seen(db, access).marked.sessions == []


def test_who_is_deleted_leaves_a_tombstone_and_an_entry_and_nothing_else(db, access):
    session = take_part(db)
    summarise(db)
    participants.delete(db, access, session.id)
    participants.delete(db, access, session.id)
    assert responses.answered(db, session.id) == set()
    assert db.get(SessionSummary, session.id) is None
    view = seen(db, access)
    assert (view.counts.withdrawn, view.latest.sessions) == (1, [])
    assert [one.act for one in audit.trail(db, access.study_id).entries] == ["session_deleted"]
    with pytest.raises(NotFoundError):
        replay.replay(db, access, session.id)
    with pytest.raises(ConflictError):
        participants.exclude(db, access, session.id, "too late")


def test_what_was_written_about_a_person_goes_when_they_withdraw(db, access):
    write = simulate.directly(db)
    token = simulate.take_part(write, np.random.default_rng(1))
    session, other = session_of(db, token), take_part(db, 2)
    participants.flag(db, access, session.id, "is Olga's sister")
    participants.exclude(db, access, session.id, "is Olga's sister")
    participants.flag(db, access, other.id, "wrote to us")
    sessions.withdraw(db, token)
    trail = audit.trail(db, access.study_id).entries
    assert [one.act for one in trail] == ["session_flagged", "session_excluded", "session_flagged"]
    assert "sister" not in " ".join(one.sentence for one in trail)
    assert trail[0].sentence.endswith("wrote to us")


def test_a_participant_of_another_study_is_not_found(db, access):
    session = take_part(db)
    other = access._replace(study_id=access.study_id + 1)
    for act in (participants.include, participants.delete, replay.replay, person_export.export):
        with pytest.raises(NotFoundError):
            act(db, other, session.id)


def test_the_replay_tells_order_answers_and_view_of_each_step(db, access):
    token = simulate.begin(simulate.directly(db))
    session = session_of(db, token)
    values = {
        scale["id"]: step for scale, step in zip(emotion.SCALES, (-2, -1, 0, 1, 2, 0), strict=True)
    }
    camera = [(0.0, 32.0, 7.0, 1.0), (500.0, -150.0, 20.0, 1.5)]
    answer = answer_with(values, comment="limps")
    record = answer.record.model_copy(update={"camera": camera})
    write = simulate.directly(db)
    write(lambda d: simulate.answers.record(d, token, answer.model_copy(update={"record": record})))
    summarise(db)
    detail = replay.replay(db, access, session.id)
    assert [step.part for step in detail.steps] == [
        step["part"] for step in sessions.planned_steps(session.plan)
    ]
    first, second = detail.steps[:2]
    told = {one.label: one.value for one in first.answers}
    assert told["sad – happy"] == "very sad (−2)"
    assert told["afraid – confident"] == "very confident (+2)"
    assert (first.note, first.comment) == ("practice", "limps")
    assert first.camera == camera
    assert {one.label: one.value for one in first.viewed}["watched"] == "4.8 s"
    assert (second.answered, second.answers) == (False, [])
    assert all(step.figures[0].glb_url for step in detail.steps)


def test_all_of_one_person_is_handed_out_and_only_theirs(db, access):
    session, other = take_part(db, 1), take_part(db, 2)
    session.external, session.source = {"PROLIFIC_PID": "5f0a"}, "prolific"
    found = json.loads(orjson.dumps(person_export.export(db, access, session.id)))
    assert len(found["answers"]) == 22
    assert found["participant"]["external"] == {"PROLIFIC_PID": "5f0a"}
    assert found["agreed_to"]["version"] == "1"
    stored = {row.trial_index: row.answers for row in store.answers_of(db, session.id)}
    assert {row["trial_index"]: row["answers"] for row in found["answers"]} == stored
    text = json.dumps(found)
    assert str(other.id) not in text
    assert session.token_hash not in text
    assert [one.act for one in audit.trail(db, access.study_id).entries] == ["session_exported"]


def test_what_is_kept_long_enough_is_deleted_and_the_rest_stays(database_url, engine):
    database = Database(engine)
    writer = Writer(database)
    write = writer.write
    with database.writing() as db:
        simulate.add_study(db)
    generator = np.random.default_rng(1)
    tokens = [simulate.take_part(write, generator) for _ in range(3)]
    tokens.append(simulate.take_part(write, generator, answered=2))
    assert retention.sweep(database, writer, now() + timedelta(days=1000)) == 0
    with database.writing() as db:
        study = studies.find(db, emotion.SLUG)
        study.running = {"retention_days": 30}
        old = session_of(db, tokens[0])
        old.created_at = now() - timedelta(days=90)  # but answered just now
        db.commit()
    assert retention.sweep(database, writer, now() + timedelta(days=29)) == 0
    assert retention.sweep(database, writer, now() + timedelta(days=31)) == 4
    assert retention.sweep(database, writer, now() + timedelta(days=31)) == 0
    with database.reading() as db:
        states = {session_of(db, token).state for token in tokens}
        trail = audit.trail(db, study.id).entries
        left = responses.count(db, db.get(Study, study.id))
    writer.close()
    assert (states, left) == ({"withdrawn"}, 0)
    assert [(one.act, one.who) for one in trail] == [("session_expired", "The server")] * 4
