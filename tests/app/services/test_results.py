"""The results page's numbers, computed again from the exported CSV with SciPy alone."""

import csv
import io
import math

import numpy as np
import pytest
from scipy import stats

from app.errors import NotFoundError
from app.persistence.engine import Database
from app.services import answers, exports, results, sentences, sessions
from app.studies import emotion
from tests.support.simulate import add_study, answer_with, begin, directly, simulate, take_part

NEUTRAL = dict.fromkeys((scale["id"] for scale in emotion.SCALES), 0)


@pytest.fixture
def database(db):
    """The test's own transaction, for what opens its database sessions itself."""
    return Database(db.connection())


@pytest.fixture
def study(db):
    add_study(db)
    write, generator = directly(db), np.random.default_rng(11)
    tokens = simulate(write, 7)
    # All that must not be analysed: unfinished and withdrawn sessions, earlier revisions, practice.
    take_part(write, generator, answered=12)
    take_part(write, generator, complete=False)
    sessions.withdraw(db, take_part(write, generator))
    changed = take_part(write, generator, complete=False)
    answers.record(db, changed, answer_with(NEUTRAL | {"sad_happy": -2}, 5, revision=2))
    sessions.complete(db, changed)
    return tokens


def analysed_rows(database):
    text = "".join(exports.responses_csv(exports.exported(database, emotion.SLUG)))
    rows = list(csv.DictReader(io.StringIO(text)))
    return [
        row
        for row in rows
        if row["session_state"] == "complete" and row["newest"] == "1" and row["practice"] == "0"
    ]


def values(rows, scale, **where):
    return np.array(
        [int(row[scale]) for row in rows if all(row[k] == v for k, v in where.items())], float
    )


def test_every_mean_interval_and_share_follows_from_the_csv(db, database, study):
    rows, found = analysed_rows(database), results.results(db, emotion.SLUG)
    assert found.participants == len({row["session"] for row in rows}) == 8
    assert len(found.axes) == 6
    for axis in found.axes:
        assert len(axis.cells) == 20
        for cell in axis.cells:
            x = values(rows, axis.id, stimulus_hash=cell.clip)
            low, high = stats.t.interval(0.95, len(x) - 1, x.mean(), stats.sem(x))
            assert (cell.n, cell.mean) == (len(x), pytest.approx(x.mean()))
            assert (cell.low, cell.high) == (pytest.approx(low), pytest.approx(high))
            assert cell.sd == pytest.approx(stats.tstd(x))
            assert cell.shares == pytest.approx([(x == step).mean() for step in range(-2, 3)])


@pytest.mark.parametrize("against", ["others", "all"])
def test_every_row_of_is_every_emotion_seen_follows_from_the_csv(db, database, study, against):
    rows, found = analysed_rows(database), results.results(db, emotion.SLUG, against)
    p_values = []
    for index, row in enumerate(found.poles):
        sign = 1 if index % 2 else -1
        means = {
            clip.name: sign * values(rows, row.scale, stimulus=clip.name).mean()
            for clip in found.clips
        }
        best = max(means, key=means.get)
        assert row.clip.name == best
        of_body = [r for r in rows if r["body"] == row.clip.body]
        rest = of_body if against == "all" else [r for r in of_body if r["stimulus"] != best]
        x, y = sign * values(rows, row.scale, stimulus=best), sign * values(rest, row.scale)
        test = stats.ttest_ind(x, y, equal_var=False)
        assert (row.t, row.df) == (pytest.approx(test.statistic), pytest.approx(test.df))
        assert row.p == pytest.approx(test.pvalue)
        assert row.mean == pytest.approx(x.mean())
        assert row.others == pytest.approx(y.mean())
        assert row.difference == pytest.approx(x.mean() - y.mean())
        check_effect(row, x, y)
        check_paired(row, rows, rest, best, sign)
        p_values.append(test.pvalue)
    order = np.argsort(p_values)
    steps = np.sort(p_values) * np.arange(12, 0, -1)
    holm = np.minimum(1, np.maximum.accumulate(steps))
    assert [found.poles[i].p_holm for i in order] == pytest.approx(list(holm))


def test_a_permuted_p_follows_from_the_csv_within_what_chance_allows(db, database, study):
    rows, found = analysed_rows(database), results.results(db, emotion.SLUG)
    row = found.poles[0]
    people = sorted({r["session"] for r in rows})
    answers = np.array(
        [[-values(rows, row.scale, stimulus=clip.name, session=one)[0] for clip in found.clips]
         for one in people]
    )  # fmt: skip
    bodies = np.array([clip.body for clip in found.clips])

    def distance(table):
        means = table.mean(axis=0)
        same = bodies == bodies[means.argmax()]
        same[means.argmax()] = False
        return means.max() - means[same].mean()

    generator, reached = np.random.default_rng(99), 1
    for _ in range(300):
        table = answers.copy()
        for person in table:
            for body in ("female", "male"):
                person[bodies == body] = generator.permutation(person[bodies == body])
        reached += distance(table) >= distance(answers) - 1e-9
    expected = reached / 301
    spread = 4 * math.sqrt(max(expected * (1 - expected), 0.01) / 300)
    assert row.p_permuted == pytest.approx(expected, abs=spread)
    assert all(other.p_permuted <= other.p_permuted_holm <= 1 for other in found.poles)


def check_effect(row, x, y):
    student = stats.ttest_ind(x, y)
    scale = math.sqrt(1 / len(x) + 1 / len(y))
    assert row.d == pytest.approx(student.statistic * scale)
    tails = (
        stats.nct.sf(student.statistic, student.df, row.d_low / scale),
        stats.nct.cdf(student.statistic, student.df, row.d_high / scale),
    )
    assert tails == pytest.approx((0.025, 0.025), abs=1e-6)


def check_paired(row, rows, rest, best, sign):
    people = sorted({r["session"] for r in rows})
    a = [sign * values(rows, row.scale, stimulus=best, session=p).mean() for p in people]
    b = [sign * values(rest, row.scale, session=p).mean() for p in people]
    test = stats.ttest_rel(a, b)
    assert (row.paired_t, row.paired_df) == (pytest.approx(test.statistic), test.df)
    assert row.paired_p == pytest.approx(test.pvalue)


def test_the_counts_follow_from_the_csv(db, database, study):
    text = "".join(exports.responses_csv(exports.exported(database, emotion.SLUG)))
    rows = list(csv.DictReader(io.StringIO(text)))
    counts = results.counts(db, emotion.SLUG)
    assert counts.answers == len(rows) == 8 * 22 + 1 + 12 + 22  # 1: the earlier revision
    states = {row["session"]: row["session_state"] for row in rows}
    assert list(states.values()).count("complete") == counts.complete
    assert list(states.values()).count("active") == counts.under_way + counts.left_early
    assert counts.withdrawn == 1


def test_each_row_is_told_in_words_that_match_its_numbers(db, study):
    found = results.results(db, emotion.SLUG)
    sad = found.poles[0]
    assert (sad.pole, sad.clip.style) == ("sad", "sad")
    assert sad.sentence.startswith(
        f"The clip “{sad.clip.label}” was seen as sadder than the same body’s other clips, "
    )
    assert (
        f"t({sad.df:.1f}) = {sad.t:.2f}, p {sentences.p_value(sad.p_holm)} after Holm’s"
        in sad.sentence
    )
    assert f"d = {sad.d:.2f}, 95 % CI [{sad.d_low:.2f}, {sad.d_high:.2f}]." in sad.sentence


def test_below_five_participants_every_number_is_empty_and_the_page_can_say_why(db):
    add_study(db)
    simulate(directly(db), 4)
    found = results.results(db, emotion.SLUG)
    assert (found.participants, found.needed) == (4, 5)
    assert {cell.mean for axis in found.axes for cell in axis.cells} == {None}
    assert {cell.n for axis in found.axes for cell in axis.cells} == {4}
    numbers = [row.model_dump(exclude={"scale", "pole"}).values() for row in found.poles]
    assert {value for row in numbers for value in row} == {None}
    assert "needs five" in found.axes[0].sentence


def test_with_five_participants_there_are_numbers(db):
    add_study(db)
    simulate(directly(db), 5)
    found = results.results(db, emotion.SLUG)
    assert all(row.p is not None for row in found.poles)


def test_a_study_that_nobody_took_has_empty_results(db):
    add_study(db)
    found = results.results(db, emotion.SLUG)
    assert (found.participants, found.counts.answers, found.counts.median_seconds) == (0, 0, None)


def test_everybody_answering_the_middle_gives_no_test_and_no_error(db):
    add_study(db)
    for _ in range(5):
        token = begin(directly(db))
        for index in range(22):
            answers.record(db, token, answer_with(NEUTRAL, index))
        sessions.complete(db, token)
    found = results.results(db, emotion.SLUG)
    assert {row.t for row in found.poles} == {None}
    assert {row.difference for row in found.poles} == {0}
    assert {row.sentence for row in found.poles} == {None}
    assert found.axes[0].cells[0].shares == [0, 0, 1, 0, 0]


def test_an_unknown_study_is_said_to_be_unknown(db, database):
    for asked in (
        lambda: results.results(db, "nothing"),
        lambda: results.counts(db, "nothing"),
        lambda: exports.exported(database, "nothing"),
    ):
        with pytest.raises(NotFoundError) as caught:
            asked()
        assert caught.value.code == "study_not_found"
