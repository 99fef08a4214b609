"""A clip in its formats: chosen by Accept or suffix, known by tags, in parts."""

from __future__ import annotations

import gzip
import json

import pytest
from starlette.testclient import TestClient

from motion.glb import ANIMATION_NAME
from tests.app.conftest import Researching
from tests.support.motions import walk

URL = f"/api/v1/clips/{walk().content_hash}"
PLAIN = {"Accept-Encoding": "identity"}
TYPES = {"json": "application/json", "glb": "model/gltf-binary", "bvh": "text/x-bvh"}


@pytest.fixture(autouse=True)
def library(samples_made: int) -> None:
    """Every test has the samples."""


@pytest.mark.parametrize(
    ("accept", "wanted"),
    [
        ("*/*", "json"), ("", "json"), ("application/json", "json"), ("text/html", "json"),
        ("model/gltf-binary", "glb"), ("text/x-bvh", "bvh"), ("application/x-bvh", "bvh"),
        ("application/json;q=0.5, model/gltf-binary", "glb"),
        ("model/gltf-binary;q=0.2, text/x-bvh;q=0.9, */*;q=0.1", "bvh"),
        ("model/gltf-binary;q=0", "json"), ("text/x-bvh; q=nonsense", "json"),
    ],
)  # fmt: skip
def test_accept_chooses_the_format(client: TestClient, accept: str, wanted: str) -> None:
    response = client.get(URL, headers={"Accept": accept})
    assert response.status_code == 200
    assert response.headers["content-type"] == type_of(wanted)
    assert "accept" in response.headers["vary"].lower()
    assert "content-disposition" not in response.headers
    assert response.content == client.get(f"{URL}.{wanted}").content


def type_of(wanted: str) -> str:
    return TYPES[wanted] + ("; charset=utf-8" if TYPES[wanted].startswith("text/") else "")


@pytest.mark.parametrize("wanted", TYPES)
def test_a_suffix_chooses_the_format_and_names_the_file(client: TestClient, wanted: str) -> None:
    response = client.get(f"{URL}.{wanted}")
    name = client.get(f"{URL}?motion=false").json()["name"]
    assert response.headers["content-type"] == type_of(wanted)
    assert response.headers["content-disposition"].endswith(f"''{name}.{wanted}")


@pytest.mark.parametrize("wanted", TYPES)
@pytest.mark.parametrize("encoding", ["gzip", "identity"])
def test_what_a_client_has_is_not_sent_again(
    client: TestClient, wanted: str, encoding: str
) -> None:
    headers = {"Accept-Encoding": encoding}
    first = client.get(f"{URL}.{wanted}", headers=headers)
    tag = first.headers["etag"]
    assert not tag.startswith("W/")
    again = client.get(f"{URL}.{wanted}", headers={**headers, "If-None-Match": tag})
    assert (again.status_code, again.content, again.headers["etag"]) == (304, b"", tag)
    assert client.get(f"{URL}.{wanted}", headers={"If-None-Match": '"x"'}).status_code == 200


def test_other_bytes_have_another_tag(client: TestClient) -> None:
    answers = [
        client.get(f"{URL}{rest}", headers={"Accept-Encoding": encoding})
        for rest in (".json", ".json?motion=false", ".glb", ".glb?figure=false", ".bvh")
        for encoding in ("gzip", "identity")
    ]
    assert len({answer.headers["etag"] for answer in answers}) == len(answers)


@pytest.mark.parametrize("wanted", TYPES)
def test_compressed_or_not_it_is_the_same_file(client: TestClient, wanted: str) -> None:
    with client.stream("GET", f"{URL}.{wanted}", headers={"Accept-Encoding": "gzip"}) as packed:
        raw = b"".join(packed.iter_raw())
    assert packed.headers["content-encoding"] == "gzip"
    assert gzip.decompress(raw) == client.get(f"{URL}.{wanted}", headers=PLAIN).content


@pytest.mark.parametrize("wanted", TYPES)
def test_parts_put_together_are_the_file(client: TestClient, wanted: str) -> None:
    whole = client.get(f"{URL}.{wanted}", headers=PLAIN)
    half = len(whole.content) // 2
    parts = []
    for given in (f"bytes=0-{half - 1}", f"bytes={half}-"):
        headers = PLAIN | {"Range": given, "If-Range": whole.headers["etag"]}
        part = client.get(f"{URL}.{wanted}", headers=headers)
        assert part.status_code == 206
        parts.append(part.content)
    assert b"".join(parts) == whole.content
    late = client.get(f"{URL}.{wanted}", headers={"Range": "bytes=999999999-"})
    assert (late.status_code, late.headers["content-range"]) == (
        416,
        f"bytes */{len(whole.content)}",
    )
    older = PLAIN | {"Range": "bytes=0-9", "If-Range": '"older"'}
    assert client.get(f"{URL}.{wanted}", headers=older).content == whole.content


@pytest.mark.parametrize("rest", ["", ".json", ".glb", ".bvh"])
def test_head_tells_what_get_would_send(client: TestClient, rest: str) -> None:
    told = client.head(URL + rest, headers=PLAIN)
    sent = client.get(URL + rest, headers=PLAIN)
    assert (told.status_code, told.content) == (200, b"")
    for name in ("content-length", "content-type", "etag", "accept-ranges"):
        assert told.headers[name] == sent.headers[name]


def test_the_figure_and_the_motion_can_be_left_out(client: TestClient) -> None:
    with_figure, without = client.get(f"{URL}.glb"), client.get(f"{URL}.glb?figure=false")
    assert b'"skins"' in with_figure.content
    assert b'"skins"' not in without.content
    assert ANIMATION_NAME.encode() in without.content
    about = client.get(f"{URL}.json?motion=false").json()
    whole = client.get(f"{URL}.json").json()
    assert "motion" not in about
    assert {name: value for name, value in whole.items() if name != "motion"} == about


def test_a_clip_too_long_for_json_says_what_to_take_instead(
    client: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.services.rendering.JSON_NUMBERS", 10)
    response = client.get(f"{URL}.json")
    error = response.json()["error"]
    assert (response.status_code, error["code"]) == (422, "too_long_for_json")
    assert "?motion=false" in error["mend"]
    assert client.get(f"{URL}.json?motion=false").status_code == 200


def test_json_is_one_json_document(client: TestClient) -> None:
    document = json.loads(client.get(f"{URL}.json").content)
    assert document["id"] == walk().content_hash
    assert len(document["motion"]["rotations"]) == document["frames"]


@pytest.mark.parametrize("rest", ["", ".json", ".glb", ".bvh"])
def test_a_clip_that_is_not_there_is_not_found(signed_in: Researching, rest: str) -> None:
    client, missing = signed_in.client, f"/api/v1/clips/{'0' * 64}{rest}"
    response = client.get(missing)
    assert (response.status_code, response.json()["error"]["code"]) == (404, "clip_not_found")
    assert client.head(missing).status_code == 404
