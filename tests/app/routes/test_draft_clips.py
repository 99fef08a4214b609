"""Clips put into studies from where they are made: which parts take them, and what is refused."""

from __future__ import annotations

import pytest

from app.persistence.engine import Database
from app.services import samples
from app.studies import TEMPLATES
from tests.app.conftest import Researching
from tests.app.routes.test_studies_api import STUDIES, likert, made
from tests.support.motions import walks


@pytest.fixture
def ids(database: Database, signed_in: Researching) -> list[str]:
    """The ids of the three clips of a small library."""
    samples.make(database, walks)
    listed = signed_in.get("/api/v1/clips").json()["clips"]
    by_name = {clip["name"]: clip["id"] for clip in listed}
    return [by_name[clip.name] for clip in walks()]


NAMES = [clip.name for clip in walks()]


def add(signed_in: Researching, clips: list[str], slug: str = "gaits", **more: object):
    return signed_in.post(f"{STUDIES}/{slug}/draft/clips", json={"clips": clips, **more})


def stimuli(signed_in: Researching, slug: str = "gaits") -> list:
    draft = signed_in.get(f"{STUDIES}/{slug}").json()["draft"]
    return next(part["stimuli"] for part in draft["parts"] if is_asking(part))


def is_asking(part: object) -> bool:
    return isinstance(part, dict) and part["kind"] == "trials"


def test_a_clip_is_added_once_however_the_study_calls_it(
    signed_in: Researching, ids: list[str]
) -> None:
    made(signed_in, likert(NAMES[:1]))
    answer = add(signed_in, [ids[1], ids[0], ids[1]])
    assert answer.status_code == 200, answer.text
    told = answer.json()
    assert (told["title"], told["part"]) == ("Gaits", "gait")
    assert (told["added"], told["already"]) == ([ids[1]], [ids[0]])
    assert told["draft"]["problems"] == []
    assert stimuli(signed_in) == [NAMES[0], {"clip": ids[1]}]

    again = add(signed_in, ids[:2])
    assert again.status_code == 409
    assert again.json()["error"]["message"] == "All 2 clips are in “Gaits” already."
    now = signed_in.get(f"{STUDIES}/gaits").json()["saved_at"]
    assert now == told["draft"]["saved_at"], "what changes nothing is no change"


def test_who_edits_meanwhile_hears_of_it_and_writes_over_nothing(
    signed_in: Researching, ids: list[str]
) -> None:
    study = made(signed_in, likert(NAMES[:1]))
    mine = {"seen": study["saved_at"]}
    assert add(signed_in, ids[1:2]).status_code == 200
    address = f"{STUDIES}/gaits/draft"
    late = signed_in.put(address, params=mine, json=likert(NAMES[:1], title="Mine"))
    assert (late.status_code, late.json()["error"]["code"]) == (409, "draft_changed")
    body = {"clips": ids[2:]}
    assert signed_in.post(f"{address}/clips", params=mine, json=body).status_code == 409
    assert stimuli(signed_in) == [NAMES[0], {"clip": ids[1]}]


def test_the_part_that_is_named_gets_the_clip_and_no_other(
    signed_in: Researching, ids: list[str]
) -> None:
    study = likert(NAMES[:1])
    second = {**study["parts"][0], "id": "again"}
    page = {"kind": "break", "id": "rest", "heading": "Rest", "text": "Rest."}
    made(signed_in, {**study, "parts": [study["parts"][0], page, second]})
    listed = signed_in.get("/api/v1/study-drafts").json()["drafts"]
    (line,) = [one for one in listed if one["slug"] == "gaits"]
    assert (line["title"], line["languages"], line["version"]) == ("Gaits", ["en"], None)
    assert line["parts"] == [
        {"id": "gait", "task": "likert", "clips": 1},
        {"id": "again", "task": "likert", "clips": 1},
    ]
    assert add(signed_in, ids[2:], part="again").json()["part"] == "again"
    parts = signed_in.get(f"{STUDIES}/gaits").json()["draft"]["parts"]
    assert [len(part.get("stimuli", [])) for part in parts] == [1, 0, 2]
    refused = add(signed_in, ids[1:2], part="rest")
    assert (refused.status_code, refused.json()["error"]["code"]) == (404, "part_not_found")


def test_what_participants_see_changes_only_when_it_is_published(
    signed_in: Researching, ids: list[str]
) -> None:
    made(signed_in, likert(NAMES[:1]))
    signed_in.post(f"{STUDIES}/gaits/publish")
    before = signed_in.get(f"{STUDIES}/gaits").json()
    assert before["draft"] is None
    assert add(signed_in, ids[1:]).status_code == 200
    after = signed_in.get(f"{STUDIES}/gaits").json()
    assert after["definition"] == before["definition"]
    assert [one["clip"] for one in after["draft"]["parts"][0]["stimuli"]] == ids


def test_an_empty_study_gets_a_question_that_can_be_asked_at_once(
    signed_in: Researching, ids: list[str]
) -> None:
    answer = signed_in.post(STUDIES, json={"title": "Fresh", "clips": ids[:1]})
    assert answer.status_code == 201, answer.text
    study = answer.json()
    assert study["problems"] == []
    assert [part["id"] for part in study["draft"]["parts"]] == ["clips"]
    assert stimuli(signed_in, "fresh") == [{"clip": ids[0]}]
    signed_in.post(STUDIES, json={"title": "Bare"})
    assert add(signed_in, ids[:2], slug="bare").json()["part"] == "clips"
    assert signed_in.post(f"{STUDIES}/bare/publish").status_code == 200


@pytest.mark.parametrize("template", TEMPLATES)
def test_a_template_asks_its_questions_about_the_clips_that_are_given(
    signed_in: Researching, ids: list[str], template: str
) -> None:
    wanted = {"template": template, "title": "Mine", "clips": ids[:2]}
    study = signed_in.post(STUDIES, json=wanted).json()
    assert stimuli(signed_in, "mine") == [{"clip": one} for one in ids[:2]]
    (part,) = [one for one in study["draft"]["parts"] if one["kind"] == "trials"]
    asked = next(one for one in TEMPLATES[template].build()["parts"] if one["kind"] == "trials")
    assert part["task"] == asked["task"]
    told = [one["where"] for one in study["problems"]]
    assert not [where for where in told if "stimuli" in where or "sets" in where or len(where) < 3]


def test_clips_that_cannot_be_shown_are_refused_and_nothing_is_made(
    signed_in: Researching, ids: list[str]
) -> None:
    made(signed_in, likert(NAMES[:1]))
    for refused in (
        add(signed_in, [ids[1], "0" * 64]),
        signed_in.post(STUDIES, json={"title": "Other", "clips": ["0" * 64]}),
    ):
        assert (refused.status_code, refused.json()["error"]["code"]) == (404, "clip_not_found")
    assert stimuli(signed_in) == NAMES[:1]
    assert signed_in.get(f"{STUDIES}/other").status_code == 404


def test_a_draft_full_of_nonsense_is_listed_and_takes_clips(
    signed_in: Researching, ids: list[str]
) -> None:
    signed_in.post(STUDIES, json={"title": "Odd"})
    odd = {"title": 3, "languages": "en", "parts": ["x", {"kind": "trials", "stimuli": [1, {}]}]}
    signed_in.put(f"{STUDIES}/odd/draft", json=odd)
    listed = signed_in.get("/api/v1/study-drafts").json()["drafts"]
    (line,) = [one for one in listed if one["slug"] == "odd"]
    assert (line["title"], line["languages"]) == ("Odd", [])
    assert line["parts"] == [{"id": "", "task": "", "clips": 2}]
    assert add(signed_in, ids[:1], slug="odd").status_code == 200
    assert stimuli(signed_in, "odd") == [1, {}, {"clip": ids[0]}]
