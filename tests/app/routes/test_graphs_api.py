"""Motion graphs over the API: the sample, graphs of one's own, walking through them."""

from __future__ import annotations

import base64
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from starlette.testclient import TestClient

from app.persistence.engine import Database
from app.services import samples
from motion.procedural.library import SampleClip, steered
from motion.rotations import angle_between
from tests.app.conftest import Researching
from tests.support.motions import walk, walk_bvh, walks

GRAPHS = "/api/v1/graphs"


def clips() -> Iterator[SampleClip]:
    yield from steered()
    yield walks()[0]


@pytest.fixture
def author(signed_in: Researching, database: Database) -> Researching:
    """A signed-in researcher at a server with the graph's clips and one of another rate."""
    samples.make(database, clips)
    return signed_in


def clip_ids(author: Researching) -> dict[str, str]:
    return {c["name"]: c["id"] for c in author.get("/api/v1/clips").json()["clips"]}


def walker(author: Researching, **more: Any) -> dict[str, Any]:
    """A small graph to be kept."""
    ids = clip_ids(author)
    return {"name": "Walker", "clips": {n: ids[n] for n in ("stand", "walk")}, **more}


def numbers(piece: dict[str, Any]) -> tuple[np.ndarray, np.ndarray]:
    """Root positions (n, 3) and rotations (n, J, 4), xyzw."""
    flat = np.frombuffer(base64.b64decode(piece["motion"]), "<f4")
    rows = flat.reshape(piece["frames"], 3 + 4 * piece["joints"])
    return rows[:, :3], rows[:, 3:].reshape(piece["frames"], piece["joints"], 4)


def refusal(response: Any) -> tuple[int, str]:
    return response.status_code, response.json()["error"]["code"]


def test_without_samples_there_is_no_graph(signed_in: Researching) -> None:
    assert signed_in.get(GRAPHS).json() == {"graphs": []}
    assert refusal(signed_in.get(f"{GRAPHS}/sample")) == (404, "graph_not_found")


def test_the_sample_graph_comes_with_the_sample_library(author: Researching) -> None:
    (view,) = author.get(GRAPHS).json()["graphs"]
    assert (view["id"], view["kind"]) == ("sample", "sample")
    assert view["clips"] == ["stand", "walk", "turn_left", "turn_right"]
    detail = author.get(f"{GRAPHS}/sample").json()
    assert [member["name"] for member in detail["members"]] == view["clips"]
    assert author.get(detail["members"][0]["glb_url"]).content.startswith(b"glTF")
    pairs = {(t["source"], t["target"]) for t in detail["transitions"]}
    assert {("stand", "walk"), ("walk", "turn_left"), ("turn_right", "stand")} <= pairs
    assert all(t["distance"] < detail["threshold"] for t in detail["transitions"])


def test_the_sample_graph_stays_as_it_is(author: Researching) -> None:
    assert refusal(author.put(f"{GRAPHS}/sample", json=walker(author))) == (409, "sample_graph")
    assert refusal(author.delete(f"{GRAPHS}/sample")) == (409, "sample_graph")


def test_a_graph_is_kept_changed_and_deleted(author: Researching) -> None:
    response = author.post(GRAPHS, json=walker(author))
    made = response.json()
    assert response.status_code == 201
    assert response.headers["Location"] == f"{GRAPHS}/{made['id']}"
    assert author.get(response.headers["Location"]).json() == made
    assert [graph["name"] for graph in author.get(GRAPHS).json()["graphs"]][1:] == ["Walker"]
    gone = {
        k: made["transitions"][3][k] for k in ("source", "source_frame", "target", "target_frame")
    }
    new = {"source": "walk", "source_frame": 123, "target": "walk", "target_frame": 61}
    changed = author.put(
        f"{GRAPHS}/{made['id']}", json=walker(author, name="Other", removed=[gone], added=[new])
    ).json()
    assert changed["name"] == "Other"
    keys = [{k: t[k] for k in new} for t in changed["transitions"]]
    assert gone not in keys
    assert [key for key, t in zip(keys, changed["transitions"], strict=True) if t["added"]] == [new]
    assert author.get(f"{GRAPHS}/{made['id']}").json() == changed
    assert author.delete(f"{GRAPHS}/{made['id']}").status_code == 204
    assert refusal(author.get(f"{GRAPHS}/{made['id']}")) == (404, "graph_not_found")
    assert refusal(author.get(f"{GRAPHS}/no-such-graph")) == (404, "graph_not_found")


def test_the_threshold_decides_on_the_number_of_transitions(author: Researching) -> None:
    shape = {key: value for key, value in walker(author).items() if key != "name"}
    counts = [
        len(author.post(f"{GRAPHS}/preview", json={**shape, "threshold": t}).json()["transitions"])
        for t in (0.03, 0.07, 0.12)
    ]
    assert 0 < counts[0] < counts[1] < counts[2]
    fades = [
        author.post(f"{GRAPHS}/preview", json={**shape, "fade": f}).json()["fade_frames"]
        for f in (0.2, 0.5)
    ]
    assert fades == [12, 30]
    assert len(author.get(GRAPHS).json()["graphs"]) == 1, "nothing is stored"


def test_clips_that_do_not_belong_together_are_named(author: Researching) -> None:
    uploaded = author.upload("other.bvh", _bvh_at_other_rate()).json()["clip"]["id"]
    wrong = walker(author)
    wrong["clips"]["other"] = uploaded
    response = author.post(GRAPHS, json=wrong)
    assert refusal(response) == (422, "graph_unusable")
    assert "“other” and “stand” have different skeletons" in response.json()["error"]["message"]
    missing = walker(author)
    missing["clips"]["gone"] = "0" * 64
    assert refusal(author.post(GRAPHS, json=missing)) == (422, "clip_not_found")
    nowhere = {"source": "walk", "source_frame": 100_000, "target": "walk", "target_frame": 0}
    assert refusal(author.post(GRAPHS, json=walker(author, added=[nowhere]))) == (
        422,
        "graph_unusable",
    )
    assert len(author.get(GRAPHS).json()["graphs"]) == 1, "nothing half done is kept"


def test_a_graph_takes_no_clip_that_may_still_be_read_differently(author: Researching) -> None:
    clip = author.upload("walk.bvh", walk_bvh()).json()["clip"]["id"]
    wanted = {"name": "Waiting", "clips": {"walk": clip}}
    assert refusal(author.post(GRAPHS, json=wanted)) == (409, "clip_to_confirm")
    assert author.post(f"/api/v1/clips/{clip}/confirm").status_code == 200
    assert author.post(GRAPHS, json=wanted).status_code == 201


def test_a_graph_of_a_clip_that_was_just_deleted_is_not_kept(author: Researching) -> None:
    wanted = walker(author)
    slower = [{"operation": "tempo@1", "parameters": {"factor": 0.9}}]
    edit = {"source": wanted["clips"]["walk"], "operations": slower}
    clip = author.post("/api/v1/clips", json=edit).json()["id"]
    wanted["clips"]["slower"] = clip
    shape = {key: value for key, value in wanted.items() if key != "name"}
    assert author.post(f"{GRAPHS}/preview", json=shape).status_code == 200
    assert author.delete(f"/api/v1/clips/{clip}").status_code == 204
    # The worker still knows the clip, so only the database can tell.
    assert refusal(author.post(GRAPHS, json=wanted)) == (422, "clip_not_found")
    assert [graph["kind"] for graph in author.get(GRAPHS).json()["graphs"]] == ["sample"]


def test_a_steered_walk_comes_in_pieces_that_fit(author: Researching) -> None:
    """Stand, walk, turn, stand again, quietly after a while: sent as a browser sends it."""
    place: dict[str, Any] = {"clip": "stand"}
    roots, rotations, seen = [], [], set()
    script = [("walk", {})] * 8 + [("turn_left", {"path": 0.4, "timing": 1.6})] * 8
    script += [("turn_right", {"postures": {"head_down": 0.7}})] * 8 + [("stand", {})] * 16
    for target, manner in script:
        wanted = {"place": place, "target": target, "manner": manner, "frames": 18}
        response = author.post(f"{GRAPHS}/sample/play", json=wanted)
        assert response.status_code == 200, response.text
        piece = response.json()
        place = piece["after"]
        seen.add(place["clip"])
        root, turned = numbers(piece)
        roots.append(root)
        rotations.append(turned)
    assert seen == {"stand", "walk", "turn_left", "turn_right"}
    assert place["clip"] == "stand"
    assert piece["reaches"] == 0
    turned = np.concatenate(rotations).astype(float)[..., [3, 0, 1, 2]]
    assert np.degrees(angle_between(turned[1:], turned[:-1])).max() <= 15.0
    way = np.diff(np.concatenate(roots), axis=0)
    assert np.linalg.norm(way, axis=1).max() < 0.05
    assert np.linalg.norm(np.concatenate(roots)[-1, [0, 2]]) > 1.0


def test_a_chosen_transition_is_taken(author: Researching) -> None:
    chosen = next(
        t
        for t in author.get(f"{GRAPHS}/sample").json()["transitions"]
        if (t["source"], t["target"]) == ("turn_left", "turn_right")
    )
    key = {k: chosen[k] for k in ("source", "source_frame", "target", "target_frame")}
    place = {"clip": "turn_left", "frame": max(0, chosen["source_frame"] - 10)}
    taken = None
    while taken is None:
        piece = author.post(
            f"{GRAPHS}/sample/play", json={"place": place, "target": "walk", "via": key}
        ).json()
        place, taken = piece["after"], piece["taken"]
    assert taken == key
    assert (place["clip"], piece["blended"]) == ("turn_right", True)


@pytest.mark.parametrize(
    ("wanted", "code"),
    [
        ({"place": {"clip": "swim"}, "target": "walk"}, "no_such_place"),
        ({"place": {"clip": "walk", "frame": 99_999}, "target": "walk"}, "no_such_place"),
        ({"place": {"clip": "walk"}, "target": "swim"}, "graph_unusable"),
        (
            {"place": {"clip": "walk"}, "target": "walk", "manner": {"postures": {"proud": 1}}},
            "graph_unusable",
        ),
        ({"place": {"clip": "walk"}, "target": "walk", "manner": {"path": 3}}, "invalid_request"),
        ({"place": {"clip": "walk", "x": "far"}, "target": "walk"}, "invalid_request"),
        ({"place": {"clip": "walk", "x": 1e300}, "target": "walk"}, "invalid_request"),
    ],
)
def test_what_cannot_be_played_is_said(author: Researching, wanted: dict, code: str) -> None:
    assert refusal(author.post(f"{GRAPHS}/sample/play", json=wanted)) == (422, code)


def test_strangers_see_no_graphs(author: Researching) -> None:
    stranger: TestClient = author.client
    stranger.cookies.clear()
    assert refusal(stranger.get(GRAPHS)) == (401, "key_needed")
    assert refusal(stranger.get(f"{GRAPHS}/sample")) == (401, "key_needed")
    play = {"place": {"clip": "stand"}, "target": "walk"}
    assert stranger.post(f"{GRAPHS}/sample/play", json=play).status_code == 401
    assert stranger.delete(f"{GRAPHS}/sample").status_code == 401
    page = stranger.get("/graphs")
    assert (page.status_code, page.headers["Location"]) == (303, "/research/sign-in?next=/graphs")


def test_the_pages_name_the_graph(author: Researching) -> None:
    assert "Graphs" in author.get("/graphs").text
    assert "Stand, walk and turn" in author.get("/graphs/sample").text
    assert author.get("/graphs/nothing").status_code == 404


def _bvh_at_other_rate() -> bytes:
    from motion.bvh_write import write_bvh

    return write_bvh(walk()).replace(b"Frame Time: 0.0166", b"Frame Time: 0.0333")
