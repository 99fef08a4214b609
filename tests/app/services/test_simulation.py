"""Simulated participants: whole sessions, stated effects, and how often those would be found."""

from collections import Counter

import numpy as np
import pytest
from sqlalchemy import select

from app.errors import InvalidError
from app.persistence.models import Response, StudySession
from app.schemas.effects import Effects
from app.schemas.study import Form
from app.services import rehearsal, simulation, studies
from app.services.answer_checks import faults_of
from app.services.effects import read_effects, tastes
from app.services.rehearsal import Effect
from app.statistics.power import power
from app.studies import emotion
from tests.support import kinds
from tests.support.simulate import add_study, directly

SAD = Effects(effects={"sad_happy": {"sad": -1.5}, "weak_strong": {"strong": 1.2}})


def definition_of(db, slug):
    return studies.definition_of(studies.newest(db, studies.find(db, slug)))


def run(db, slug, effects, number, seed=1, dropout=0.0):
    definition, generator = definition_of(db, slug), np.random.default_rng(seed)
    felt = tastes(definition, effects)
    raters = simulation.raters(felt, effects, number, generator)
    return felt, list(simulation.run(directly(db), directly(db), slug, raters, dropout, generator))


def test_sessions_of_every_kind_are_whole_and_kept_apart(db):
    kinds.add_every_kind(db)
    _, courses = run(db, kinds.SLUG, Effects(), 4)
    assert all(course.complete for course in courses)
    people = list(db.scalars(select(StudySession)))
    assert {person.kind for person in people} == {"simulated"}
    for person in people:
        stored = select(Response).where(Response.session_id == person.id)
        assert len(list(db.scalars(stored))) == len(person.plan["steps"])
        assert person.completion_code


def test_checks_are_answered_as_an_attentive_person_does(db):
    kinds.add_every_kind(db)
    run(db, kinds.SLUG, Effects(noise=0, rater_sd=0), 3)
    checks = db.execute(select(Response.check, Response.passed).where(Response.check.is_not(None)))
    assert Counter(map(tuple, checks)) == {("read", True): 3, ("again", True): 3}


@pytest.mark.parametrize(
    "limits",
    [(None, None), (None, 10), (None, -3.5), (90, None), (0.2, 0.8), (-2.5, -0.5), (18, 18)],
)
def test_a_number_is_given_within_its_limits_whatever_they_are(db, limits):
    kinds.add_every_kind(db)
    fields = [{"id": "n", "label": "Number", "type": "number", "minimum": limits[0],
               "maximum": limits[1]}]  # fmt: skip
    form = Form.model_validate({"id": "you", "heading": "You", "fields": fields})
    study = definition_of(db, kinds.SLUG).model_copy(update={"parts": (form,)})
    rater = simulation.Rater({}, 1, 1, np.random.default_rng(1))
    for _ in range(20):
        assert faults_of(form, rater.answer(study, {"part": "you"}), 0) == []


def test_those_who_drop_out_leave_on_the_way_and_count_for_nothing(db):
    add_study(db)
    _, courses = run(db, emotion.SLUG, SAD, 20, dropout=0.25)
    assert sum(course.complete for course in courses) == 15
    assert all(bool(course.counted) == course.complete for course in courses)
    states = Counter(db.scalars(select(StudySession.state)))
    assert states == {"complete": 15, "active": 5}


def test_the_same_seed_gives_the_same_answers_in_the_same_order(db):
    add_study(db)
    first, second, other = (
        [row.answers for course in run(db, emotion.SLUG, SAD, 2, seed)[1] for _, row in
         course.counted]
        for seed in (5, 5, 6)
    )  # fmt: skip
    assert first == second != other


def test_stated_effects_come_out_of_the_answers(db):
    add_study(db)
    felt, courses = run(db, emotion.SLUG, SAD, 25)
    rows = [row for course in courses for row in course.counted]
    found = rehearsal.from_answers(felt, SAD, rows)
    assert [(one.effect.value, one.effect.about, one.found) for one in found] == [
        ("sad_happy", "sad", True), ("weak_strong", "strong", True),
    ]  # fmt: skip
    # Two of twenty clips are sad: −1.5 against 0 of the others.
    assert [round(one.effect.size, 9) for one in found] == [-1.5, 1.2]


def test_without_effects_nothing_is_to_be_found(db):
    add_study(db)
    felt, courses = run(db, emotion.SLUG, Effects(), 3)
    rows = [row for course in courses for row in course.counted]
    assert rehearsal.from_answers(felt, Effects(), rows) == []


def test_one_contrasts_power_is_the_statistics_own(db):
    """Of two clips alone the contrast is their difference."""
    kinds.add_every_kind(db)
    told = studies.newest(db, studies.find(db, kinds.SLUG)).definition
    part = told["parts"][1] | {"checks": [], "practice": 0}
    part["stimuli"] = part["stimuli"][:2]
    definition = type(definition_of(db, kinds.SLUG)).model_validate(told | {"parts": [part]})
    effects = Effects(
        noise=0.9, rater_sd=0.3, effects={"sad_happy": {"angry": -0.25, "happy": 0.25}}
    )
    felt = tastes(definition, effects)
    (one, other) = rehearsal.repeated(
        definition, felt, effects, 30, np.random.default_rng(1), runs=600
    )
    assert (one[0], other[0].about) == (Effect("pairs", "sad_happy", "angry", -0.5), "happy")
    # Holm over two tests that are the same: the first one needs half the level.
    expected = power(
        0.5, 30, np.random.default_rng(2),
        noise=0.9, rater_sd=0.3, lowest=-2, highest=2, alpha=0.025, runs=4000,
    )  # fmt: skip
    assert one[1].share == pytest.approx(expected.share, abs=0.08)


def test_of_effects_that_are_none_few_are_found(db):
    add_study(db)
    definition = definition_of(db, emotion.SLUG)
    tiny = Effects(effects={"sad_happy": {"sad": 1e-6}})
    ((_, found),) = rehearsal.repeated(
        definition, tastes(definition, tiny), tiny, 15, np.random.default_rng(3), runs=400
    )
    assert found.share < 0.06  # half of the level: the sign must be right


@pytest.mark.parametrize("part", ["best", "two", "third", "together", "order", "sliders"])
def test_stored_and_repeated_runs_answer_alike(db, part):
    """What raters do step by step in sessions, and all at once in the repeats, is the same."""
    kinds.add_every_kind(db)
    effects = Effects(
        effects={
            "choice": {"happy": 1.0}, "rating": {"happy": 1.0}, "rank": {"happy": 1.0},
            "sad_happy": {"happy": 1.0},
        }
    )  # fmt: skip
    felt, courses = run(db, kinds.SLUG, effects, 40)
    (taste,) = (one for one in felt if one.part.id == part)
    rows = [row for course in courses for name, row in course.counted if name == part]
    stored = rehearsal._observed(taste, rows)
    generator = np.random.default_rng(4)
    shown = rehearsal._shown(definition_of(db, kinds.SLUG), 400, generator)
    drawn = rehearsal._drawn(taste, effects, shown[part], generator)
    error = drawn.std(axis=0) * np.sqrt(1 / 40 + 1 / 400)
    assert (np.abs(stored.mean(axis=0) - drawn.mean(axis=0)) < 4.5 * error + 1e-9).all()
    assert drawn.shape[1:] == stored.shape[1:]


def read_and_fit(definition, text):
    effects, read = read_effects(text, "effects.yaml")
    return tastes(definition, effects, read, "effects.yaml")


EFFECTS_FILE = """\
noise: 0.7
effects:
  sad_happy:
    sad: -1.5
    female: 0.2
"""


def test_an_effects_file_is_read_and_what_fits_a_clip_adds_up(db):
    add_study(db)
    effects, read = read_effects(EFFECTS_FILE, "effects.yaml")
    assert (effects.noise, effects.rater_sd) == (0.7, 0.25)
    (taste,) = tastes(definition_of(db, emotion.SLUG), effects, read)
    felt = {one.name: row[0] for one, row in zip(taste.part.stimuli, taste.latent, strict=True)}
    assert felt["acted_female_sad"] == pytest.approx(-1.3)
    assert (felt["acted_male_sad"], felt["acted_male_happy"]) == (-1.5, 0)


@pytest.mark.parametrize(
    ("old", "new", "line", "said"),
    [
        ("sad: -1.5", "sadd: -1.5", 4, "called “sadd”"),
        ("sad_happy", "sad_hapy", 3, "no “sad_hapy”"),
        ("noise", "nois", 1, "nois"),
        ("0.7", "-1", 1, "noise"),
        ("-1.5", "much", 4, "sad"),
        ("  sad_happy:", "  sad_happy: [", 3, "line"),
    ],
)
def test_a_wrong_effects_file_is_told_its_line_and_the_mend(db, old, new, line, said):
    add_study(db)
    definition = definition_of(db, emotion.SLUG)
    with pytest.raises(InvalidError, match=said) as caught:
        read_and_fit(definition, EFFECTS_FILE.replace(old, new, 1))
    assert caught.value.message.startswith("effects.yaml, line ")
    assert caught.value.where["line"] >= line
    assert caught.value.mend
