"""What recipes are made of: operations with their schemas, presets, poses from any frame."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import jsonschema
import numpy as np
import pytest

from motion.editing.posture import capture_pose
from motion.procedural.stances import STANCES
from motion.recipe import OPERATIONS, PRESETS, Recipe
from tests.app.conftest import Researching
from tests.support.motions import walk

SOURCE = walk().content_hash
POSES = "/api/v1/poses"


@pytest.fixture
def author(signed_in: Researching, samples_made: int) -> Researching:
    return signed_in


def captured(author: Researching, frame: int = 3, name: str = "mid stride") -> dict:
    response = author.post(POSES, json={"clip": SOURCE, "frame": frame, "name": name})
    assert response.status_code == 201, response.text
    return response.json()


def test_every_operation_is_listed_with_a_schema_that_its_defaults_satisfy(
    author: Researching,
) -> None:
    listed = author.get("/api/v1/operations").json()["operations"]
    assert [operation["name"] for operation in listed] == list(OPERATIONS)
    for operation in listed:
        schema = operation["parameters"]
        jsonschema.Draft202012Validator.check_schema(schema)
        for member in schema["properties"].values():
            assert member["title"]
            if member.get("default") is not None:
                jsonschema.validate(member["default"], member)
        assert author.get(f"/api/v1/operations/{operation['name']}").json() == operation


def test_an_unknown_operation_offers_one_like_it(author: Researching) -> None:
    response = author.get("/api/v1/operations/gird@1")
    assert (response.status_code, response.json()["error"]["code"]) == (404, "operation_not_found")
    assert "grid@1" in response.json()["error"]["mend"]


def test_every_preset_is_listed_with_its_recipe(author: Researching) -> None:
    listed = author.get("/api/v1/presets").json()["presets"]
    assert [preset["name"] for preset in listed] == list(PRESETS)
    for preset in listed:
        assert Recipe.parse(preset["operations"]).hash == PRESETS[preset["name"]].operations.hash
        assert preset["axis"].split("_").count(preset["pole"]) == 1


def test_a_pose_is_captured_from_any_frame_and_used_by_its_id(author: Researching) -> None:
    pose = captured(author)
    expected = capture_pose(walk(), 3)
    assert pose["rotations"].keys() == expected.keys()
    for role, turn in expected.items():
        np.testing.assert_array_equal(pose["rotations"][role], turn)
    listed = author.get(POSES).json()["poses"]
    assert [p["id"] for p in listed] == [*STANCES, pose["id"]]
    offsets = [{"pose": pose["id"], "amount": 0.5}]
    steps = [{"operation": "posture@1", "parameters": {"offsets": offsets}}]
    made = author.post("/api/v1/clips", json={"source": SOURCE, "operations": steps})
    assert made.status_code == 201


def test_the_same_pose_is_kept_once_under_its_newer_name(author: Researching) -> None:
    first, second = captured(author), captured(author, name="renamed")
    assert first["id"] == second["id"]
    names = [p["name"] for p in author.get(POSES).json()["poses"] if not p["stance"]]
    assert names == ["renamed"]


def test_the_same_pose_at_the_same_moment_is_kept_once(author: Researching) -> None:
    with ThreadPoolExecutor(6) as pool:
        ids = {pose["id"] for pose in pool.map(lambda _: captured(author), range(6))}
    assert [p["id"] for p in author.get(POSES).json()["poses"] if not p["stance"]] == list(ids)


def test_a_frame_beyond_the_clip_is_refused(author: Researching) -> None:
    body = {"clip": SOURCE, "frame": walk().frames, "name": "late"}
    response = author.post(POSES, json=body)
    assert response.status_code == 422
    assert str(walk().frames - 1) in response.json()["error"]["mend"]


def test_a_pose_that_clips_were_made_with_stays(author: Researching) -> None:
    pose = captured(author)
    steps = [{"operation": "posture@1", "parameters": {"offsets": [{"pose": pose["id"]}]}}]
    clip = author.post("/api/v1/clips", json={"source": SOURCE, "operations": steps}).json()
    response = author.delete(f"{POSES}/{pose['id']}")
    assert (response.status_code, response.json()["error"]["code"]) == (409, "pose_in_use")
    assert author.delete(f"/api/v1/clips/{clip['id']}").status_code == 204
    assert author.delete(f"{POSES}/{pose['id']}").status_code == 204
    assert author.delete(f"{POSES}/{pose['id']}").status_code == 404


def test_the_page_of_an_edited_clip_tells_its_steps_and_leads_back(author: Researching) -> None:
    steps = [{"operation": "grid@1", "parameters": {"path": 0.4, "timing": 1.6}}]
    clip = author.post("/api/v1/clips", json={"source": SOURCE, "operations": steps}).json()
    page = author.get(clip["page_url"]).text
    assert f'href="/library/{SOURCE}"' in page
    assert f'href="/studio?clip={clip["id"]}"' in page
    assert OPERATIONS["grid@1"].title in page
    assert "Path length: 0.4" in page
    assert clip["provenance"]["recipe_hash"][:16] in page
    assert "the one that runs here" in page
    for suffix in ("bvh", "glb", "json"):
        assert f'href="/api/v1/clips/{clip["id"]}.{suffix}"' in page
