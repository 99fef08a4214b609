"""What publishing freezes, and how a version tells what it changes."""

from __future__ import annotations

import copy
from collections.abc import Callable
from contextlib import closing
from typing import Any

import pytest

from app.errors import ConflictError
from app.persistence.engine import Database
from app.persistence.models import Researcher
from app.persistence.writer import Writer
from app.schemas.studies_api import NewStudy
from app.schemas.study import StudyDefinition
from app.services import drafts, new_studies, publishing, samples, study_changes, study_stimuli
from app.services.rights import Access
from app.studies import TEMPLATES
from app.workers import Workers
from tests.app.conftest import InPlace
from tests.support.motions import walks

Change = Callable[[dict[str, Any]], object]


def definition(change: Change = lambda study: None) -> StudyDefinition:
    """The emotion template, changed."""
    study = copy.deepcopy(TEMPLATES["emotion"].build())
    for part in study["parts"]:
        for number, stimulus in enumerate(part.get("stimuli", ())):
            if not isinstance(stimulus, dict) or "name" not in stimulus:
                part["stimuli"][number] = {"clip": f"{number:064x}", "name": f"clip {number}"}
    change(study)
    return StudyDefinition.model_validate(study)


def trials(study: dict[str, Any]) -> dict[str, Any]:
    return next(part for part in study["parts"] if part["kind"] == "trials")


def told(change: Change) -> list[str]:
    return study_changes.sentences(definition(), definition(change))


def test_what_is_the_same_has_no_changes() -> None:
    assert told(lambda study: None) == []


def test_the_first_version_tells_how_much_there_is() -> None:
    first = study_changes.sentences(None, definition())
    assert first == ["The first version: 5 parts, 40 clips."]


CHANGES: dict[str, tuple[Change, str]] = {
    "title": (lambda s: s.update(title="Other"), "The title is “Other”."),
    "language": (lambda s: s.update(languages=["en", "fi"]), "Language 日本語 is gone."),
    "back": (
        lambda s: s.update(back=not s.get("back", True)),
        "Participants cannot go back and change an answer.",
    ),
    "thanks": (lambda s: s["thanks"].update(heading="Bye"), "The last page is another."),
    "part gone": (lambda s: s["parts"].pop(0), "“about_you” is gone."),
    "parts moved": (lambda s: s["parts"].reverse(), "The parts stand in another order."),
    "question": (
        lambda s: trials(s)["task"].update(question="Well?"),
        "“emotions”: the question is “Well?”.",
    ),
    "question in one language": (
        lambda s: trials(s)["task"]["question"].update(fi="Mitä näet?"),
        "“emotions”: the question in Suomi is “Mitä näet?”; in English and 日本語 it is as before.",
    ),
    "scale gone": (
        lambda s: trials(s)["task"]["scales"].pop(0),
        "“emotions”: scale sad_happy is gone.",
    ),
    "clips gone": (
        lambda s: trials(s).update(stimuli=trials(s)["stimuli"][2:]),
        "“emotions”: 2 clips gone (clip 0 and clip 1).",
    ),
    "another clip of the same name": (
        lambda s: trials(s)["stimuli"][0].update(clip="f" * 64),
        "“emotions”: clip 0 moves in another way.",
    ),
    "order": (
        lambda s: trials(s).update(order="fixed"),
        "“emotions”: the clips come in the listed order.",
    ),
    "practice": (
        lambda s: trials(s).update(practice=5),
        "“emotions”: 5 clips for practice, before 2.",
    ),
    "subset": (
        lambda s: trials(s).update(subset=10),
        "“emotions”: each participant sees 10 clips.",
    ),
    "steps": (
        lambda s: trials(s)["task"].update(steps=["a", "b", "c"]),
        "“emotions”: steps, hints or options are others.",
    ),
}


@pytest.mark.parametrize("name", CHANGES)
def test_each_change_is_told_in_a_sentence(name: str) -> None:
    change, sentence = CHANGES[name]
    assert sentence in told(change)


@pytest.mark.parametrize("template", TEMPLATES)
def test_nothing_that_changes_the_hash_goes_untold(template: str) -> None:
    """Every single value of a study, changed or taken out, is told or makes no valid study."""
    study = TEMPLATES[template].build()
    before = StudyDefinition.model_validate(study)
    changed = 0
    for path in places(study):
        other = copy.deepcopy(study)
        target: Any = other
        for step in path[:-1]:
            target = target[step]
        target[path[-1]] = altered(target[path[-1]])
        try:
            after = StudyDefinition.model_validate(other)
        except ValueError:
            continue
        if after.content_hash != before.content_hash and after.slug == before.slug:
            changed += 1
            assert study_changes.sentences(before, after), path
    assert changed > 20


def places(value: Any, path: tuple[str | int, ...] = ()) -> list[tuple[str | int, ...]]:
    """Every plain value's place; of long lists the first two entries."""
    if isinstance(value, dict):
        return [one for key, inner in value.items() for one in places(inner, (*path, key))]
    if isinstance(value, list | tuple):
        inside = enumerate(value[:2])
        return [one for index, inner in inside for one in places(inner, (*path, index))]
    return [path]


def altered(value: Any) -> Any:
    if isinstance(value, bool):
        return not value
    return value + 1 if isinstance(value, int | float) else f"{value}x"


@pytest.fixture
def workers() -> Workers:
    return InPlace()  # type: ignore[return-value]  # does what workers do, in place


@pytest.fixture
def access(database: Database) -> Access:
    """A draft of a study whose second clip is still to be made."""
    samples.make(database, walks)
    name = walks()[0].name
    made = {"source": name, "preset": "sad"}
    study = new_studies.empty("Made by hand")
    task = {"kind": "ab", "question": "Which?"}
    study["parts"] = [
        {"kind": "trials", "id": "pairs", "task": task, "stimuli": [name, {"made": made}]}
    ]
    with database.writing() as db:
        researcher = Researcher(email="rosa@example.org", name="Rosa", password_hash="")
        db.add(researcher)
        db.commit()
        return new_studies.make(db, NewStudy(definition=study), researcher.id)


def test_publishing_makes_the_clips_that_a_study_describes(
    database: Database, workers: Workers, access: Access
) -> None:
    with closing(Writer(database)) as writer, database.reading() as db:
        foreseen = publishing.changes(db, access)
        told = publishing.publish(database, writer, workers, access)
    assert told == foreseen
    with database.reading() as db:
        stored = drafts.view(db, access).definition
    assert stored is not None
    ids = [one["clip"] for one in stored["parts"][0]["stimuli"]]
    assert len(set(ids)) == 2
    assert StudyDefinition.model_validate(stored).content_hash == told.hash


def test_a_draft_that_changes_while_its_clips_are_made_is_not_published_unseen(
    database: Database, workers: Workers, access: Access, monkeypatch: pytest.MonkeyPatch
) -> None:
    def slowly(*args: Any) -> StudyDefinition:
        with database.writing() as db:
            draft = drafts.view(db, access).draft or {}
            drafts.save(db, access, {**draft, "title": "Changed meanwhile"})
        return study_stimuli.resolve(*args)

    monkeypatch.setattr(publishing, "resolve", slowly)
    with closing(Writer(database)) as writer, pytest.raises(ConflictError) as refused:
        publishing.publish(database, writer, workers, access)
    assert refused.value.code == "draft_changed"
    with database.reading() as db:
        assert drafts.view(db, access).versions == []
