"""Tables, results and scripts of a study that has every kind of trial and page."""

import csv
import io
import json
import zipfile
from collections import Counter
from datetime import timedelta

import numpy as np
import pytest
from scipy import stats
from sqlalchemy import select

from app.errors import NotFoundError
from app.persistence import schema
from app.persistence.engine import Database, make_engine
from app.persistence.models import Response, StudySession
from app.schemas.effects import Effects
from app.services import analysis, charts, exports, psych_ds, results, simulation, studies
from app.services.effects import tastes
from tests.app.services.test_analysis import run_notebook
from tests.app.services.test_psych_ds import hold_to_the_rules
from tests.support import kinds

EFFECTS = Effects(
    effects={
        "sad_happy": {"sad": -1, "happy": 1},
        "calm": {"neutral": 1},
        "choice": {"happy": 1},
        "rating": {"happy": 1},
        "rank": {"happy": 1},
    }
)
PEOPLE, LEFT = 9, 2
PARTS = (
    "pairs", "qualities", "agreement", "sliders", "best", "two", "third", "together", "order",
    "words",
)  # fmt: skip


@pytest.fixture(scope="module")
def database(tmp_path_factory):
    """Simulated participants of every kind of trial, made people afterwards; two left early.

    One SQLite for all tests: what is asked here is the same of whatever database.
    """
    path = tmp_path_factory.mktemp("kinds") / "kinds.sqlite3"
    found = Database(make_engine(f"sqlite:///{path}"))
    schema.upgrade(found.engine)
    with found.writing() as db:
        kinds.add_every_kind(db)
        answer(db, PEOPLE, 1)
        answer(db, LEFT, 2, stop_after=0.5)
        for session in db.scalars(select(StudySession)):
            session.kind = "participant"
        db.commit()
    yield found
    found.engine.dispose()


def answer(db, number, seed, **more):
    definition = studies.definition_of(studies.newest(db, studies.find(db, kinds.SLUG)))
    generator = np.random.default_rng(seed)
    felt = tastes(definition, EFFECTS)
    for rater in simulation.raters(felt, EFFECTS, number, generator):
        simulation.take_part(db, kinds.SLUG, rater, **more)


@pytest.fixture(scope="module")
def found(database):
    return exports.exported(database, kinds.SLUG)


@pytest.fixture(scope="module")
def long(found):
    return list(csv.DictReader(io.StringIO("".join(exports.responses_csv(found)))))


@pytest.fixture(scope="module")
def stored(database):
    with database.reading() as db:
        rows = db.execute(select(Response, StudySession).join(StudySession)).all()
        return [(answer, person) for answer, person in rows]


def of_part(rows, part):
    return [row for row in rows if row["part"] == part]


def test_every_answer_is_one_row_and_of_compared_figures_one_a_figure(long, stored):
    expected = Counter()
    for answer, _ in stored:
        each = answer.trial_type in ("parallel", "ranking")
        expected[answer.part] += len(answer.clips) if each else 1
    assert Counter(row["part"] for row in long) == expected
    named = Counter(
        (row["session"], row["trial_index"], row["revision"], row["figure"]) for row in long
    )
    assert set(named.values()) == {1}


def test_each_kinds_values_are_those_that_were_stored(found, long, stored):
    names = {clip.clip: clip.name for clip in found.newest.definition.part("pairs").stimuli}
    columns = {
        "pairs": "pairs__sad_happy", "qualities": "calm", "agreement": "real",
        "sliders": "sliders__sad_happy",
    }  # fmt: skip
    rows = {(r["session"], int(r["trial_index"]), r["figure"]): r for r in long}
    for answer, person in stored:
        row = rows.get((str(person.id), answer.trial_index, ""))
        if answer.part in columns:
            (value,) = answer.answers.values()
            assert int(row[columns[answer.part]]) == value
        elif answer.part in ("best", "two", "third"):
            choice, none = answer.answers["choice"], {"best": "none", "two": "same"}
            expected = names[answer.clips[choice]] if choice >= 0 else none[answer.part]
            assert row[f"{answer.part}__choice"] == expected
            assert row[f"{answer.part}__choice__hash"] == (
                answer.clips[choice] if choice >= 0 else ""
            )
            assert row["stimuli"].split("|") == [names[clip] for clip in answer.clips]
        elif answer.part in ("together", "order"):
            column = "rating" if answer.part == "together" else "rank"
            for place, clip in enumerate(answer.clips):
                row = rows[str(person.id), answer.trial_index, str(place)]
                assert int(row[column]) == answer.answers[str(place)]
                assert row["stimulus_hash"] == clip


def test_of_a_third_figure_the_table_tells_who_was_right(long, stored):
    plans = {str(person.id): person.plan["steps"] for _, person in stored}
    rows = of_part(long, "third")
    assert len(rows) >= 6 * PEOPLE
    for row in rows:
        step = plans[row["session"]][int(row["trial_index"])]
        chosen = step["clips"].index(row["third__choice__hash"])
        assert int(row["correct"]) == int(chosen == step["x"])
    assert {row["correct"] for row in rows} == {"0", "1"}


def test_the_pages_answers_are_columns_of_their_own(long):
    people = of_part(long, "person")
    assert len(people) == PEOPLE + LEFT
    for row in people:
        assert 18 <= int(row["age"]) <= 90
        assert int(row["moves__sport"]) + int(row["moves__dance"]) == 1
        assert row["likes"] in ("sport", "dance")
        assert row["stimulus"] == row["stimuli"] == ""


def test_checks_and_practice_are_marked_and_kept_out_of_the_results(long, database):
    pairs = of_part(long, "pairs")
    checks = Counter(row["check"] for row in pairs if row["check"])
    assert checks["read"] == checks["again"] == PEOPLE + LEFT
    assert {row["passed"] for row in pairs if row["check"] == "read"} == {"1"}
    with database.reading() as db:
        page = results.results(db, kinds.SLUG)
    counted = [
        row
        for row in pairs
        if row["session_state"] == "complete" and row["practice"] == "0" and not row["check"]
    ]
    for cell in page.axes[0].cells:
        own = [int(r["pairs__sad_happy"]) for r in counted if r["stimulus_hash"] == cell.clip]
        assert (cell.n, cell.mean) == (PEOPLE, pytest.approx(np.mean(own)))


@pytest.mark.parametrize("table", ["long", "wide"])
def test_the_codebook_holds_for_every_cell(found, long, table):
    rows = long
    if table == "wide":
        rows = list(csv.DictReader(io.StringIO("".join(exports.wide_csv(found)))))
    read = {"integer": int, "number": float}
    book = exports.codebook(found, table)
    assert [column.name for column in book.columns] == list(rows[0])
    for column in book.columns:
        cells = {row[column.name] for row in rows} - {""}
        for cell in cells:
            read.get(column.type, str)(cell)
        if column.levels and column.name not in ("part", "trial_type"):
            levels = {str(level.value) for level in column.levels} | {"none", "same"}
            assert cells <= levels, column.name


def test_the_wide_table_holds_the_long_ones_numbers(found, long):
    wide = list(csv.DictReader(io.StringIO("".join(exports.wide_csv(found)))))
    assert len(wide) == PEOPLE + LEFT
    for row in wide:
        own = [one for one in long if one["session"] == row["session"]]
        for one in of_part(own, "together"):
            assert row[f"together__{one['stimulus']}__rating"] == one["rating"]
        for one in of_part(own, "third"):
            a, b = sorted(one["stimuli"].split("|")[:2])
            assert row[f"third__{a}_vs_{b}__correct"] == one["correct"]
        for one in of_part(own, "best"):
            assert row["best__choice"] == one["best__choice"]
        (person,) = of_part(own, "person")
        assert row["age"] == person["age"]


@pytest.mark.parametrize("part", PARTS)
def test_every_part_has_results_and_charts(database, part):
    with database.reading() as db:
        page = results.results(db, kinds.SLUG, part=part)
    assert page.part.id == part
    assert [one.id for one in page.parts] == list(PARTS)
    assert page.participants == PEOPLE
    shown = charts.page_charts(page)
    expected = {f"means-{axis.id}" for axis in page.axes}
    expected |= {f"shares-{axis.id}" for axis in page.axes if axis.steps}
    expected |= {f"chosen-{one.id}" for one in page.choices}
    assert set(shown) == expected
    assert bool(expected) == (part != "words")
    for name in expected:
        assert "<svg" in charts.printed(page, name, "light")
    for axis in page.axes:
        for cell in axis.cells:
            assert axis.lowest <= cell.mean <= axis.highest
            assert cell.shares is None or sum(cell.shares) == pytest.approx(1)
    assert page.texts == (PEOPLE * 4 if part == "words" else 0)


def test_shares_of_choices_follow_from_the_table(long, database):
    with database.reading() as db:
        two = results.results(db, kinds.SLUG, part="two").choices[0]
        third = results.results(db, kinds.SLUG, part="third").choices[0]
    counted = [r for r in of_part(long, "two") if r["session_state"] == "complete"]
    for share in two.rows[:-1]:
        shown = [r for r in counted if share.clip in r["stimuli_hashes"].split("|")]
        taken = sum(r["two__choice__hash"] == share.clip for r in shown)
        assert (share.chosen, share.shown) == (taken, len(shown))
        interval = stats.binomtest(taken, len(shown)).proportion_ci(method="wilson")
        assert (share.low, share.high) == (
            pytest.approx(interval.low), pytest.approx(interval.high),
        )  # fmt: skip
    same = sum(r["two__choice"] == "same" for r in counted)
    assert (two.rows[-1].name, two.rows[-1].chosen) == ("no difference", same)
    counted = [r for r in of_part(long, "third") if r["session_state"] == "complete"]
    assert (third.chance, third.rows[0].name) == (0.5, "all pairs")
    assert third.rows[0].chosen == sum(int(r["correct"]) for r in counted)
    assert len(third.rows) == 1 + 6


def test_the_notebook_finds_the_pages_numbers_of_every_kind(database, found, tmp_path):
    text = "".join(exports.responses_csv(found))
    (tmp_path / analysis.answers_file(found)).write_text(text, "utf-8", newline="")
    tables = run_notebook(analysis.notebook(found), tmp_path)
    means, shares = [], []
    with database.reading() as db:
        for part in PARTS:
            page = results.results(db, kinds.SLUG, part=part)
            means += [cell for axis in page.axes for cell in axis.cells]
            shares += [row for one in page.choices for row in one.rows]
    assert len(tables["means"]) == len(means) == 6 * 4
    for row, cell in zip(tables["means"], means, strict=True):
        for name in ("n", "mean", "sd", "low", "high"):
            assert row[name] == pytest.approx(getattr(cell, name), abs=1e-9)
    assert [(row["name"], row["chosen"], row["shown"]) for row in tables["shares"]] == [
        (one.name, one.chosen, one.shown) for one in shares
    ]
    for row, one in zip(tables["shares"], shares, strict=True):
        for name in ("share", "low", "high"):
            assert row[name] == pytest.approx(getattr(one, name), abs=1e-9)


def test_the_dataset_keeps_the_rules_with_every_kind(found):
    content = io.BytesIO(b"".join(psych_ds.dataset_zip(found)))
    with zipfile.ZipFile(content) as archive:
        files = {name.partition("/")[2]: archive.read(name) for name in archive.namelist()}
    hold_to_the_rules(files)
    described = json.loads(files["dataset_description.json"])
    names = {one["name"] for one in described["variableMeasured"]}
    assert {"rating", "rank", "correct", "best__choice", "words__text", "age"} <= names


def test_json_lines_have_no_nested_values(found):
    for line in b"".join(exports.responses_jsonl(found)).splitlines():
        assert not any(isinstance(value, dict | list) for value in json.loads(line).values())


def test_a_part_that_is_not_there_is_said_not_to_be(database):
    with database.reading() as db, pytest.raises(NotFoundError, match="no part “mood”"):
        results.results(db, kinds.SLUG, part="mood")


def test_simulated_answers_are_apart(db):
    study = kinds.add_every_kind(db)
    answer(db, 5, 3)
    database = Database(db.connection())
    people, made = (exports.exported(database, study.slug, k) for k in ("participant", "simulated"))
    assert "".join(exports.responses_csv(people)).count("\r\n") == 1
    assert "simulated" in "".join(exports.responses_csv(made))
    page = results.results(db, study.slug)
    assert (page.participants, page.counts.complete, page.simulated) == (0, 0, 5)
    assert results.results(db, study.slug, kind="simulated").participants == 5


def test_excluded_participants_stay_in_the_tables_and_leave_the_results(db):
    study = kinds.add_every_kind(db)
    answer(db, 6, 4)
    for session in db.scalars(select(StudySession)):
        session.kind = "participant"
    session.excluded = {"reason": "always the middle", "by": 1, "at": "now"}
    db.commit()
    page = results.results(db, study.slug)
    assert (page.participants, page.counts.complete, page.counts.excluded) == (5, 5, 1)
    found = exports.exported(Database(db.connection()), study.slug)
    rows = list(csv.DictReader(io.StringIO("".join(exports.responses_csv(found)))))
    left_out = {(r["session"], r["excluded_reason"]) for r in rows if r["excluded"] == "1"}
    assert left_out == {(str(session.id), "always the middle")}
    assert len({r["session"] for r in rows}) == 6


def test_each_answer_is_read_by_its_own_version(db):
    study = kinds.add_every_kind(db)
    answer(db, 5, 5)
    told = studies.newest(db, study).definition
    told = json.loads(json.dumps(told))
    pairs, qualities = told["parts"][1], told["parts"][2]
    pairs["stimuli"] = pairs["stimuli"][:3]  # asks alike of fewer clips
    qualities["task"]["steps"] = ["no", "yes"]  # asks otherwise
    kinds.publish(db, study, told)
    answer(db, 5, 6)
    for session in db.scalars(select(StudySession)):
        session.kind = "participant"
    db.commit()
    found = exports.exported(Database(db.connection()), study.slug)
    rows = list(csv.DictReader(io.StringIO("".join(exports.responses_csv(found)))))
    hashes = {(row["version"], row["study_hash"]) for row in rows}
    assert hashes == {(str(one.number), one.hash) for one in found.listed}
    page = results.results(db, study.slug, part="pairs")
    assert page.participants == 10
    assert [cell.n for cell in page.axes[0].cells] == [10, 10, 10, 5]
    assert "Versions 1, 2 are taken together" in page.rule
    page = results.results(db, study.slug, part="qualities")
    assert page.participants == 5
    assert "Answers to version 1, which asked otherwise" in page.rule


def test_a_version_published_during_a_download_breaks_it_off_for_nobody(db):
    study = kinds.add_every_kind(db)
    answer(db, 2, 7)
    found = exports.exported(Database(db.connection()), study.slug, "simulated")
    kinds.publish(db, study, kinds.definition(kinds.clips(db)) | {"title": "Another"})
    answer(db, 1, 8)
    rows = list(csv.DictReader(io.StringIO("".join(exports.responses_csv(found)))))
    assert {row["version"] for row in rows} == {"1"}
    assert len({row["session"] for row in rows}) == 2


def test_whom_to_pay_is_told_without_pseudonyms(db):
    study = kinds.add_every_kind(db)
    answer(db, 3, 7)
    one, two, three = db.scalars(select(StudySession))
    for session in (one, two, three):
        session.kind = "participant"
    one.source, one.external = "mturk", {"workerId": "W", "assignmentId": "A"}
    two.source, two.external = "prolific", {"PROLIFIC_PID": "=abc", "SESSION_ID": "s1"}
    two.created_at = one.created_at + timedelta(seconds=1)  # whoever came first stands second
    db.commit()
    found = exports.exported(Database(db.connection()), study.slug)
    text = "".join(exports.recruiting_csv(found))
    rows = list(csv.DictReader(io.StringIO(text)))
    assert [(r["id"], r["submission"], r["source"], r["outcome"]) for r in rows] == [
        ("'=abc", "s1", "prolific", "complete"), ("W", "A", "mturk", "complete"),
    ]  # fmt: skip
    assert all(r["code"] and float(r["minutes"]) >= 0 for r in rows)
    assert not any(str(session.id) in text for session in (one, two, three))
    simulated = exports.exported(Database(db.connection()), study.slug, "simulated")
    assert "".join(exports.recruiting_csv(simulated)).count("\n") == 1  # nobody sent them
    for pieces in (exports.responses_csv, exports.wide_csv):
        assert "abc" not in "".join(pieces(found))
