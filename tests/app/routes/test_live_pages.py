"""The live page, one participant's page, members and audit trail, by page and by API."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
from starlette.testclient import TestClient

from app.persistence.engine import Database
from app.persistence.models import Researcher, StudySession
from app.persistence.writer import Writer
from app.services import keys, rights
from app.studies import emotion
from tests.app.conftest import Researching
from tests.support import simulate

PAGE = f"/research/studies/{emotion.SLUG}"
API = f"/api/v1/studies/{emotion.SLUG}"


@pytest.fixture
def taken(client: TestClient, database: Database) -> list[str]:
    """The ids of three participants: two complete, one on the way."""
    with database.writing() as db:
        simulate.add_study(db)
    writer: Writer = client.app.state.writer
    generator = np.random.default_rng(1)
    for answered in (None, None, 3):
        simulate.take_part(writer.write, generator, answered=answered)
    with database.reading() as db:
        found = db.query(StudySession).order_by(StudySession.created_at)
        return [str(one.id) for one in found]


@pytest.fixture
def other_owner(database: Database, researcher: str) -> None:
    """The study belongs to somebody else; the one who is signed in sees it."""
    with database.writing() as db:
        db.add(Researcher(email="olga@example.org", name="Olga", password_hash="-"))
        db.commit()
        access = rights.access(db, emotion.SLUG, 2, "own")
        rights.put_member(db, access, researcher, "viewer")


def test_the_live_page_shows_numbers_charts_and_everybody(signed_in, taken):
    page = signed_in.get(f"{PAGE}/live").text
    assert "<dt>Complete</dt><dd>2</dd>" in page
    charts = json.loads(re.search(r'id="live-charts">(.*?)</script>', page).group(1))
    assert set(charts) == {"standing", "dropout", "durations", "clips"}
    assert all(set(chart) == {"light", "dark"} for chart in charts.values())
    for session in taken:
        assert f"{PAGE}/sessions/{session}" in page


def test_the_page_and_the_fragment_it_asks_for_tell_the_same(signed_in, taken):
    page, now = signed_in.get(f"{PAGE}/live").text, signed_in.get(f"{PAGE}/live/now").text
    pieces = re.findall(r'data-live="(\w+)"', now)
    assert pieces == re.findall(r'data-live="(\w+)"', page)
    assert "<html" not in now


def test_before_the_first_participant_the_page_says_so(signed_in, database):
    with database.writing() as db:
        simulate.add_study(db)
    assert "Nobody has begun yet" in signed_in.get(f"{PAGE}/live").text
    assert "manner simulate" in signed_in.get(f"{PAGE}/live?kind=simulated").text


def test_the_api_tells_what_the_page_shows(signed_in, taken):
    view = signed_in.get(f"{API}/live").json()
    assert view["counts"]["complete"] == 2
    assert view["counts"]["under_way"] == 1
    assert {one["id"] for one in view["latest"]["sessions"]} == set(taken)


def test_a_participants_page_holds_the_way_through_the_study(signed_in, taken):
    page = signed_in.get(f"{PAGE}/sessions/{taken[0]}").text
    steps = json.loads(re.search(r'id="steps">(.*?)</script>', page, re.S).group(1))
    assert len(steps) == 22
    assert page.count("data-step=") == 22
    detail = signed_in.get(f"{API}/sessions/{taken[0]}").json()
    assert detail["steps"] == steps


def test_leaving_out_needs_a_reason_and_is_told_in_the_trail(signed_in, taken):
    address = f"{API}/sessions/{taken[0]}/exclude"
    assert signed_in.post(address, json={"reason": "  "}).status_code == 422
    assert signed_in.post(address, json={"reason": "asleep"}).status_code == 204
    assert signed_in.get(f"{API}/live").json()["counts"]["excluded"] == 1
    told = signed_in.get(f"{API}/audit").json()["entries"]
    assert [one["sentence"] for one in told] == [f"left participant {taken[0][:8]} out: asleep"]
    assert "asleep" in signed_in.get(f"{PAGE}/live").text
    assert signed_in.post(f"{API}/sessions/{taken[0]}/include").status_code == 204
    assert signed_in.get(f"{API}/live").json()["counts"]["complete"] == 2


def test_hostile_reasons_are_shown_as_text(signed_in, taken):
    reason = "</script><script>alert(1)</script>\u202e<b>"
    signed_in.post(f"{API}/sessions/{taken[0]}/flag", json={"reason": reason})
    for page in (f"{PAGE}/live", f"{PAGE}/sessions/{taken[0]}"):
        assert "<script>alert" not in signed_in.get(page).text
    assert signed_in.get(f"{API}/live").json()["marked"]["sessions"][0]["flag"]["reason"] == reason


def test_all_of_one_person_comes_as_a_file(signed_in, taken):
    response = signed_in.get(f"{API}/sessions/{taken[0]}/export.json")
    assert f"{taken[0][:8]}.json" in response.headers["content-disposition"]
    assert len(response.json()["answers"]) == 22


def test_who_is_deleted_is_gone_from_every_page(signed_in, taken):
    assert signed_in.delete(f"{API}/sessions/{taken[0]}").status_code == 204
    assert signed_in.get(f"{PAGE}/sessions/{taken[0]}").status_code == 404
    assert signed_in.get(f"{API}/sessions/{taken[0]}/export.json").status_code == 404
    counts = signed_in.get(f"{API}/live").json()["counts"]
    assert (counts["complete"], counts["withdrawn"]) == (1, 1)
    for session in taken:
        signed_in.delete(f"{API}/sessions/{session}")
    page = signed_in.get(f"{PAGE}/live")
    assert page.status_code == 200
    assert "Nobody to show." in page.text


def test_a_viewer_sees_everything_and_changes_nothing(
    signed_in: Researching, taken, other_owner: None
) -> None:
    seen = [
        f"{PAGE}/live", f"{PAGE}/live/now", f"{PAGE}/sessions/{taken[0]}", PAGE,
        f"{PAGE}/counts", f"{PAGE}/responses.csv", f"{PAGE}/psych-ds.zip", f"{API}/live",
        f"{API}/results", f"{API}/audit", f"{API}/members", f"{API}/sessions/{taken[0]}",
    ]  # fmt: skip
    assert {place: signed_in.get(place).status_code for place in seen} == dict.fromkeys(seen, 200)
    assert "data-act=" not in signed_in.get(f"{PAGE}/sessions/{taken[0]}").text
    session = f"{API}/sessions/{taken[0]}"
    refused = [
        signed_in.post(f"{session}/exclude", json={"reason": "no"}),
        signed_in.post(f"{session}/flag", json={"reason": "no"}),
        signed_in.delete(session),
        signed_in.get(f"{session}/export.json"),
        signed_in.put(f"{API}/members/rosa@example.org", json={"role": "owner"}),
        signed_in.delete(f"{API}/members/olga@example.org"),
    ]
    assert [(one.status_code, one.json()["error"]["code"]) for one in refused] == [
        (403, "role_too_low")
    ] * len(refused)


def test_a_stranger_finds_no_such_study_at_any_address(
    signed_in: Researching, taken, other_owner: None
) -> None:
    assert signed_in.delete(f"{API}/members/rosa@example.org").status_code == 204
    places = [
        PAGE, f"{PAGE}/live", f"{PAGE}/live/now", f"{PAGE}/sessions/{taken[0]}", f"{PAGE}/counts",
        f"{PAGE}/responses.csv", f"{PAGE}/wide.csv", f"{PAGE}/responses.jsonl",
        f"{PAGE}/codebook.csv", f"{PAGE}/codebook.json", f"{PAGE}/analysis.R",
        f"{PAGE}/analysis.ipynb", f"{PAGE}/psych-ds.zip", f"{PAGE}/figures/means-sad_happy.svg",
        f"{API}/live", f"{API}/results", f"{API}/audit", f"{API}/members",
        f"{API}/sessions/{taken[0]}", f"{API}/sessions/{taken[0]}/export.json", API,
    ]  # fmt: skip
    found = {place: signed_in.get(place).status_code for place in places}
    assert found == dict.fromkeys(places, 404)


def test_a_key_acts_as_its_researcher(
    client: TestClient, database: Database, taken, other_owner: None
) -> None:
    with database.writing() as db:
        viewers, owners = (keys.make(db, who, "k", "write").secret for who in (1, 2))
    address = f"{API}/sessions/{taken[0]}/exclude"
    codes = []
    for secret in (viewers, owners):
        bearer = {"authorization": f"Bearer {secret}"}
        codes.append(client.post(address, json={"reason": "why"}, headers=bearer).status_code)
        assert client.get(f"{PAGE}/responses.csv", headers=bearer).status_code == 200
    assert codes == [403, 204]


def test_members_come_by_address_and_go_again(signed_in, taken, database):
    with database.writing() as db:
        db.add(Researcher(email="olga@example.org", name="Olga", password_hash="-"))
        db.commit()
    before = signed_in.get(f"{API}/members").json()
    assert (before["everybodys"], before["role"]) == (True, "owner")
    put = signed_in.put(f"{API}/members/olga@example.org", json={"role": "editor"})
    assert [(m["email"], m["role"]) for m in put.json()["members"]] == [
        ("olga@example.org", "editor"), ("rosa@example.org", "owner"),
    ]  # fmt: skip
    assert signed_in.delete(f"{API}/members/olga@example.org").status_code == 204
    last = signed_in.delete(f"{API}/members/rosa@example.org")
    assert (last.status_code, last.json()["error"]["code"]) == (409, "last_owner")
    unknown = signed_in.put(f"{API}/members/nobody@example.org", json={"role": "viewer"})
    assert unknown.json()["error"]["code"] == "researcher_not_found"
