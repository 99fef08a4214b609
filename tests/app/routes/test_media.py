"""Bytes by their hash: cached for ever, compressed, in parts."""

from __future__ import annotations

import gzip
import hashlib

import pytest
from starlette.testclient import TestClient

from app.persistence import blobs
from app.persistence.engine import Database

CONTENT = bytes(range(256)) * 40
DIGEST = hashlib.sha256(CONTENT).hexdigest()
URL = f"/media/{DIGEST}.glb"
PLAIN = {"Accept-Encoding": "identity"}


@pytest.fixture
def stored(database: Database) -> str:
    with database.writing() as db:
        digest = blobs.put(db, CONTENT, blobs.GLB)
        db.commit()
    return digest


def test_a_glb_is_served_by_its_hash_and_kept_for_ever(client: TestClient, stored: str) -> None:
    response = client.get(f"/media/{stored}.glb", headers=PLAIN)
    assert hashlib.sha256(response.content).hexdigest() == stored
    assert response.headers["content-type"] == "model/gltf-binary"
    assert response.headers["cache-control"] == "public, max-age=31536000, immutable"
    assert response.headers["etag"] == f'"{stored}"'


def test_it_travels_compressed_where_the_browser_can_take_it(
    client: TestClient, stored: str
) -> None:
    with client.stream("GET", URL, headers={"Accept-Encoding": "gzip"}) as response:
        raw = b"".join(response.iter_raw())
    assert response.headers["content-encoding"] == "gzip"
    assert response.headers["vary"] == "Accept-Encoding"
    assert len(raw) < len(CONTENT) / 4
    assert gzip.decompress(raw) == CONTENT


def test_other_bytes_have_another_tag(client: TestClient, stored: str) -> None:
    tags = {
        client.get(URL, headers={"Accept-Encoding": encoding}).headers["etag"]
        for encoding in ("gzip", "identity")
    }
    assert len(tags) == 2


@pytest.mark.parametrize("encoding", ["gzip", "identity"])
def test_what_the_browser_has_is_not_sent_again(
    client: TestClient, stored: str, encoding: str
) -> None:
    first = client.get(URL, headers={"Accept-Encoding": encoding})
    again = client.get(
        URL, headers={"Accept-Encoding": encoding, "If-None-Match": first.headers["etag"]}
    )
    assert again.status_code == 304
    assert again.content == b""
    assert again.headers["etag"] == first.headers["etag"]
    other = client.get(URL, headers={"If-None-Match": '"another"'})
    assert other.status_code == 200


@pytest.mark.parametrize(
    ("wanted", "start", "end"),
    [("bytes=0-99", 0, 100), ("bytes=10000-", 10_000, 10_240), ("bytes=-40", 10_200, 10_240),
     ("bytes=10000-99999", 10_000, 10_240)],
)  # fmt: skip
def test_a_part_is_given_when_asked_for(
    client: TestClient, stored: str, wanted: str, start: int, end: int
) -> None:
    response = client.get(URL, headers={"Range": wanted, "Accept-Encoding": "gzip"})
    assert response.status_code == 206
    assert response.content == CONTENT[start:end]
    assert response.headers["content-range"] == f"bytes {start}-{end - 1}/{len(CONTENT)}"


def test_a_part_beyond_the_end_is_refused(client: TestClient, stored: str) -> None:
    response = client.get(URL, headers={"Range": "bytes=99999-"})
    assert response.status_code == 416
    assert response.headers["content-range"] == f"bytes */{len(CONTENT)}"


def test_a_part_of_an_older_file_is_answered_with_the_whole(
    client: TestClient, stored: str
) -> None:
    response = client.get(URL, headers={"Range": "bytes=0-9", "If-Range": '"older"'} | PLAIN)
    assert response.status_code == 200
    assert response.content == CONTENT


def test_a_part_that_cannot_be_meant_is_answered_with_the_whole(
    client: TestClient, stored: str
) -> None:
    for wanted in (f"bytes={'9' * 5000}-", f"bytes=0-{'9' * 5000}", "bytes=-", "lines=0-9"):
        response = client.get(URL, headers={"Range": wanted} | PLAIN)
        assert response.status_code == 200
        assert response.content == CONTENT


def test_nothing_but_glb_files_is_given_out(client: TestClient, database: Database) -> None:
    with database.writing() as db:
        source = blobs.put(db, b"HIERARCHY of a person", blobs.BVH)
        db.commit()
    assert client.get(f"/media/{source}.glb").status_code == 404
    assert client.get(f"/media/{'0' * 64}.glb").status_code == 404
    assert client.get("/media/../../etc/passwd.glb").status_code in (404, 422)
