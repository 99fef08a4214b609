"""The templates: each a whole study in three languages, with what its paper asks."""

from __future__ import annotations

import hashlib
import re
from functools import cache

import numpy as np
import pytest
from sqlalchemy.orm import Session

from app.errors import InvalidError
from app.persistence import blobs
from app.persistence.models import ClipRecord, SpaceRecord
from app.schemas.spaces import SpaceDefinition
from app.schemas.study import LANGUAGES, OF_ONE, StudyDefinition, Words
from app.services import study_files, study_stimuli
from app.services.plans import draw_plan
from app.studies import TEMPLATES, adjectives, matching
from app.studies.emotion import ACTED, MODIFIED
from motion.procedural.library import sample_clips
from motion.procedural.styles import ACTED as ACTED_STYLES
from motion.recipe import PRESETS

EXPECTED = {
    "emotion": ("semantic_differential", 40),
    "adjectives-a": ("semantic_differential", 10),
    "adjectives-b": ("semantic_differential", 27),
    "adjectives-short": ("semantic_differential", 10),
    "most-natural": ("choose", 10),
    "more-natural": ("ab", 5),
    "side-by-side": ("parallel", 18),
    "matching": ("match", 5),
}
each = pytest.mark.parametrize("name", TEMPLATES)


@cache
def samples() -> tuple[tuple[str, dict[str, str]], ...]:
    return tuple((sample.name, sample.tags) for sample in sample_clips())


@pytest.fixture
def library(db: Session) -> Session:
    """The sample library by name and tags, with nothing to see."""
    blob = blobs.put(db, b"nothing", blobs.GLB)
    for name, tags in samples():
        db.add(
            ClipRecord(
                id=hashlib.sha256(name.encode()).hexdigest(), name=name,
                source="sample", state="kept", skeleton_hash="0" * 64, frames=2, frame_time=0.04,
                duration=0.04, cyclic=True, stature=1.7, poster_time=0.0, tags=tags,
                clip_blob=blob, glb_blob=blob, content_hash="0" * 64, engine_version="0",
            )
        )  # fmt: skip
    db.flush()
    db.add(_space())
    db.flush()
    return db


def _space() -> SpaceRecord:
    """The space in which the template's targets are made, its walks anywhere."""
    walks = [name for name, tags in samples() if tags["set"] == "B"]
    places = np.random.default_rng(1).random((len(matching.PRIMARY), len(walks))).round(3)
    space = SpaceDefinition.model_validate(
        {
            "title": matching.SPACE,
            "examples": [
                {"clip": hashlib.sha256(name.encode()).hexdigest(), "name": name} for name in walks
            ],
            "adjectives": {
                "parameters": [
                    {"id": f"pair_{name}", "left": "less", "right": "more", "values": row.tolist()}
                    for name, row in zip(matching.PRIMARY, places, strict=True)
                ],
                "primary": [
                    {"id": name, "title": name, "members": [f"pair_{name}"], "values": row.tolist()}
                    for name, row in zip(matching.PRIMARY, places, strict=True)
                ],
            },
            "features": {"parameters": [], "primary": []},
        }
    )
    return SpaceRecord(
        id=space.content_hash, name=space.title, number=1,
        definition=space.model_dump(mode="json"),
    )  # fmt: skip


def definition(name: str, **options: str) -> StudyDefinition:
    found, _, problems = study_files.examine(TEMPLATES[name].build(**options))
    assert problems == []
    assert found is not None
    return found


def trials(name: str):
    (part,) = definition(name).trials
    return part


@each
def test_a_template_is_a_whole_study_without_faults(name: str) -> None:
    study = definition(name)
    assert (trials(name).task.kind, len(trials(name).stimuli)) == EXPECTED[name]
    kinds = [part.kind for part in study.parts]
    assert kinds == ["form", "instructions", "trials", "comment", "debriefing"]
    assert study.parts[1].figures
    assert study.welcome.example
    # Else trials are counted, not clips; and a target is made again, not judged.
    judged_alone = trials(name).task.kind in OF_ONE and name != "matching"
    assert ("{clips}" in str(study.thanks.text)) == judged_alone


@pytest.mark.parametrize("name", [name for name in TEMPLATES if name != "most-natural"])
def test_the_welcome_tells_how_many_trials_there_will_be(name: str, library: Session) -> None:
    study = study_stimuli.resolve(library, definition(name), list)
    plan = draw_plan(study, 1, 0, study.content_hash)
    trials = [step for step in plan["steps"] if "clips" in step]
    for text in study.welcome.facts[0].root.values():
        assert str(len(trials)) in re.findall(r"\d+", text)


@each
def test_a_template_is_the_same_at_every_call_and_as_a_file(name: str) -> None:
    first, again = TEMPLATES[name].build(), TEMPLATES[name].build()
    assert first == again
    read = study_files.read(study_files.write(first), "study.yaml")
    assert read.definition == definition(name)


@each
def test_every_text_of_a_template_stands_in_three_languages(name: str) -> None:
    study = definition(name)
    assert study.languages == LANGUAGES

    def words(node: object) -> list[Words]:
        if isinstance(node, Words):
            return [node]
        if isinstance(node, tuple):
            return [one for inside in node for one in words(inside)]
        fields = type(node).model_fields if hasattr(type(node), "model_fields") else ()
        return [one for field in fields for one in words(getattr(node, field))]

    found = words(study)
    assert len(found) > 30
    assert [one for one in found if isinstance(one.root, str)] == []
    for one in found:
        japanese = one.root["ja"]
        assert any(
            "\u3040" <= sign <= "\u30ff" or "\u4e00" <= sign <= "\u9fff" for sign in japanese
        )
        assert not any("\u3040" <= sign <= "\u9fff" for sign in one.root["fi"] + one.root["en"])


@each
def test_a_template_runs_on_the_sample_library(name: str, library: Session) -> None:
    wanted = []
    published = study_stimuli.resolve(library, definition(name), wanted.extend)
    shown = [stimulus.clip for part in published.trials for stimulus in part.stimuli]
    assert len(set(shown)) == len(shown) == EXPECTED[name][1]
    assert all(len(clip) == 64 for clip in shown)
    made = {"emotion": 20, "most-natural": 10, "more-natural": 5, "matching": 8}
    assert len(wanted) == made.get(name, 0)
    names = [stimulus.name for part in published.trials for stimulus in part.stimuli]
    labels = [str(stimulus.label) for part in published.trials for stimulus in part.stimuli]
    assert len(set(names)) == len(set(labels)) == len(shown)
    plan = draw_plan(published, 1, 0, published.content_hash)
    assert [step["part"] for step in plan["steps"]][:2] == ["about_you", "how_it_works"]


def test_foergers_questionnaire_has_his_forty_clips_on_his_six_axes(library: Session) -> None:
    part = trials("emotion")
    assert [scale.id for scale in part.task.scales] == [
        "sad_happy", "tired_excited", "angry_relaxed",
        "weak_strong", "afraid_confident", "masculine_feminine",
    ]  # fmt: skip
    assert (part.task.preselected, part.task.reach, part.practice) == (True, 2, 2)
    acted = [one.clip for one in part.stimuli if one.clip]
    assert acted == [f"acted_{body}_{style}" for body in ("female", "male") for style in ACTED]
    assert set(ACTED) == set(ACTED_STYLES)
    made = [(one.made.source, one.made.preset) for one in part.stimuli if one.made]
    assert made == [
        (f"acted_{body}_neutral", preset) for body, names in MODIFIED.items() for preset in names
    ]
    assert {preset for _, preset in made} <= set(PRESETS)
    stimuli = study_stimuli.resolve(library, definition("emotion"), list).trials[0].stimuli
    modified = [str(one.label) for one in stimuli if one.made]
    assert modified[0] == "afraid, female, modified"
    assert modified[12] == "energetic sadness, male, modified"
    assert all(label.endswith(", modified") for label in modified)


def test_oshitas_questionnaire_has_his_41_pairs_beside_the_neutral_walk() -> None:
    for name in ("adjectives-a", "adjectives-b"):
        part = trials(name)
        assert len(part.task.scales) == 41
        assert len({scale.id for scale in part.task.scales}) == 41
        assert (part.task.preselected, part.task.reach) == (False, 2)
        assert part.task.reference == "set_a_neutral"
    english = [(str(scale.left), str(scale.right)) for scale in trials("adjectives-a").task.scales]
    assert english[:4] == [
        ("slow", "fast"), ("mild", "violent"), ("hard", "soft"), ("dull", "quick"),
    ]  # fmt: skip
    assert english[-1] == ("narrow", "wide")


def test_the_adjective_pairs_differ_from_each_other_in_every_language() -> None:
    for place in (0, 2, 4):
        pairs = [words[place : place + 2] for words in adjectives.PAIRS]
        assert len(set(pairs)) == 41
        assert all(left != right for left, right in pairs)


def test_the_short_form_asks_for_the_four_primary_parameters_alone() -> None:
    part = trials("adjectives-short")
    names = [scale.id for scale in part.task.scales]
    assert names == ["quickness", "clearness", "activeness", "largeness"]
    assert part.task.reference == "set_a_neutral"
    assert part.stimuli == trials("adjectives-a").stimuli


def test_the_levels_of_any_parameter_can_be_chosen_among() -> None:
    options = {
        "source": "set_a_proud", "operation": "tempo@1", "parameter": "factor",
        "from": "0.5", "to": "1.4",
    }  # fmt: skip
    (part,) = definition("most-natural", **options).trials
    levels = [one.made.operations[0]["parameters"]["factor"] for one in part.stimuli]
    assert levels == pytest.approx([0.5 + 0.1 * step for step in range(10)])
    assert {one.made.source for one in part.stimuli} == {"set_a_proud"}
    usual = [one.name for one in trials("most-natural").stimuli]
    assert "gain 1" in usual


@pytest.mark.parametrize(
    ("name", "options", "told"),
    [
        ("most-natural", {"from": "low"}, "“low” is no number"),
        ("most-natural", {"to": "inf"}, "“inf” is no number"),
        ("most-natural", {"form": "1"}, "no option “form”"),
        ("emotion", {"source": "x"}, "no option “source”"),
    ],
)
def test_an_option_that_makes_no_sense_is_refused(name, options, told) -> None:
    with pytest.raises(InvalidError, match=told) as error:
        TEMPLATES[name].build(**options)
    assert error.value.mend


def test_two_of_five_levels_meet_each_other_once_and_one_pair_comes_again(
    library: Session,
) -> None:
    study = study_stimuli.resolve(library, definition("more-natural"), list)
    plan = draw_plan(study, 7, 0, study.content_hash)
    shown = [frozenset(step["clips"]) for step in plan["steps"] if "clips" in step]
    assert (len(shown), len(set(shown))) == (11, 10)
