"""Who may call which address of the API: every route, by every kind of caller."""

from __future__ import annotations

from collections.abc import Iterator
from uuid import uuid4

import pytest
from fastapi.routing import APIRoute
from httpx2 import Response
from starlette.testclient import TestClient

from app.main import ROUTERS
from app.persistence.engine import Database
from app.services import keys
from tests.app.conftest import Researching

# Samples are for everybody; a participant's secret is the token in the address.
FOR_ALL = ("/api/v1/clips", "/api/v1/clips/{clip_id}", "/api/v1/sessions/{token}")
FORMATS = (".json", ".glb", ".bvh")
# They compute and store nothing.
ASKED_BY_POST = {
    "/api/v1/clips/preview",
    "/api/v1/clips/check",
    "/api/v1/clips/ease-off",
    "/api/v1/clips/batch/plan",
    "/api/v1/graphs/preview",
    "/api/v1/graphs/{graph_id}/play",
    "/api/v1/spaces/{space_id}/weights",
    "/api/v1/spaces/{space_id}/motion",
    "/api/v1/spaces/{space_id}/recipe",
    "/api/v1/spaces/{space_id}/targets",
}


def routes() -> Iterator[tuple[str, str]]:
    """Method and path of all that asks who is there."""
    for route in (route for router in ROUTERS for route in router.routes):
        if isinstance(route, APIRoute) and route.path.startswith("/api/"):
            yield from ((method, route.path) for method in sorted(route.methods))


def is_for_all(method: str, path: str) -> bool:
    bare = path.removesuffix(next((end for end in FORMATS if path.endswith(end)), ""))
    return path.startswith("/api/v1/sessions/") or (method in ("GET", "HEAD") and bare in FOR_ALL)


GUARDED = [call for call in routes() if not is_for_all(*call)]
READING = [call for call in GUARDED if call[0] == "GET" or call[1] in ASKED_BY_POST]
WRITING = [call for call in GUARDED if call not in READING]


def call(client: TestClient, method: str, path: str, **headers: str) -> Response:
    """Calls with nothing in the body and numbers that nobody has."""
    for name in (
        "clip_id", "graph_id", "job_id", "pose_id", "name", "slug", "session_id", "email", "part",
        "space_id", "index", "job",
    ):  # fmt: skip
        path = path.replace(f"{{{name}}}", str(uuid4()))
    assert "{" not in path, f"{path}: say what stands in its place"
    return client.request(method, path, headers=headers)


def refusal(response: Response) -> tuple[int, str] | None:
    """Status and code of an answer that sends the caller away."""
    if response.status_code not in (401, 403):
        return None
    return response.status_code, response.json()["error"]["code"]


@pytest.fixture
def secrets(database: Database, researcher: str) -> dict[str, str]:
    with database.writing() as db:
        return {scope: keys.make(db, 1, scope, scope).secret for scope in ("read", "write")}


def test_there_is_something_to_guard() -> None:
    assert len(READING) > 15
    assert len(WRITING) > 12
    assert {path for _, path in routes()} >= ASKED_BY_POST


def test_a_stranger_is_sent_away(client: TestClient) -> None:
    told = {one: refusal(call(client, *one)) for one in GUARDED}
    assert told == dict.fromkeys(GUARDED, (401, "key_needed"))


def test_a_key_for_reading_reads_and_never_writes(
    client: TestClient, secrets: dict[str, str]
) -> None:
    key = {"authorization": f"Bearer {secrets['read']}"}
    told = {one: refusal(call(client, *one, **key)) for one in READING + WRITING}
    assert told == {
        **dict.fromkeys(READING),
        **dict.fromkeys(WRITING, (403, "read_only_key")),
    }


def test_a_key_for_writing_does_both(client: TestClient, secrets: dict[str, str]) -> None:
    key = {"authorization": f"Bearer {secrets['write']}"}
    told = {one: refusal(call(client, *one, **key)) for one in READING + WRITING}
    assert told == dict.fromkeys(READING + WRITING)


def test_a_cookie_reads_and_writes_only_from_our_own_pages(signed_in: Researching) -> None:
    token = {"x-csrf-token": signed_in.headers["X-CSRF-Token"]}
    bare = {one: refusal(call(signed_in.client, *one)) for one in GUARDED}
    assert {one for one, told in bare.items() if told} == set(WRITING)
    assert {bare[one] for one in WRITING} == {(403, "csrf_token_invalid")}
    own = {one: refusal(call(signed_in.client, *one, **token)) for one in GUARDED}
    assert own == dict.fromkeys(GUARDED)


def test_samples_and_ones_own_session_ask_nobody_who_they_are(
    client: TestClient, samples_made: int
) -> None:
    sample = client.get("/api/v1/clips").json()["clips"][0]["id"]
    for_all = [one for one in routes() if is_for_all(*one)]
    told = {
        (method, path): refusal(
            call(client, method, path.replace("{token}", "nobody").replace("{clip_id}", sample))
        )
        for method, path in for_all
    }
    assert told == dict.fromkeys(for_all)
