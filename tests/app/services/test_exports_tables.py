"""The long table told in other shapes: wide, as JSON lines, explained by its codebook."""

import csv
import io
import json

import numpy as np
import pytest

from app.persistence.engine import Database
from app.schemas.study import StudyDefinition
from app.services import answers, exports, sessions
from app.services.versions import Version
from app.studies import emotion
from tests.support.simulate import add_study, answer_with, begin, directly, simulate, take_part

NEUTRAL = dict.fromkeys((scale["id"] for scale in emotion.SCALES), 0)
# What this study has none of: groups, checks, several figures, exclusions.
EMPTY = ("excluded_reason", "group", "check", "passed", "figure", "figures_ms")
HOSTILE = ("=1+1", "-2+3", "\tx", "@A1", "two\nlines", 'say "yes", she said', "歩く\u202eabc", "-2")


@pytest.fixture
def database(db):
    add_study(db)
    return Database(db.connection())


@pytest.fixture
def answered(db, database):
    """Complete, unfinished and withdrawn participants, a changed answer, comments that attack."""
    simulate(directly(db), 3)
    generator = np.random.default_rng(5)
    take_part(directly(db), generator, answered=7)
    gone = take_part(directly(db), generator)
    token = begin(directly(db), user_agent="Mobile")
    for index, comment in enumerate(HOSTILE):
        answers.record(db, token, answer_with(NEUTRAL, index + 2, comment=comment))
    answers.record(db, token, answer_with(NEUTRAL | {"sad_happy": -2}, 3, revision=2))
    withdrawn = str(sessions.open_session(db, gone).id)
    sessions.withdraw(db, gone)
    return withdrawn


def found(database):
    return exports.exported(database, emotion.SLUG)


def table(pieces):
    return list(csv.DictReader(io.StringIO("".join(pieces))))


def long(database):
    return table(exports.responses_csv(found(database)))


def wide(database):
    return table(exports.wide_csv(found(database)))


def lines(database):
    text = b"".join(exports.responses_jsonl(found(database))).decode()
    return [json.loads(line) for line in text.removesuffix("\n").split("\n")]


def test_the_wide_table_is_the_long_one_pivoted(db, database, answered):
    rows = long(database)
    people = list(dict.fromkeys(row["session"] for row in rows))
    expected = {person: {} for person in people}
    for row in rows:
        if row["newest"] == "1" and row["practice"] == "0" and row["check"] == "":
            cells = expected[row["session"]]
            cells[f"{row['stimulus']}__order"] = row["trial_index"]
            cells |= {f"{row['stimulus']}__{scale}": row[scale] for scale in NEUTRAL}
    pivoted = wide(database)
    assert [row["session"] for row in pivoted] == people
    assert len(people) == 5
    for row in pivoted:
        given = {name: cell for name, cell in row.items() if "__" in name and cell != ""}
        assert given == expected[row["session"]]
        (about,) = {
            tuple(one[name] for name in ("study_hash", "session_state", "device", "seed"))
            for one in rows
            if one["session"] == row["session"]
        }
        assert about == (row["study_hash"], row["session_state"], row["device"], row["seed"])


def test_json_lines_hold_the_cells_of_the_long_table(db, database, answered):
    rows, found = long(database), lines(database)
    assert len(rows) == len(found) == 3 * 22 + 7 + len(HOSTILE) + 1
    for row, line in zip(rows, found, strict=True):
        assert list(line) == list(row)
        cells = {k: "" if v is None else str(exports.safe(v)) for k, v in line.items()}
        assert cells == row


def test_json_lines_keep_text_as_it_was_written_and_numbers_as_numbers(db, database, answered):
    found = [line for line in lines(database) if line["comment"]]
    assert {line["comment"] for line in found} == set(HOSTILE)
    changed = [line for line in lines(database) if line["revision"] == 2]
    assert [line["sad_happy"] for line in changed] == [-2]
    assert {type(line["rt_ms"]) for line in found} == {float}


def test_in_the_tables_no_text_is_a_formula_and_every_number_is_one(db, database, answered):
    for row in long(database):
        assert not row["comment"].startswith(exports.DANGEROUS)
        assert all(abs(int(row[scale])) <= 2 for scale in NEUTRAL)
    for row in wide(database):
        cells = [row[name] for name in row if name.endswith("__sad_happy")]
        assert {int(cell) for cell in cells if cell} <= {-2, -1, 0, 1, 2}


def test_who_withdrew_is_in_no_table(db, database, answered):
    for pieces in (exports.responses_csv, exports.wide_csv):
        assert answered not in "".join(pieces(found(database)))
    assert answered not in {line["session"] for line in lines(database)}


@pytest.mark.parametrize("kind", ["long", "wide"])
def test_the_codebook_names_the_columns_of_its_table_exactly(db, database, answered, kind):
    rows = long(database) if kind == "long" else wide(database)
    book = exports.codebook(found(database), kind)
    told = table(exports.codebook_csv(book))
    assert [column.name for column in book.columns] == list(rows[0])
    assert [row["column"] for row in told] == list(rows[0])
    assert all(row["meaning"] and row["type"] for row in told)


@pytest.mark.parametrize("kind", ["long", "wide"])
def test_every_cell_is_of_the_type_and_the_levels_that_the_codebook_tells(
    db, database, answered, kind
):
    rows = long(database) if kind == "long" else wide(database)
    read = {"integer": int, "number": float}
    for column in exports.codebook(found(database), kind).columns:
        cells = {row[column.name] for row in rows} - {""}
        assert cells or column.name in EMPTY, column.name
        for cell in cells:
            read.get(column.type, str)(cell)
        if column.levels:
            assert cells <= {str(level.value) for level in column.levels}


def test_a_scales_levels_say_how_each_step_was_called(db, database):
    columns = {column.name: column for column in exports.codebook(found(database)).columns}
    assert [(level.value, level.label) for level in columns["weak_strong"].levels] == [
        (-2, "very weak"), (-1, "rather weak"), (0, "neither"),
        (1, "rather strong"), (2, "very strong"),
    ]  # fmt: skip
    (row,) = (
        row
        for row in table(exports.codebook_csv(exports.codebook(found(database))))
        if row["column"] == "weak_strong"
    )
    assert row["levels"].startswith("very weak = -2; rather weak = -1; ")


def test_scales_and_clips_may_be_called_anything_and_no_two_columns_are_alike(db):
    definition = add_study(db)
    names = ("comment", "study", "order", "rt_ms", "comment_2")
    clips = ("=1+1", "order", "a b", "a-b", "a,b\n")
    told = definition.model_dump(mode="json")
    (part,) = told["parts"]
    part["task"]["scales"] = [{"id": name, "left": "a", "right": "b"} for name in names]
    part["stimuli"] = [
        stimulus | {"name": name} for stimulus, name in zip(part["stimuli"], clips, strict=False)
    ]
    version = Version.of(1, "0" * 64, StudyDefinition.model_validate(told), {})
    odd = found(Database(db.connection()))._replace(versions={1: version})
    for kind in ("long", "wide"):
        heads = [column.name for column in exports.codebook(odd, kind).columns]
        assert len(set(heads)) == len(heads)
        assert all(head.replace("_", "a").isalnum() for head in heads)
    wide_heads = [head for head in heads if "__" in head]
    assert len(wide_heads) == 5 * (1 + 5)
    assert wide_heads[0::6] == [
        "_1_1__order", "order__order", "a_b__order", "a_b_2__order", "a_b_3__order"
    ]  # fmt: skip


def test_nobody_having_answered_leaves_the_heads_alone(db, database):
    assert wide(database) == []
    assert b"".join(exports.responses_jsonl(found(database))) == b""
    heads = "".join(exports.wide_csv(found(database))).strip().split(",")
    assert heads == [one.name for one in exports.codebook(found(database), "wide").columns]
