"""The clips of a study: names become ids, what is to be made is made once, faults name the clip."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest

from app.errors import InvalidError
from app.persistence import clips
from app.persistence.engine import Database, make_engine
from app.persistence.models import ClipRecord
from app.persistence.writer import Writer
from app.schemas.study import StudyDefinition
from app.services import edits, samples, sets, study_stimuli
from app.studies import TEMPLATES
from tests.support.motions import walks

MADE = [
    {"made": {"source": "set_a_proud", "preset": "tired"}},
    {
        "made": {
            "source": "set_a_proud",
            "operations": [{"operation": "path_length@1", "parameters": {"gain": 1.5}}],
        },
        "name": "longer",
    },
]


class Here:
    """Does in this process what workers do."""

    def run(self, _: str, function, *arguments):
        return function(*arguments)


@pytest.fixture
def database(database_url: str) -> Iterator[Database]:
    database = Database(make_engine(database_url))
    samples.make(database, walks)
    yield database
    database.engine.dispose()


@pytest.fixture
def make(database: Database) -> Iterator[study_stimuli.Make]:
    writer = Writer(database)
    yield study_stimuli.maker(database, writer, Here())
    writer.close()


def study(stimuli: list, **task: object) -> StudyDefinition:
    document = TEMPLATES["adjectives-short"].build()
    document["parts"][2]["stimuli"] = stimuli
    document["parts"][2]["task"] |= task
    return StudyDefinition.model_validate(document)


def comparison(stimuli: list, sets: list) -> StudyDefinition:
    document = TEMPLATES["side-by-side"].build()
    document["parts"][2] |= {"stimuli": stimuli, "sets": sets}
    return StudyDefinition.model_validate(document)


def ids(database: Database) -> dict[str, str]:
    with database.reading() as db:
        return {clip.name: clip.id for clip, _ in clips.listed(db, imported=True)}


def test_every_clip_is_called_by_its_id_once_published(database, make) -> None:
    with database.reading() as db:
        published = study_stimuli.resolve(db, study(["set_a_proud", *MADE]), make)
    known = ids(database)
    how_it_works, trials = published.parts[1], published.parts[2]
    assert published.welcome.example == known["set_a_neutral"]
    assert how_it_works.figures[0].clip == known["set_a_neutral"]
    assert trials.task.reference == known["set_a_neutral"]
    assert [one.clip for one in trials.stimuli] == [
        known["set_a_proud"], known["set_a_proud · tired"], known["set_a_proud · longer"],
    ]  # fmt: skip


def test_names_labels_bodies_and_styles_come_from_tags_where_the_file_has_none(
    database, make
) -> None:
    given = ["set_a_proud", *MADE, {"clip": "set_a_neutral", "label": "mine", "style": "own"}]
    with database.reading() as db:
        stimuli = study_stimuli.resolve(db, study(given), make).parts[2].stimuli
    assert [(one.name, str(one.label), one.body, one.style) for one in stimuli] == [
        ("set_a_proud", "proud, adult", "adult", "proud"),
        ("set_a_proud · tired", "tired, adult, modified", "adult", "tired"),
        ("longer", "longer, adult, modified", "adult", None),
        ("set_a_neutral", "mine", "adult", "own"),
    ]


def test_what_is_made_is_made_once_and_gives_the_same_definition(database, make) -> None:
    requests = []

    def counting(wanted) -> None:
        requests.extend(wanted)
        make(wanted)

    definitions = []
    for _ in range(2):
        with database.reading() as db:
            definitions.append(study_stimuli.resolve(db, study(MADE), counting))
    assert [request.name for request in requests] == [
        "set_a_proud · tired", "set_a_proud · longer",
    ]  # fmt: skip
    assert definitions[0].content_hash == definitions[1].content_hash
    with database.reading() as db:
        made = clips.by_id(db, definitions[0].parts[2].stimuli[0].clip)
    assert made.recipe_source == ids(database)["set_a_proud"]
    assert made.tags["made"] == "modified"


def test_what_publishing_would_give_is_known_before_anything_is_made(database, make) -> None:
    with database.reading() as db:
        foretold = study_stimuli.resolve(db, study(MADE), lambda requests: None)
    assert set(ids(database)) == {"set_a_neutral", "set_a_energetic", "set_a_proud"}
    with database.reading() as db:
        assert study_stimuli.resolve(db, study(MADE), make) == foretold


def test_a_published_definition_stays_as_it_is_when_it_is_published_again(database, make) -> None:
    with database.reading() as db:
        published = study_stimuli.resolve(db, study(["set_a_proud", *MADE]), make)
    with database.writing() as db:
        clips.retire_samples(db)
        db.commit()
    with database.reading() as db:
        assert study_stimuli.resolve(db, published, make) == published


def test_a_preview_shows_what_is_not_made_yet_as_its_source(database) -> None:
    with database.reading() as db:
        previewed = study_stimuli.shown(db, study(["set_a_neutral", *MADE]))
    known = ids(database)
    assert [one.clip for one in previewed.parts[2].stimuli] == [
        known["set_a_neutral"], known["set_a_proud"], known["set_a_proud"],
    ]  # fmt: skip


def test_a_clip_that_a_set_has_made_already_is_the_same_clip(database, make) -> None:
    with database.writing() as db:
        source = db.get(ClipRecord, ids(database)["set_a_proud"])
        name, tags = sets.name_and_tags(source, "tired")
    request = edits.ClipRequest(source=source.id, preset="tired", name=name, tags=tags)
    make([request])
    asked = []
    with database.reading() as db:
        published = study_stimuli.resolve(db, study([MADE[0]]), asked.extend)
    assert asked == []
    assert published.parts[2].stimuli[0].clip == ids(database)[name]


def test_sets_name_stimuli_by_the_clip_or_by_the_name_given(database, make) -> None:
    given = comparison(
        ["set_a_proud", {"clip": "set_a_neutral", "name": "plain"}, MADE[1]],
        [["set_a_proud", "set_a_neutral"], ["plain", "longer"]],
    )
    with database.reading() as db:
        part = study_stimuli.resolve(db, given, make).parts[2]
    assert part.sets == (("set_a_proud", "plain"), ("plain", "longer"))
    assert {name for one in part.sets for name in one} <= {one.name for one in part.stimuli}


@pytest.mark.parametrize(
    ("stimulus", "where", "message", "mend"),
    [
        ("set_a_prowd", ["clip"], "no clip “set_a_prowd”", "Did you mean “set_a_proud”?"),
        ("f" * 64, ["clip"], "no clip", "library"),
        (
            {"made": {"source": "set_a_prod", "preset": "tired"}},
            ["made", "source"], "no clip “set_a_prod”", "Did you mean “set_a_proud”?",
        ),
        (
            {"made": {"source": "set_a_proud", "preset": "tird"}},
            ["made", "preset"], "no preset", "tired",
        ),
        (
            {"made": {"source": "set_a_proud", "operations": [{"operation": "path_lenght@1"}]}},
            ["made", "operations", 0, "operation"], "path_lenght@1", "path_length@1",
        ),
        (
            {
                "made": {
                    "source": "set_a_proud",
                    "operations": [{"operation": "path_length@1", "parameters": {"gain": 9}}],
                }
            },
            ["made", "operations", 0, "parameters", "gain"], "out of range", "0 to 3",
        ),
    ],
)  # fmt: skip
def test_what_is_not_there_or_cannot_be_made_is_told_at_its_place(
    database, make, stimulus, where, message, mend
) -> None:
    definition = study(["set_a_neutral", stimulus])
    with database.reading() as db:
        (problem,) = study_stimuli.problems(db, definition)
        with pytest.raises(InvalidError) as told:
            study_stimuli.resolve(db, definition, make)
    assert problem.where == ["parts", 2, "stimuli", 1, *where]
    assert message in problem.message
    assert mend in (problem.mend or "")
    assert told.value.where == {"problems": [problem.model_dump()]}


def test_the_same_clip_by_name_and_by_id_is_told(database) -> None:
    proud = ids(database)["set_a_proud"]
    with database.reading() as db:
        (problem,) = study_stimuli.problems(db, study(["set_a_proud", "set_a_neutral", proud]))
    assert problem.where == ["parts", 2, "stimuli", 2]
    assert "same clip as number 1" in problem.message


def test_two_clips_of_one_name_need_names_of_their_own(database) -> None:
    known = ids(database)
    twins = [known["set_a_proud"], known["set_a_energetic"]]
    with database.writing() as db:
        for clip_id in twins:
            db.get(ClipRecord, clip_id).name = "twin"
        db.commit()
        (problem,) = study_stimuli.problems(db, study(twins))
        named = [{"clip": twins[0], "name": "left"}, twins[1]]
        assert study_stimuli.problems(db, study(named)) == []
    assert "same name as number 1" in problem.message
    assert "name of its own" in (problem.mend or "")


def test_a_clip_that_waits_to_be_confirmed_or_is_one_of_two_is_no_stimulus(database) -> None:
    with database.writing() as db:
        known = {clip.name: clip for clip, _ in clips.listed(db, imported=True)}
        known["set_a_proud"].state = "to_confirm"
        known["set_a_energetic"].name = "set_a_neutral"
        db.commit()
        found = study_stimuli.problems(db, study(["set_a_proud"]))
    told = {json.dumps(problem.where): problem.message for problem in found}
    assert "waits to be confirmed" in told['["parts", 2, "stimuli", 0, "clip"]']
    assert "2 clips" in told['["welcome", "example"]']


def test_a_clip_that_cannot_be_computed_is_named(database, make) -> None:
    # The walk is over long before, so that nothing would be left of it.
    cut = [{"operation": "cut@1", "parameters": {"start": 50.0, "end": 60.0}}]
    stimulus = {"made": {"source": "set_a_proud", "operations": cut}, "name": "nothing"}
    with (
        database.reading() as db,
        pytest.raises(InvalidError, match="“set_a_proud · nothing” cannot be made"),
    ):
        study_stimuli.resolve(db, study([stimulus]), make)
    assert set(ids(database)) == {"set_a_neutral", "set_a_energetic", "set_a_proud"}
