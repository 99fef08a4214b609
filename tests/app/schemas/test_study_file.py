import pytest
from pydantic import ValidationError

from app.schemas.study import Stimulus, StudyDefinition
from app.studies.emotion import demonstration


@pytest.fixture
def stimuli():
    return [
        Stimulus(clip=f"{i:064x}", name=f"clip {i}", label=f"label {i}", body="female", style="sad")
        for i in range(4)
    ]


def test_the_demonstration_asks_what_the_thesis_asked(stimuli):
    study = demonstration(stimuli)
    assert [(scale.left, scale.right) for scale in study.scales] == [
        ("sad", "happy"), ("tired", "excited"), ("angry", "relaxed"), ("weak", "strong"),
        ("afraid", "confident"), ("masculine", "feminine"),
    ]  # fmt: skip
    assert study.steps == ("very", "rather", "neither", "rather", "very")
    assert (study.reach, study.practice, study.trials) == (2, 2, 6)
    terms = [term.term for term in study.consent.terms]
    assert terms == ["What is kept", "How long", "Your right", "Who asks"]


def test_a_definition_survives_being_stored(stimuli):
    study = demonstration(stimuli, example="a" * 64)
    again = StudyDefinition.model_validate(study.model_dump(mode="json"))
    assert again == study
    assert again.content_hash == study.content_hash


def test_whatever_is_changed_changes_the_hash(stimuli):
    study = demonstration(stimuli)
    others = [
        study.model_copy(update={"question": "And how does this one seem?"}),
        study.model_copy(update={"stimuli": study.stimuli[::-1]}),
        study.model_copy(update={"practice": 1}),
    ]
    assert len({one.content_hash for one in (study, *others)}) == 4


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"steps": ["a", "b", "c", "d"]}, "odd number"),
        ({"practice": 5}, "more clips than the study has"),
        ({"colour": "plum"}, "Extra inputs"),
        ({"slug": "Not A Slug"}, "pattern"),
        ({"stimuli": []}, "at least 1"),
        ({"contact": "nobody"}, "pattern"),
        ({"title": "t" * 201}, "at most 200"),
    ],
)
def test_a_study_file_that_makes_no_sense_is_refused_with_the_reason(stimuli, change, told):
    with pytest.raises(ValidationError, match=told):
        StudyDefinition.model_validate(demonstration(stimuli).model_dump() | change)


def test_a_consent_version_that_no_session_could_store_is_refused(stimuli):
    file = demonstration(stimuli).model_dump()
    file["consent"]["version"] = "v" * 65
    with pytest.raises(ValidationError, match="at most 64"):
        StudyDefinition.model_validate(file)


def test_a_clip_or_a_scale_listed_twice_is_refused(stimuli):
    file = demonstration(stimuli).model_dump()
    for part in ("stimuli", "scales"):
        with pytest.raises(ValidationError, match=part):
            StudyDefinition.model_validate(file | {part: [*file[part], file[part][0]]})
