"""The study file's model: what is the same has the same hash, every text has its language."""

from __future__ import annotations

import copy
import json

import pytest
from pydantic import ValidationError

from app.schemas.study import LANGUAGES, Running, Stimulus, StudyDefinition, Words
from app.studies import TEMPLATES
from app.studies.emotion import demonstration


@pytest.fixture
def stimuli() -> list[Stimulus]:
    return [
        Stimulus.model_validate(
            {"clip": f"{i:064x}", "name": f"clip {i}", "label": "l", "body": "female", "style": "s"}
        )
        for i in range(4)
    ]


@pytest.fixture
def document(stimuli) -> dict:
    return demonstration(stimuli, example="a" * 64).model_dump(mode="json")


def test_the_demonstration_asks_what_the_thesis_asked(stimuli) -> None:
    study = demonstration(stimuli)
    (part,) = study.trials
    assert [(str(scale.left), str(scale.right)) for scale in part.task.scales] == [
        ("sad", "happy"), ("tired", "excited"), ("angry", "relaxed"), ("weak", "strong"),
        ("afraid", "confident"), ("masculine", "feminine"),
    ]  # fmt: skip
    steps = [str(step) for step in part.task.steps]
    assert steps == ["very", "rather", "neither", "rather", "very"]
    assert (part.task.reach, part.practice, len(part.stimuli)) == (2, 2, 4)
    terms = [str(term.term) for term in study.consent.terms]
    assert terms == ["What is kept", "How long", "Your right", "Who asks"]


@pytest.mark.parametrize("name", TEMPLATES)
def test_a_definition_survives_being_stored(name: str) -> None:
    study = StudyDefinition.model_validate(TEMPLATES[name].build())
    stored = json.loads(json.dumps(study.model_dump(mode="json"), sort_keys=True))
    again = StudyDefinition.model_validate(stored)
    assert again.content_hash == study.content_hash
    assert again.parts == study.parts


def test_whatever_is_changed_changes_the_hash(document) -> None:
    changes = (
        ("parts", 0, "task", "question", "fi"), ("parts", 0, "stimuli", 2, "label"),
        ("parts", 0, "task", "scales", 3, "right_more", "ja"), ("consent", "statement", "en"),
        ("title",), ("welcome", "facts", 1, "en"),
    )  # fmt: skip
    hashes = {StudyDefinition.model_validate(document).content_hash}
    for path in changes:
        changed = copy.deepcopy(document)
        node = changed
        for step in path[:-1]:
            node = node[step]
        node[path[-1]] = "another"
        hashes.add(StudyDefinition.model_validate(changed).content_hash)
    turned = copy.deepcopy(document)
    turned["parts"][0]["stimuli"].reverse()
    hashes.add(StudyDefinition.model_validate(turned).content_hash)
    assert len(hashes) == len(changes) + 2


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_study_in_one_language_has_every_text_in_it(language) -> None:
    study = StudyDefinition.model_validate(TEMPLATES["emotion"].build())
    told = study.into(language)
    question = study.trials[0].task.question.root
    assert told.trials[0].task.question.root == question[language]
    assert f'"{language}":' not in told.model_dump_json()
    assert told.into("en") == told
    assert [part.id for part in told.parts] == [part.id for part in study.parts]


def test_a_text_that_is_missing_in_a_language_is_shown_in_the_first() -> None:
    words = Words({"en": "walk", "fi": "kävely"})
    assert str(words.into("ja")) == "walk"
    assert words.missing(LANGUAGES) == ["ja"]
    assert Words("walk").missing(LANGUAGES) == []


def test_a_clip_by_its_name_alone_is_a_stimulus() -> None:
    assert Stimulus.model_validate("walk") == Stimulus(clip="walk")


@pytest.mark.parametrize(
    ("path", "value", "told"),
    [
        (("parts", 0, "task", "steps"), ["a", "b", "c", "d"], "odd number"),
        (("parts", 0, "practice"), 5, "more clips than the part has"),
        (("parts", 0, "subset"), 5, "more clips than the part has"),
        (("parts", 0, "sets"), [["clip 0", "clip 1"]], "one figure at a time"),
        (("parts", 0, "stimuli"), [], "at least 1"),
        (("parts", 0, "stimuli", 0), {"name": "x"}, "give clip"),
        (("parts", 0, "groups"), ["dancers"], "no group"),
        (("blocks",), [["emotions", "tunes"]], "no part “tunes”"),
        (("languages",), ["en", "en"], "twice"),
        (("languages",), [], "at least 1"),
        (("colour",), "plum", "Extra inputs"),
        (("slug",), "Not A Slug", "pattern"),
        (("contact",), "nobody", "pattern"),
        (("title",), "t" * 201, "at most 200"),
        (("consent", "version"), "v" * 65, "at most 64"),
        (("thanks", "text"), {"sv": "tack"}, "'en', 'fi' or 'ja'"),
    ],
)
def test_a_study_file_that_makes_no_sense_is_refused_with_the_reason(
    document, path, value, told
) -> None:
    node = document
    for step in path[:-1]:
        node = node[step]
    node[path[-1]] = value
    with pytest.raises(ValidationError, match=told):
        StudyDefinition.model_validate(document)


def test_more_pairs_than_a_plan_can_list_are_refused_and_a_choice_of_them_is_not(document) -> None:
    part = document["parts"][0]
    part["stimuli"] = [{"clip": f"clip {number}"} for number in range(142)]
    part["task"] = {"kind": "ab", "question": "Which?"}
    with pytest.raises(ValidationError, match="10,011 pairs; list in sets"):
        StudyDefinition.model_validate(document)
    part["sets"] = [["clip 0", "clip 1"]]
    assert StudyDefinition.model_validate(document).trials[0].sets == (("clip 0", "clip 1"),)


def test_a_part_that_is_there_twice_is_refused(document) -> None:
    document["parts"] *= 2
    with pytest.raises(ValidationError, match="“emotions” is there twice"):
        StudyDefinition.model_validate(document)


def test_a_study_that_closes_before_it_opens_is_refused() -> None:
    times = {"opens_at": "2027-02-01T00:00:00Z", "closes_at": "2027-01-01T00:00:00Z"}
    with pytest.raises(ValidationError, match="closes before it opens"):
        Running.model_validate(times)


@pytest.mark.parametrize(
    ("task", "steps_between"),
    [
        ({"kind": "likert", "items": [{"id": "a", "label": "A"}], "steps": list("12345")}, 4),
        ({"kind": "analogue", "scales": [{"id": "a", "left": "l", "right": "r"}]}, 100),
        ({"kind": "parallel", "low": "l", "high": "r"}, 100),
    ],
    ids=lambda one: one.get("kind") if isinstance(one, dict) else "",
)
def test_a_repeated_check_is_as_strict_on_sliders_as_on_steps(
    document, task: dict, steps_between: int
) -> None:
    part = document["parts"][0]
    part["task"] = {"question": "How?", **task}
    part["checks"] = [{"kind": "repeated", "id": "again"}]
    study = StudyDefinition.model_validate(document)
    (check,) = study.trials[0].checks
    ends = range(steps_between + 1)
    guessed = sum(abs(one - other) for one in ends for other in ends) / len(ends) ** 2
    assert check.within / guessed == pytest.approx(0.6, abs=0.03)
    part["checks"][0]["within"] = 1
    (told,) = StudyDefinition.model_validate(document).trials[0].checks
    assert told.within == 1
    stored = study.model_dump(mode="json")["parts"][0]["checks"][0]
    assert stored["within"] == check.within, "a version says it, whatever the default becomes"
