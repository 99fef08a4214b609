import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sqlalchemy import select

from app.errors import ConflictError, InvalidError
from app.persistence.models import Response
from app.services import answers
from tests.support.simulate import STYLES, add_study, answer_with, directly, take_part
from tests.support.taking_part import NEUTRAL, begin


@pytest.fixture
def token(db):
    add_study(db)
    return begin(db)


def test_an_answer_is_stored_with_all_that_was_measured(db, token):
    receipt, new = answers.record(db, token, answer_with(NEUTRAL | {"sad_happy": -2}, 3))
    (row,) = db.scalars(select(Response))
    assert new
    assert row.received_at == receipt.received_at
    assert row.answers == NEUTRAL | {"sad_happy": -2}
    assert row.rt_ms == 5210.5
    assert row.record["viewport"] == {"width": 1280, "height": 800, "pixel_ratio": 1.0}
    assert row.record["plays"] == 2
    assert row.record["time_elapsed_ms"] == 61_000.25
    assert not row.practice


def test_practice_answers_are_marked(db, token):
    for index in range(3):
        answers.record(db, token, answer_with(NEUTRAL, index))
    rows = db.scalars(select(Response).order_by(Response.trial_index)).all()
    assert [row.practice for row in rows] == [True, True, False]


def test_sending_an_answer_again_gives_the_same_receipt_and_no_second_row(db, token):
    first, _ = answers.record(db, token, answer_with(NEUTRAL, 1))
    again, new = answers.record(db, token, answer_with(NEUTRAL, 1, time_elapsed_ms=99_999.0))
    assert (again, new) == (first, False)
    assert len(db.scalars(select(Response)).all()) == 1


def test_another_answer_under_the_same_revision_is_refused_with_what_is_stored(db, token):
    answers.record(db, token, answer_with(NEUTRAL, 1, comment="limps"))
    with pytest.raises(ConflictError) as caught:
        answers.record(db, token, answer_with(NEUTRAL | {"sad_happy": 1}, 1))
    assert caught.value.code == "already_answered"
    assert caught.value.extra["stored"]["answers"] == NEUTRAL
    assert caught.value.extra["stored"]["comment"] == "limps"
    assert len(db.scalars(select(Response)).all()) == 1


@pytest.mark.parametrize(
    ("values", "told"),
    [
        ({}, "“afraid_confident” is not answered"),
        (NEUTRAL | {"mood": 1}, "“mood” is not asked here"),
        (NEUTRAL | {"sad_happy": 3}, "“sad_happy” is 3, not within -2 … 2"),
        (NEUTRAL | {"sad_happy": -3}, "“sad_happy” is -3"),
    ],
)
def test_an_answer_that_does_not_fit_the_study_is_refused(db, token, values, told):
    with pytest.raises(InvalidError) as caught:
        answers.record(db, token, answer_with(values, touched=[]))
    assert told in caught.value.message
    assert db.scalars(select(Response)).all() == []


def test_touching_what_is_no_scale_is_refused(db, token):
    with pytest.raises(InvalidError, match="touched but is not asked here"):
        answers.record(db, token, answer_with(NEUTRAL, touched=["mood"]))


def test_a_clip_that_the_session_does_not_have_is_refused(db, token):
    with pytest.raises(InvalidError) as caught:
        answers.record(db, token, answer_with(NEUTRAL, 22))
    assert caught.value.code == "trial_unknown"


def test_what_no_database_can_store_is_taken_out_of_comments(db, token):
    answers.record(db, token, answer_with(NEUTRAL, comment="a\0b \ud800 c 🚶"))
    assert db.scalars(select(Response.comment)).one() == "ab ? c 🚶"


@given(st.text(max_size=200))
def test_every_comment_can_be_encoded(comment):
    stored = answer_with(NEUTRAL, comment=comment).comment
    assert stored.encode().decode() == stored
    assert "\0" not in stored


def test_simulated_raters_see_what_was_acted(db):
    # The helper behind other tests: the mean of a style follows its latent effect.
    add_study(db)
    generator = np.random.default_rng(8)
    for _ in range(6):
        take_part(directly(db), generator)
    rows = db.scalars(select(Response).where(~Response.practice)).all()
    assert len(rows) == 6 * 2 * len(STYLES)
    by_clip = {}
    for row in rows:
        by_clip.setdefault(row.clip_id, []).append(row.answers["sad_happy"])
    means = sorted(np.mean(values) for values in by_clip.values())
    assert means[0] < -0.8
    assert means[-1] > 0.8
