"""Batches and jobs over the API: who may, what is refused, what is told."""

from __future__ import annotations

import time
from uuid import uuid4

import pytest
from httpx2 import Response
from starlette.testclient import TestClient

from app.persistence.engine import Database
from app.services import keys, samples
from motion.procedural.library import acted
from tests.app.conftest import Researching
from tests.support.motions import walk, walks

PATIENCE = 120  # seconds until a test gives up waiting
BATCH = "/api/v1/clips/batch"
READING = [
    ("get", "/api/v1/jobs"),
    ("get", f"/api/v1/jobs/{uuid4()}"),
    ("get", "/api/v1/sets/foerger"),
    ("post", f"{BATCH}/plan"),
]
# Förger, figure 29.
FEMALE = [
    "afraid", "angry", "excited", "masculine", "relaxed",
    "sad", "strong", "tired", "weak", "feminine",
]  # fmt: skip
MALE = [
    "afraid", "angry", "energetic_sadness", "excited", "feminine",
    "relaxed", "sad", "strong", "tired", "weak",
]  # fmt: skip
WRITING = [("post", BATCH), ("delete", f"/api/v1/jobs/{uuid4()}")]


@pytest.fixture
def program(client: TestClient, database: Database, researcher: str) -> Program:
    with database.writing() as db:
        made = {scope: keys.make(db, 1, scope, scope).secret for scope in ("read", "write")}
    return Program(client, made)


class Program:
    """Calls the API with a key, without cookies."""

    def __init__(self, client: TestClient, secrets: dict[str, str]) -> None:
        self.client = client
        self.secrets = secrets

    def call(self, method: str, path: str, scope: str = "write", **more: object) -> Response:
        headers = {"Authorization": f"Bearer {self.secrets[scope]}"}
        return self.client.request(method, path, headers=headers, **more)


def body(method: str) -> dict[str, object]:
    return {"json": {"sources": ["0" * 64], "presets": ["sad"]}} if method == "post" else {}


def finished(program: Program, job: str) -> dict:
    end = time.monotonic() + PATIENCE
    while True:
        found = program.call("get", f"/api/v1/jobs/{job}", "read").json()
        if found["ended_at"]:
            return found
        assert time.monotonic() < end, found
        time.sleep(0.05)


def test_a_stranger_is_asked_for_a_key(client: TestClient) -> None:
    for method, path in READING + WRITING:
        response = client.request(method, path, **body(method))
        assert response.status_code == 401
        assert response.headers["www-authenticate"] == "Bearer"
        assert response.json()["error"]["code"] == "key_needed"


def test_a_wrong_key_is_refused(client: TestClient) -> None:
    for secret in ("mnr_" + "x" * 43, "", "x y", "ü"):
        headers = {"Authorization": f"Bearer {secret}".encode("latin-1")}
        for method, path in READING + WRITING:
            response = client.request(method, path, headers=headers, **body(method))
            assert response.status_code == 401
            assert response.headers["www-authenticate"] == "Bearer"
            assert response.json()["error"]["code"] == "key_unknown"


def test_a_wrong_key_is_refused_even_from_somebody_who_is_signed_in(
    signed_in: Researching,
) -> None:
    headers = {"Authorization": "Bearer mnr_wrong", **signed_in.headers}
    assert signed_in.client.get("/api/v1/jobs", headers=headers).status_code == 401


def test_a_key_for_reading_does_not_write(program: Program) -> None:
    for method, path in WRITING:
        response = program.call(method, path, "read", **body(method))
        assert response.status_code == 403
        assert response.json()["error"]["code"] == "read_only_key"


def test_a_key_needs_no_token_against_forgery(program: Program) -> None:
    for method, path in READING + WRITING:
        response = program.call(method, path, **body(method))
        assert response.status_code in (200, 404, 422)


def test_a_cookie_alone_does_not_write(signed_in: Researching) -> None:
    for method, path in WRITING:
        response = signed_in.client.request(method, path, **body(method))
        assert response.status_code == 403
        assert response.json()["error"]["code"] == "csrf_token_invalid"


def test_a_header_of_another_kind_is_not_ours(signed_in: Researching) -> None:
    headers = {"Authorization": "Basic cm9zYTpwYXNz"}
    assert signed_in.client.get("/api/v1/jobs", headers=headers).status_code == 200


def test_a_use_of_a_key_is_noted(program: Program, database: Database) -> None:
    program.call("get", "/api/v1/jobs", "read")
    end = time.monotonic() + PATIENCE
    used: set[str] = set()
    while not used and time.monotonic() < end:
        with database.reading() as db:
            used = {key.name for key in keys.listed(db, 1) if key.last_used_at}
    assert used == {"read"}


def test_a_program_makes_many_clips(program: Program, samples_made: int) -> None:
    ids = [sample.clip.content_hash for sample in walks()]
    response = program.call(
        "post", BATCH, json={"sources": ids, "presets": ["happy"], "tags": {"set": "pilot"}}
    )
    assert response.status_code == 202
    job = response.json()
    assert response.headers["location"] == f"/api/v1/jobs/{job['id']}"
    assert (job["total"], job["done"], len(job["items"])) == (3, 0, 3)
    done = finished(program, job["id"])
    assert (done["state"], done["done"]) == ("done", 3)
    assert [item["source"] for item in done["items"]] == ids
    for item in done["items"]:
        clip = program.call("get", f"/api/v1/clips/{item['clip']}", "read").json()
        assert clip["name"] == item["name"]
        assert clip["tags"]["set"] == "pilot"
    (listed,) = program.call("get", "/api/v1/jobs", "read").json()["jobs"]
    assert listed["id"] == job["id"]
    assert program.call("delete", f"/api/v1/jobs/{job['id']}").json() == done


def test_what_is_wrong_with_one_item_is_told_with_its_place(
    program: Program, samples_made: int
) -> None:
    good = {"source": walk().content_hash, "preset": "sad"}
    for bad, code in (
        ({"source": walk().content_hash, "preset": "furious"}, "preset_unknown"),
        ({"source": "0" * 64, "preset": "sad"}, "clip_not_found"),
        ({"source": walk().content_hash}, "invalid_request"),
    ):
        response = program.call("post", BATCH, json={"items": [good, bad]})
        assert response.status_code == 422
        error = response.json()["error"]
        assert error["code"] == code
        assert error["where"].get("item") == 1 or "items.1" in str(error["where"])
    assert program.call("get", "/api/v1/jobs").json() == {"jobs": []}


def test_a_request_that_makes_no_sense_is_refused(program: Program) -> None:
    for wrong in (
        {},
        {"items": []},
        {"sources": ["0" * 64]},
        {"items": [{"source": "0" * 64, "preset": "sad"}], "presets": ["sad"]},
        {"sources": ["0" * 64], "presets": ["sad"], "colour": "red"},
    ):
        response = program.call("post", BATCH, json=wrong)
        assert response.status_code == 422
        assert response.json()["error"]["code"] == "invalid_request"


def test_a_job_that_nobody_knows_is_not_found(program: Program) -> None:
    for method in ("get", "delete"):
        response = program.call(method, f"/api/v1/jobs/{uuid4()}")
        assert (response.status_code, response.json()["error"]["code"]) == (404, "job_not_found")
    assert program.call("get", "/api/v1/jobs/7").status_code == 422


def test_a_plan_names_and_tags_what_it_comes_to(program: Program, samples_made: int) -> None:
    source = walks()[0]
    choice = {"sources": [source.clip.content_hash], "presets": ["energetic_sadness"]}
    (item,) = program.call("post", f"{BATCH}/plan", "read", json=choice).json()["items"]
    assert item["name"] == f"{source.name} · energetic sadness"
    assert item["tags"] == {
        "set": "modified", "body": "adult", "synthetic": "yes", "emotion": "sad",
        "preset": "energetic_sadness", "made": "modified", "from": source.name,
    }  # fmt: skip
    assert item["clip"] is None
    job = program.call("post", BATCH, json=choice).json()
    (made,) = finished(program, job["id"])["items"]
    (again,) = program.call("post", f"{BATCH}/plan", "read", json=choice).json()["items"]
    assert again["clip"] == made["clip"]


def test_foergers_twenty_are_planned_from_the_two_neutral_clips(
    program: Program, database: Database
) -> None:
    neutral = [sample for sample in acted() if sample.tags["emotion"] in ("neutral", "sad")]
    samples.make(database, lambda: neutral)
    items = program.call("get", "/api/v1/sets/foerger", "read").json()["items"]
    made = {
        body: [item["preset"] for item in items if item["tags"]["body"] == body]
        for body in ("female", "male")
    }
    assert made == {"female": FEMALE, "male": MALE}
    assert len(items) == 20
    assert {item["source_name"] for item in items} == {
        "acted_female_neutral", "acted_male_neutral"
    }  # fmt: skip
    assert {item["tags"]["set"] for item in items} == {"foerger-modified"}


def test_without_the_sample_library_foergers_twenty_are_missing_with_a_mend(
    program: Program,
) -> None:
    response = program.call("get", "/api/v1/sets/foerger")
    assert response.status_code == 404
    assert "manner prepare" in response.json()["error"]["mend"]


def test_a_name_that_no_database_stores_is_refused_before_anything_begins(
    program: Program, samples_made: int
) -> None:
    item = {"source": walk().content_hash, "preset": "sad", "name": "sad\0walk"}
    response = program.call("post", BATCH, json={"items": [item]})
    assert response.status_code == 422
    assert "items.0.name" in response.json()["error"]["message"]
    assert program.call("get", "/api/v1/jobs").json() == {"jobs": []}
