"""Studies over the API: made, saved, published, opened, copied, deleted, and by whom."""

from __future__ import annotations

import json

import pytest
import yaml
from sqlalchemy import select
from starlette.testclient import TestClient

from app.persistence.engine import Database
from app.persistence.models import Researcher, Study, StudySession
from app.services import keys, samples
from app.studies import TEMPLATES
from tests.app.conftest import Researching
from tests.support.motions import walks

STUDIES = "/api/v1/studies"


@pytest.fixture(autouse=True)
def library(database: Database) -> list[str]:
    """The names of the three clips of a small library."""
    samples.make(database, walks)
    return [clip.name for clip in walks()]


def likert(clips: list[str], **more: object) -> dict:
    """A study of one part, as a person would write it."""
    text = {"heading": "A heading", "text": "A text"}
    task = {
        "kind": "likert",
        "question": "How far do you agree?",
        "items": [{"id": "natural", "label": "It moves naturally."}],
        "steps": ["no", "hardly", "yes"],
    }
    return {
        "manner": 1,
        "slug": "gaits",
        "title": "Gaits",
        "languages": ["en"],
        "welcome": {"heading": "Welcome", "lead": "Look.", "facts": ["One", "Two", "Three"]},
        "consent": {
            "version": "1",
            "heading": "Before you begin",
            "terms": [{"term": "Kept", "text": "Answers."}],
            "statement": "I agree.",
        },
        "parts": [{"kind": "trials", "id": "gait", "task": task, "stimuli": clips}],
        "thanks": text,
        **more,
    }


def made(signed_in: Researching, definition: dict) -> dict:
    answer = signed_in.post(STUDIES, json={"definition": definition})
    assert answer.status_code == 201, answer.text
    return answer.json()


def published(signed_in: Researching, definition: dict) -> dict:
    study = made(signed_in, definition)
    answer = signed_in.post(f"{STUDIES}/{study['slug']}/publish")
    assert answer.status_code == 200, answer.text
    return signed_in.get(f"{STUDIES}/{study['slug']}").json()


def test_a_study_begins_as_a_draft_of_its_maker(signed_in: Researching, library: list[str]) -> None:
    study = made(signed_in, likert(library))
    assert (study["slug"], study["state"], study["role"]) == ("gaits", "draft", "owner")
    assert study["problems"] == []
    assert study["versions"] == []
    assert signed_in.get("/studies/gaits").status_code == 404
    listed = signed_in.get(STUDIES).json()["studies"]
    line = next(one for one in listed if one["slug"] == "gaits")
    assert (line["version"], line["draft"]) == (None, True)


def test_two_studies_of_one_name_get_two_addresses(
    signed_in: Researching, library: list[str]
) -> None:
    slugs = [made(signed_in, likert(library))["slug"] for _ in range(3)]
    assert slugs == ["gaits", "gaits-2", "gaits-3"]
    again = signed_in.get(f"{STUDIES}/gaits-3").json()
    assert again["draft"]["slug"] == "gaits-3"
    assert again["problems"] == []


def test_an_address_is_made_from_any_title(signed_in: Researching) -> None:
    for title, slug in (
        ("Kävely & tunne", "kavely-tunne"),
        ("歩行", "study"),
        ("  ?  ", "study-2"),
    ):
        answer = signed_in.post(STUDIES, json={"title": title})
        assert answer.json()["slug"] == slug


def test_whatever_is_unfinished_is_kept_with_its_problems(signed_in: Researching) -> None:
    slug = signed_in.post(STUDIES, json={"title": "New"}).json()["slug"]
    draft = {"title": "", "parts": [{"kind": "likert"}], "of": ["anything", None, 1.5]}
    saved = signed_in.put(f"{STUDIES}/{slug}/draft", json=draft).json()
    places = [problem["where"] for problem in saved["problems"]]
    assert ["title"] in places
    assert ["parts", 0, "kind"] in places
    assert ["of"] in places
    assert all(problem["message"] for problem in saved["problems"])
    assert signed_in.get(f"{STUDIES}/{slug}").json()["draft"] == draft
    refused = signed_in.post(f"{STUDIES}/{slug}/publish")
    assert refused.status_code == 422
    assert refused.json()["error"]["where"]["problems"] == saved["problems"]
    assert signed_in.get(f"{STUDIES}/{slug}/preview").status_code == 422


@pytest.mark.parametrize("edited_before", [True, False])
def test_a_draft_saved_elsewhere_meanwhile_is_not_written_over(
    signed_in: Researching, library: list[str], database: Database, edited_before: bool
) -> None:
    made(signed_in, likert(library))
    if not edited_before:  # as the demonstration is made
        with database.writing() as db:
            db.scalars(select(Study).where(Study.slug == "gaits")).one().draft_saved_at = None
            db.commit()
    study = signed_in.get(f"{STUDIES}/gaits").json()
    address = f"{STUDIES}/gaits/draft"
    mine = {"seen": study["saved_at"]}
    first = signed_in.put(address, params=mine, json=likert(library, title="First"))
    second = signed_in.put(address, params=mine, json=likert(library, title="Second"))
    assert (first.status_code, second.status_code) == (200, 409)
    assert second.json()["error"]["code"] == "draft_changed"
    assert signed_in.get(f"{STUDIES}/gaits").json()["draft"]["title"] == "First"
    onward = {"seen": first.json()["saved_at"]}
    assert signed_in.put(address, params=onward, json=likert(library)).status_code == 200


def test_text_that_no_database_holds_is_refused_with_its_place(
    signed_in: Researching, library: list[str]
) -> None:
    made(signed_in, likert(library))
    for bad in ("a\x00b", "half \ud800"):
        body = json.dumps(likert(library, title=bad))
        answer = signed_in.client.put(
            f"{STUDIES}/gaits/draft",
            content=body,
            headers={**signed_in.headers, "Content-Type": "application/json"},
        )
        assert answer.status_code == 422
        assert answer.json()["error"]["where"] == {"path": ["title"]}


@pytest.mark.parametrize("levels", [31, 500, 900, 100_000])
def test_a_draft_deeper_than_anything_can_follow_is_refused(
    signed_in: Researching, library: list[str], levels: int
) -> None:
    made(signed_in, likert(library))
    answer = signed_in.client.put(
        f"{STUDIES}/gaits/draft",
        content=f'{{"parts":{"[" * levels}{"]" * levels}}}',
        headers={**signed_in.headers, "Content-Type": "application/json"},
    )
    assert answer.status_code in (400, 422)
    assert "parts" in signed_in.get(f"{STUDIES}/gaits").json()["draft"]


@pytest.mark.parametrize("body", ['{"template": "\\ud800"}', '{"title": "\\ud800"}'])
def test_half_a_character_makes_no_study_and_no_fault_of_ours(
    signed_in: Researching, body: str
) -> None:
    headers = {**signed_in.headers, "Content-Type": "application/json"}
    assert signed_in.client.post(STUDIES, content=body, headers=headers).status_code == 422


def test_publishing_freezes_the_clips_and_opens_the_study(
    signed_in: Researching, library: list[str]
) -> None:
    study = published(signed_in, likert(library))
    assert (study["state"], study["draft"]) == ("open", None)
    (version,) = study["versions"]
    assert version["number"] == 1
    stimuli = study["definition"]["parts"][0]["stimuli"]
    assert [one["name"] for one in stimuli] == library
    assert all(len(one["clip"]) == 64 for one in stimuli)
    assert signed_in.get("/studies/gaits").status_code == 200


def test_publishing_what_is_unchanged_makes_no_version(
    signed_in: Researching, library: list[str]
) -> None:
    published(signed_in, likert(library))
    signed_in.put(f"{STUDIES}/gaits/draft", json=likert(library))  # names instead of ids
    looked = signed_in.get(f"{STUDIES}/gaits/changes").json()
    again = signed_in.post(f"{STUDIES}/gaits/publish").json()
    assert looked == again
    assert (again["same"], again["number"], again["changes"]) == (True, 1, [])
    assert len(signed_in.get(f"{STUDIES}/gaits").json()["versions"]) == 1


def test_a_change_makes_a_version_that_says_what_it_changes(
    signed_in: Researching, library: list[str]
) -> None:
    published(signed_in, likert(library))
    other = likert(library[:2], title="Other gaits")
    other["parts"][0]["task"]["question"] = "Do you agree?"
    signed_in.put(f"{STUDIES}/gaits/draft", json=other)
    looked = signed_in.get(f"{STUDIES}/gaits/changes").json()
    assert signed_in.get(f"{STUDIES}/gaits").json()["versions"][0]["number"] == 1
    told = signed_in.post(f"{STUDIES}/gaits/publish").json()
    assert told == looked
    assert told["changes"] == [
        "The title is “Other gaits”.",
        f"“gait”: 1 clip gone ({library[2]}).",
        "“gait”: the question is “Do you agree?”.",
    ]
    study = signed_in.get(f"{STUDIES}/gaits").json()
    newest = study["versions"][0]
    assert (newest["number"], newest["hash"]) == (2, told["hash"])
    assert study["title"] == "Other gaits"


def test_another_consent_needs_another_version_of_it(
    signed_in: Researching, library: list[str]
) -> None:
    published(signed_in, likert(library))
    other = likert(library)
    other["consent"] = {**other["consent"], "statement": "I agree to more."}
    saved = signed_in.put(f"{STUDIES}/gaits/draft", json=other).json()
    assert [problem["where"] for problem in saved["problems"]] == [["consent", "version"]]
    assert signed_in.post(f"{STUDIES}/gaits/publish").status_code == 422
    other["consent"]["version"] = "2"
    assert signed_in.put(f"{STUDIES}/gaits/draft", json=other).json()["problems"] == []
    told = signed_in.post(f"{STUDIES}/gaits/publish").json()
    assert told["changes"] == ["The consent is version 2, before 1."]


def test_a_clip_that_is_not_there_is_told_at_its_place(
    signed_in: Researching, library: list[str]
) -> None:
    study = made(signed_in, likert([*library, "nobody_walks"]))
    (problem,) = study["problems"]
    assert problem["where"] == ["parts", 0, "stimuli", 3, "clip"]
    assert "nobody_walks" in problem["message"]


def test_an_address_stays(signed_in: Researching, library: list[str]) -> None:
    made(signed_in, likert(library))
    saved = signed_in.put(f"{STUDIES}/gaits/draft", json=likert(library, slug="others")).json()
    assert [problem["where"] for problem in saved["problems"]] == [["slug"]]


def test_a_draft_can_be_given_up_once_there_is_a_version(
    signed_in: Researching, library: list[str]
) -> None:
    made(signed_in, likert(library))
    assert signed_in.delete(f"{STUDIES}/gaits/draft").status_code == 409
    signed_in.post(f"{STUDIES}/gaits/publish")
    signed_in.put(f"{STUDIES}/gaits/draft", json=likert(library, title="Mistake"))
    back = signed_in.delete(f"{STUDIES}/gaits/draft").json()
    assert back["draft"] is None
    assert back["definition"]["title"] == "Gaits"


@pytest.mark.parametrize("template", TEMPLATES)
def test_every_template_becomes_a_draft_whose_only_faults_are_missing_clips_and_spaces(
    signed_in: Researching, template: str
) -> None:
    study = signed_in.post(STUDIES, json={"template": template}).json()
    assert study["title"] == TEMPLATES[template].build()["title"]
    # This library is small; in the whole one, the templates' own tests find every clip and space.
    missing = ("clip", "authoring space")
    assert all(any(it in problem["message"] for it in missing) for problem in study["problems"])


def test_an_unknown_template_and_two_beginnings_at_once_are_refused(signed_in: Researching) -> None:
    assert signed_in.post(STUDIES, json={"template": "none"}).status_code == 404
    two = {"template": "none", "definition": {}}
    assert signed_in.post(STUDIES, json=two).status_code == 422


def test_a_study_comes_back_from_its_own_file(signed_in: Researching, library: list[str]) -> None:
    study = published(signed_in, likert(library))
    for ending in ("yaml", "json"):
        file = signed_in.get(f"{STUDIES}/gaits/file", params={"format": ending, "version": 1})
        assert f'filename="gaits-1.{ending}"' in file.headers["content-disposition"]
        read = yaml.safe_load(file.text)  # JSON is YAML
        assert read["parts"][0]["stimuli"][0]["name"] == library[0]
        uploaded = {"file": {"name": f"gaits.{ending}", "text": file.text}}
        copy = signed_in.post(STUDIES, json=uploaded).json()
        assert copy["slug"] not in ("", "gaits")
        signed_in.post(f"{STUDIES}/{copy['slug']}/publish")
        other = signed_in.get(f"{STUDIES}/{copy['slug']}").json()["definition"]
        assert {**other, "slug": "gaits"} == study["definition"]
    assert signed_in.get(f"{STUDIES}/gaits/file", params={"version": 9}).status_code == 404


def test_a_faulty_file_makes_nothing_and_names_its_lines(signed_in: Researching) -> None:
    before = signed_in.get(STUDIES).json()
    text = "slug: Bad Slug\ntitle: x\nparts: []\n"
    answer = signed_in.post(STUDIES, json={"file": {"name": "x.yaml", "text": text}})
    assert answer.status_code == 422
    faults = answer.json()["error"]["where"]["faults"]
    assert {"line": 1, "path": ["slug"]}.items() <= faults[0].items()
    assert signed_in.get(STUDIES).json() == before


def test_how_a_study_is_run_changes_without_a_version(
    signed_in: Researching, library: list[str]
) -> None:
    study = published(signed_in, likert(library))
    wanted = {"quota": 20, "prolific": {"complete": "CODE1"}, "opens_at": "2026-01-01T00:00:00Z"}
    changed = signed_in.put(f"{STUDIES}/gaits/running", json=wanted).json()
    assert changed["running"]["quota"] == 20
    assert changed["running"]["prolific"]["complete"] == "CODE1"
    assert changed["versions"] == study["versions"]
    wrong = {"prolific": {"complete": "no spaces"}}
    assert signed_in.put(f"{STUDIES}/gaits/running", json=wrong).status_code == 422
    assert signed_in.get(f"{STUDIES}/gaits").json()["running"] == changed["running"]


def test_a_study_opens_pauses_and_closes_once_published(
    signed_in: Researching, library: list[str]
) -> None:
    made(signed_in, likert(library))
    early = signed_in.post(f"{STUDIES}/gaits/state", json={"state": "open"})
    assert early.status_code == 409
    signed_in.post(f"{STUDIES}/gaits/publish")
    for state in ("paused", "closed", "open"):
        answer = signed_in.post(f"{STUDIES}/gaits/state", json={"state": state})
        assert answer.json()["state"] == state
    assert signed_in.post(f"{STUDIES}/gaits/state", json={"state": "draft"}).status_code == 422


def test_a_copy_is_a_draft_of_its_own(signed_in: Researching, library: list[str]) -> None:
    published(signed_in, likert(library))
    copy = signed_in.post(f"{STUDIES}/gaits/duplicate").json()
    assert (copy["title"], copy["state"], copy["versions"]) == ("Gaits (copy)", "draft", [])
    assert copy["problems"] == []


def test_only_what_was_never_published_can_be_deleted(
    signed_in: Researching, library: list[str]
) -> None:
    published(signed_in, likert(library))
    assert signed_in.delete(f"{STUDIES}/gaits").status_code == 409
    made(signed_in, likert(library))
    assert signed_in.delete(f"{STUDIES}/gaits-2").status_code == 204
    assert signed_in.get(f"{STUDIES}/gaits-2").status_code == 404


def test_the_same_name_gives_the_same_personal_link(
    signed_in: Researching, library: list[str]
) -> None:
    published(signed_in, likert(library))
    address = f"{STUDIES}/gaits/invitations"
    named = [signed_in.post(address, json={"labels": ["a", "b", "a"]}).json() for _ in range(2)]
    assert named[0] == named[1]
    assert [one["label"] for one in named[0]["invitations"]] == ["a", "b"]
    told = signed_in.post(address, json={"labels": ["a\x00b"]}).json()
    assert [one["label"] for one in told["invitations"]] == ["ab"]
    assert signed_in.post(address, json={"labels": ["\x00"]}).status_code == 422
    fresh = signed_in.post(address, json={"count": 30}).json()["invitations"]
    assert len({one["url"] for one in fresh}) == 30
    path = fresh[0]["url"].partition("://")[2].partition("/")[2]
    assert signed_in.get(f"/{path}").status_code == 200


def test_the_preview_shows_every_step_and_stores_nothing(
    signed_in: Researching, library: list[str]
) -> None:
    made(signed_in, likert(library))
    seen = signed_in.get(f"{STUDIES}/gaits/preview", params={"part": "gait"}).json()
    assert seen["study"]["preview"] is True
    assert len(seen["steps"]) == len(library)
    assert seen["parts"]["gait"]["question"] == "How far do you agree?"
    page = signed_in.get("/research/studies/gaits/preview", params={"part": "gait"})
    assert "frame-ancestors 'self'" in page.headers["content-security-policy"]
    assert "frame-ancestors 'none'" in signed_in.get("/library").headers["content-security-policy"]
    counts = signed_in.get(STUDIES).json()["studies"][-1]["counts"]
    assert counts == {"complete": 0, "active": 0, "withdrawn": 0}


def test_the_preview_shows_pages_before_there_is_a_clip_and_waits_for_what_is_broken(
    signed_in: Researching, library: list[str]
) -> None:
    pause = {"kind": "break", "id": "rest", "heading": "Rest", "text": "Go on."}
    study = made(signed_in, likert(library, parts=[pause]))
    assert (len(study["problems"]), study["can_be_shown"]) == (1, True)
    assert signed_in.get(f"{STUDIES}/gaits/preview").json()["steps"][0]["kind"] == "break"
    broken = likert([*library, "nobody_walks"])
    saved = signed_in.put(f"{STUDIES}/gaits/draft", json=broken).json()
    assert saved["can_be_shown"] is False
    assert signed_in.get(f"{STUDIES}/gaits/preview").status_code == 422
    odd = likert(library)
    odd["parts"][0]["task"] = {"kind": "choose", "question": "Which?"}
    odd["parts"][0]["sets"] = [["nobody", "anybody"]]
    saved = signed_in.put(f"{STUDIES}/gaits/draft", json=odd).json()
    assert (bool(saved["problems"]), saved["can_be_shown"]) == (True, False)
    assert signed_in.get(f"{STUDIES}/gaits/preview").status_code == 422


def test_every_change_leaves_a_line_in_the_audit_trail(
    signed_in: Researching, library: list[str]
) -> None:
    published(signed_in, likert(library))
    signed_in.put(f"{STUDIES}/gaits/draft", json=likert(library, title="Other"))
    signed_in.put(f"{STUDIES}/gaits/running", json={"quota": 5})
    signed_in.post(f"{STUDIES}/gaits/state", json={"state": "paused"})
    signed_in.post(f"{STUDIES}/gaits/invitations", json={"count": 2})
    signed_in.delete(f"{STUDIES}/gaits/draft")
    acts = [one["act"] for one in signed_in.get(f"{STUDIES}/gaits/audit").json()["entries"]]
    assert acts == [
        "draft_discarded", "links_made", "state_changed", "running_changed", "draft_saved",
        "published", "study_created",
    ]  # fmt: skip


def test_strangers_see_nothing_and_viewers_change_nothing(
    signed_in: Researching, database: Database, client: TestClient, library: list[str]
) -> None:
    published(signed_in, likert(library))
    with database.writing() as db:
        other = Researcher(email="olli@example.org", name="Olli", password_hash="")
        db.add(other)
        db.commit()
        secret = keys.make(db, other.id, "script", "write").secret
    key = {"authorization": f"Bearer {secret}"}
    client.cookies.clear()
    assert client.get(f"{STUDIES}/gaits", headers=key).status_code == 404
    assert client.get(STUDIES, headers=key).json()["studies"] == []


def test_a_viewer_looks_and_changes_nothing(
    signed_in: Researching, database: Database, library: list[str]
) -> None:
    published(signed_in, likert(library))
    with database.writing() as db:
        other = Researcher(email="olli@example.org", name="Olli", password_hash="")
        db.add(other)
        db.commit()
        secret = keys.make(db, other.id, "script", "write").secret
    role = {"role": "viewer"}
    added = signed_in.put(f"{STUDIES}/gaits/members/olli@example.org", json=role)
    assert added.status_code == 200
    key = {"authorization": f"Bearer {secret}"}
    assert signed_in.client.get(f"{STUDIES}/gaits", headers=key).json()["role"] == "viewer"
    refused = [
        signed_in.client.put(f"{STUDIES}/gaits/draft", headers=key, json={}),
        signed_in.client.put(f"{STUDIES}/gaits/running", headers=key, json={}),
        signed_in.client.post(f"{STUDIES}/gaits/publish", headers=key),
        signed_in.client.post(f"{STUDIES}/gaits/state", headers=key, json={"state": "closed"}),
        signed_in.client.delete(f"{STUDIES}/gaits", headers=key),
    ]
    assert [answer.status_code for answer in refused] == [403] * 5


def test_the_welcome_can_be_looked_at_before_anything_is_published_and_begins_nothing(
    signed_in: Researching, library: list[str], database: Database
) -> None:
    signed_in.post(STUDIES, json={"definition": likert(library)})
    page = signed_in.client.get("/research/studies/gaits/preview?part=:welcome")
    assert page.status_code == 200
    assert "inert" in page.text
    assert likert(library)["consent"]["statement"] in page.text
    with database.reading() as db:
        assert db.scalars(select(StudySession)).all() == []
