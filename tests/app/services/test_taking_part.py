from datetime import timedelta

import numpy as np
import pytest
from sqlalchemy import select

from app.errors import ConflictError, InvalidError, NotFoundError
from app.persistence.models import ClipRecord, Response, StudySession, now
from app.services import answers, results, session_views, sessions, studies
from app.services.plans import draw_plan
from app.studies import emotion
from tests.support.simulate import add_study, answer_with, directly, take_part
from tests.support.taking_part import NEUTRAL, begin


@pytest.fixture
def definition(db):
    return add_study(db)


@pytest.fixture
def token(db, definition):
    return begin(db)


def answer_all(db, token):
    for index in range(22):
        answers.record(db, token, answer_with(NEUTRAL, index))


def test_the_order_of_a_seed_never_changes(definition):
    # Written down once: the raw draws of PCG64 are fixed for good, on every platform.
    clips = [stimulus.clip for stimulus in definition.trials[0].stimuli]
    steps = draw_plan(definition, 7, 0, "any")["steps"]
    expected = [6, 3, 17, 12, 4, 3, 19, 1, 13, 15, 0, 11, 16, 6, 10, 9, 5, 2, 8, 14, 18, 7]
    assert [clips.index(step["clips"][0]) for step in steps] == expected
    assert [step["practice"] for step in steps] == [True] * 2 + [False] * 20


def test_the_personal_link_cannot_be_made_from_what_is_stored(db, token):
    (session,) = db.scalars(select(StudySession))
    assert len(token) >= 22  # 6 bits a letter: at least 128
    assert token not in (session.token_hash, str(session.id))
    assert session.token_hash == sessions.hash_token(token)
    assert session.consent_version == "1"
    assert session.seed is not None


def test_someone_who_agreed_to_an_older_text_is_asked_again(db, definition):
    with pytest.raises(InvalidError) as caught:
        begin(db, version="0")
    assert caught.value.code == "consent_changed"
    assert db.scalars(select(StudySession)).all() == []


def test_the_page_learns_no_names_and_not_which_clips_are_practice(db, token):
    shown = session_views.view(db, token).model_dump_json()
    names = db.scalars(select(ClipRecord.name)).all()
    assert len(session_views.view(db, token).steps) == 22
    assert "practice" not in shown
    assert not [name for name in names if name in shown]


def test_a_reload_goes_on_at_the_first_clip_without_an_answer(db, token):
    assert session_views.view(db, token).next == 0
    for index in (0, 1, 3):
        answers.record(db, token, answer_with(NEUTRAL, index))
    again = session_views.view(db, token)
    assert again.next == 2
    assert sorted(again.responses) == [0, 1, 3]
    assert again.steps == session_views.view(db, token).steps


def test_the_newest_revision_counts_and_the_older_stays(db, token):
    answers.record(db, token, answer_with(NEUTRAL, 0))
    answers.record(db, token, answer_with(NEUTRAL | {"sad_happy": 2}, 0, revision=2))
    shown = session_views.view(db, token).responses[0]
    assert (shown.revision, shown.answers["sad_happy"]) == (2, 2)
    rows = db.scalars(select(Response).order_by(Response.revision)).all()
    assert [row.answers["sad_happy"] for row in rows] == [0, 2]


def test_completing_needs_every_answer_and_says_which_are_missing(db, token):
    for index in range(20):
        answers.record(db, token, answer_with(NEUTRAL, index))
    with pytest.raises(ConflictError) as caught:
        sessions.complete(db, token)
    assert caught.value.code == "answers_missing"
    assert caught.value.where == {"missing": [20, 21]}
    assert sessions.standing(db, token).completion_code is None


def test_completing_again_gives_the_same_code(db, token):
    answer_all(db, token)
    first = sessions.complete(db, token)
    assert sessions.complete(db, token) == first
    assert first.answers == 22
    assert sessions.standing(db, token).completion_code == first.completion_code


def test_two_participants_have_different_codes_seeds_and_links(db, definition):
    generator = np.random.default_rng(3)
    tokens = [take_part(directly(db), generator) for _ in range(2)]
    codes = {sessions.complete(db, token).completion_code for token in tokens}
    seeds = set(db.scalars(select(StudySession.seed)))
    assert (len(set(tokens)), len(codes), len(seeds)) == (2, 2, 2)


def test_a_complete_session_takes_no_new_answer_but_knows_the_old_ones(db, token):
    answer_all(db, token)
    sessions.complete(db, token)
    receipt, new = answers.record(db, token, answer_with(NEUTRAL, 5))
    assert (receipt.trial_index, new) == (5, False)
    with pytest.raises(ConflictError) as caught:
        answers.record(db, token, answer_with(NEUTRAL, 5, revision=2))
    assert caught.value.code == "session_complete"


@pytest.mark.parametrize("finished", [True, False])
def test_a_withdrawal_leaves_a_tombstone_without_data(db, token, finished):
    answer_all(db, token)
    if finished:
        sessions.complete(db, token)
    sessions.withdraw(db, token)
    assert db.scalars(select(Response)).all() == []
    (row,) = db.scalars(select(StudySession))
    kept = {column.key for column in StudySession.__table__.columns if getattr(row, column.key)}
    assert kept == {
        "id", "study_id", "version_id", "kind", "token_hash", "state", "withdrawn_at", "created_at",
    }  # fmt: skip
    assert row.created_at == row.withdrawn_at
    assert session_views.view(db, token).steps == []


def test_a_withdrawn_session_refuses_everything_and_withdrawing_again_changes_nothing(db, token):
    sessions.withdraw(db, token)
    when = db.scalars(select(StudySession.withdrawn_at)).one()
    sessions.withdraw(db, token)
    assert db.scalars(select(StudySession.withdrawn_at)).one() == when
    for refused in (
        lambda: answers.record(db, token, answer_with(NEUTRAL)),
        lambda: sessions.complete(db, token),
    ):
        with pytest.raises(ConflictError) as caught:
            refused()
        assert caught.value.code == "session_withdrawn"


def test_an_unknown_link_is_said_to_be_unknown(db, definition):
    for asked in (
        lambda: session_views.view(db, "nobody"),
        lambda: sessions.complete(db, "nobody"),
        lambda: sessions.withdraw(db, "nobody"),
        lambda: answers.record(db, "nobody", answer_with(NEUTRAL)),
    ):
        with pytest.raises(NotFoundError) as caught:
            asked()
        assert caught.value.code == "session_not_found"


def test_counts_follow_the_participants(db, definition):
    write, generator = directly(db), np.random.default_rng(4)
    for answered in (None, None, 3, 7, 9):
        take_part(write, generator, answered=answered)
    sessions.withdraw(db, take_part(write, generator, answered=9))
    study = studies.find(db, emotion.SLUG)
    early = db.scalars(select(StudySession).where(StudySession.state == "active")).first()
    moment = early.consented_at
    counts = results.count(db, study, moment)
    assert (counts.complete, counts.under_way, counts.left_early, counts.withdrawn) == (2, 3, 0, 1)
    assert counts.answers == 2 * 22 + 3 + 7 + 9
    later = results.count(db, study, moment + timedelta(minutes=61))
    assert (later.under_way, later.left_early, later.left_after) == (0, 3, [3, 7, 9])


def test_who_answered_all_but_never_finished_left_after_the_last_step(db, definition):
    take_part(directly(db), np.random.default_rng(4), answered=22)
    study = studies.find(db, emotion.SLUG)
    later = results.count(db, study, now() + timedelta(minutes=61))
    assert (later.complete, later.left_after) == (0, [22])


def test_the_median_time_is_that_of_the_complete(db, definition):
    generator = np.random.default_rng(4)
    for _ in range(3):
        take_part(directly(db), generator)
    take_part(directly(db), generator, answered=1)
    complete = db.scalars(select(StudySession).where(StudySession.state == "complete")).all()
    for seconds, session in zip((600, 60, 900), complete, strict=True):
        session.completed_at = session.consented_at + timedelta(seconds=seconds)
    db.flush()
    assert results.counts(db, emotion.SLUG).median_seconds == 600


def shown(db, study):
    return studies.definition_of(studies.newest(db, study)).trials[0].stimuli


def test_the_demonstration_follows_the_library_only_until_somebody_began(db, definition):
    clip = db.scalars(select(ClipRecord).where(ClipRecord.name == "acted_male_weak")).one()
    clip.state = "retired"
    db.flush()
    study = studies.ensure_demonstration(db)
    assert len(shown(db, study)) == 19
    begin(db)
    clip.state = "kept"
    db.flush()
    assert studies.ensure_demonstration(db) is study
    assert len(shown(db, study)) == 19


def test_without_a_library_there_is_no_demonstration(db):
    assert studies.ensure_demonstration(db) is None
    with pytest.raises(NotFoundError, match="no study"):
        studies.welcome(db, emotion.SLUG)


@pytest.mark.parametrize(
    ("agent", "device"),
    [
        ("Mozilla/5.0 (iPhone; CPU iPhone OS 18_0 like Mac OS X) Mobile/15E148", "phone"),
        ("Mozilla/5.0 (Linux; Android 15; Pixel 9) Chrome/140 Mobile Safari/537.36", "phone"),
        ("Mozilla/5.0 (Linux; Android 15; SM-X710) Chrome/140 Safari/537.36", "tablet"),
        ("Mozilla/5.0 (X11; Linux x86_64) Chrome/140 Safari/537.36", "desktop"),
        ("", "desktop"),
    ],
)
def test_of_the_browser_only_the_kind_of_device_is_kept(agent, device):
    assert sessions.device_class(agent) == device
