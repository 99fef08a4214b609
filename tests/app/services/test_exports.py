import csv
import io
import re
from pathlib import Path

import pytest
from sqlalchemy import select

from app.persistence.engine import Database
from app.persistence.models import ClipRecord, Response, StudySession
from app.services import answers, exports
from app.studies import emotion
from tests.support.simulate import add_study, answer_with, begin, directly, simulate

NEUTRAL = dict.fromkeys((scale["id"] for scale in emotion.SCALES), 0)


@pytest.fixture
def token(db):
    add_study(db)
    return begin(directly(db), user_agent="Mobile")


def found(db):
    return exports.exported(Database(db.connection()), emotion.SLUG)


def columns(db):
    return [column.name for column in exports.codebook(found(db)).columns]


def table(db):
    text = "".join(exports.responses_csv(found(db)))
    return list(csv.DictReader(io.StringIO(text)))


def test_a_row_holds_all_that_is_known_of_an_answer(db, token):
    answers.record(db, token, answer_with(NEUTRAL | {"sad_happy": -2}, 4, comment="drags a foot"))
    (row,) = table(db)
    session, answer = db.scalars(select(StudySession)).one(), db.scalars(select(Response)).one()
    clip = db.get(ClipRecord, answer.clip_id)
    expected = {
        "study": emotion.SLUG,
        "session": str(session.id),
        "session_state": "active",
        "device": "phone",
        "seed": str(session.seed),
        "trial_index": "4",
        "practice": "0",
        "revision": "1",
        "newest": "1",
        "stimulus": clip.name,
        "body": clip.tags["body"],
        "style": clip.tags["style"],
        "stimulus_hash": clip.id,
        "sad_happy": "-2",
        "weak_strong": "0",
        "comment": "drags a foot",
        "rt_ms": "5210.5",
        "time_elapsed_ms": "61000.25",
        "plays": "2",
        "viewing_ms": "4800.0",
        "dropped_frames": "3",
        "viewport_width": "1280",
        "received_at": answer.received_at.isoformat(),
    }
    assert {name: row[name] for name in expected} == expected
    assert row["study_hash"] == session.version.definition_hash


@pytest.mark.parametrize(
    "comment",
    ["=1+1", "+1", "-2+3", "@SUM(A1)", "\tx", "\r=x", '=HYPERLINK("http://x","y")', "＝1"],
)
def test_text_that_a_spreadsheet_would_run_is_made_harmless(db, token, comment):
    answers.record(db, token, answer_with(NEUTRAL, comment=comment))
    (row,) = table(db)
    assert row["comment"] == f"'{comment}"


@pytest.mark.parametrize("comment", ["a,b", 'say "yes"', "two\nlines", "歩く", "", "a=b", "’tis"])
def test_other_text_comes_through_as_it_was_written(db, token, comment):
    answers.record(db, token, answer_with(NEUTRAL, comment=comment))
    (row,) = table(db)
    assert row["comment"] == comment


def test_negative_numbers_stay_numbers(db, token):
    answers.record(db, token, answer_with(dict.fromkeys(NEUTRAL, -1)))
    (row,) = table(db)
    assert [row[scale] for scale in NEUTRAL] == ["-1"] * 6


def test_earlier_revisions_are_there_and_marked(db, token):
    for revision in (1, 2, 3):
        answers.record(db, token, answer_with(NEUTRAL, 0, revision))
    assert [(row["revision"], row["newest"]) for row in table(db)] == [
        ("1", "0"), ("2", "0"), ("3", "1"),
    ]  # fmt: skip


def test_practice_is_marked_and_every_clip_is_there_once(db):
    add_study(db)
    simulate(directly(db), 1)
    rows = table(db)
    assert [row["practice"] for row in rows] == ["1"] * 2 + ["0"] * 20
    assert len({row["stimulus"] for row in rows[2:]}) == 20


def test_the_table_comes_in_pieces(db):
    add_study(db)
    simulate(directly(db), 25)
    pieces = list(exports.responses_csv(found(db)))
    assert len(pieces) > 3
    assert max(len(piece) for piece in pieces) < 200_000
    assert "".join(pieces).count("\r\n") == 25 * 22 + 1


def test_an_empty_study_gives_the_heads_of_the_columns(db):
    add_study(db)
    text = "".join(exports.responses_csv(found(db)))
    assert text.strip().split(",") == columns(db)
    assert len(set(columns(db))) == len(columns(db))


def test_every_column_is_explained(db):
    add_study(db)
    told = (Path(__file__).parents[3] / "docs" / "results.md").read_text()
    explained = set(re.findall(r"\w+", told.partition("| column | meaning |")[2]))
    assert set(columns(db)) - set(NEUTRAL) <= explained
