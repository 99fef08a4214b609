"""The library over the API: who sees what, searching, taking files home."""

from __future__ import annotations

import pytest
from starlette.testclient import TestClient

from app.persistence.engine import Database
from app.services import rendering, samples
from motion.bvh import read_bvh
from tests.app.conftest import Researching, built_once
from tests.support.motions import walk, walk_bvh, walks


def listed(client: TestClient, **query: object) -> list[str]:
    response = client.get("/api/v1/clips", params=query)
    assert response.status_code == 200
    return [clip["name"] for clip in response.json()["clips"]]


def test_an_empty_library_is_an_empty_list(client: TestClient) -> None:
    assert listed(client) == []


def test_everybody_sees_the_samples(client: TestClient, samples_made: int) -> None:
    assert listed(client) == sorted(sample.name for sample in walks())
    assert samples_made == len(walks())


def test_a_clip_says_what_the_viewer_needs(client: TestClient, samples_made: int) -> None:
    clip = client.get("/api/v1/clips").json()["clips"][0]
    known = {sample.name: sample.clip for sample in walks()}[clip["name"]]
    assert clip["id"] == known.content_hash
    assert clip["frames"] == known.frames
    assert clip["duration"] == pytest.approx(known.duration)
    assert clip["cyclic"] is True
    assert 0 <= clip["poster_time"] <= clip["duration"]
    assert 1.4 < clip["stature"] < 2.0
    assert client.get(clip["glb_url"]).content.startswith(b"glTF")
    assert client.get(clip["figure_url"]).content.startswith(b"glTF")
    assert clip["page_url"] == f"/library/{clip['id']}"


def test_words_and_tags_narrow_the_list(client: TestClient, samples_made: int) -> None:
    name = walks()[1].name
    style = walks()[1].tags["style"]
    assert listed(client, query=style.upper()) == [name]
    assert listed(client, tag=f"style:{style}") == [name]
    assert listed(client, tag=[style, "set:A"]) == [name]
    assert listed(client, tag=[style, "set:B"]) == []
    assert listed(client, query=f"{style} nothing") == []


def test_the_list_takes_as_many_queries_for_many_clips_as_for_few(
    client: TestClient, database: Database
) -> None:
    from sqlalchemy import event

    counts: list[int] = []
    for few in (walks()[:1], walks()):
        samples.make(database, lambda few=few: few)
        statements: list[str] = []
        hear = lambda *args, to=statements: to.append(args[2])  # noqa: E731
        event.listen(database.engine, "before_cursor_execute", hear)
        listed(client)
        event.remove(database.engine, "before_cursor_execute", hear)
        counts.append(sum("FROM clips" in statement for statement in statements))
    assert counts[0] == counts[1] > 0


def test_imported_clips_are_hidden_from_strangers(signed_in: Researching) -> None:
    clip = signed_in.upload("walk.bvh", walk_bvh()).json()["clip"]
    stranger = signed_in.client
    assert listed(stranger) == ["walk"]
    stranger.cookies.clear()
    assert listed(stranger) == []
    for clip_id in (clip["id"], "0" * 64):  # a stranger cannot tell the two apart
        for path in ("", ".json", ".bvh", ".glb"):
            response = stranger.get(f"/api/v1/clips/{clip_id}{path}")
            assert response.status_code == 401
            assert response.json()["error"]["code"] == "key_needed"
        page = stranger.get(f"/library/{clip_id}", follow_redirects=False)
        assert (page.status_code, page.headers["location"][:17]) == (303, "/research/sign-in")


def test_a_clip_is_taken_home_as_bvh(client: TestClient, samples_made: int) -> None:
    sample = walks()[0]
    response = client.get(f"/api/v1/clips/{sample.clip.content_hash}.bvh")
    assert sample.name in response.headers["content-disposition"]
    assert read_bvh(response.content).values.shape[0] == sample.clip.frames


def test_a_clip_is_taken_home_as_glb_with_its_figure(client: TestClient, samples_made: int) -> None:
    response = client.get(f"/api/v1/clips/{walk().content_hash}.glb")
    bare = client.get("/api/v1/clips").json()["clips"]
    url = next(clip["glb_url"] for clip in bare if clip["id"] == walk().content_hash)
    assert response.headers["content-type"] == "model/gltf-binary"
    assert b'"skins"' in response.content
    assert b'"animations"' in response.content
    assert b'"skins"' not in client.get(url).content


def test_the_figure_of_a_skeleton_is_built_once_for_all_its_downloads(
    client: TestClient, samples_made: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    built = []
    monkeypatch.setattr(rendering, "_figures", {})
    monkeypatch.setattr(rendering, "build_figure", lambda clip: built.append(clip) or mesh)
    mesh = built_once(walk())
    same = [w.clip for w in walks() if w.clip.skeleton.content_hash == mesh.skeleton.content_hash]
    assert len(same) > 1
    for clip in same:
        response = client.get(f"/api/v1/clips/{clip.content_hash}.glb")
        assert b'"skins"' in response.content
    assert len(built) == 1


def test_samples_cannot_be_deleted(signed_in: Researching, samples_made: int) -> None:
    response = signed_in.delete(f"/api/v1/clips/{walk().content_hash}")
    assert response.status_code == 409
    assert response.json()["error"]["code"] == "sample_clip"


@pytest.mark.parametrize(
    ("method", "path"),
    [
        ("post", "/api/v1/clips/0/confirm"),
        ("delete", "/api/v1/clips/0"),
        ("patch", "/api/v1/clips/0"),
        ("post", "/api/v1/imports"),
    ],
)
def test_writing_needs_a_key_or_a_signed_in_researcher(
    client: TestClient, method: str, path: str
) -> None:
    more = {
        "patch": {"json": {}},
        "post": {"files": {"file": ("a.bvh", b"")}} if path.endswith("imports") else {},
    }
    response = getattr(client, method)(path, **more.get(method, {}))
    assert response.status_code == 401
    assert response.json()["error"]["code"] == "key_needed"
