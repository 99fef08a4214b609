"""Editing over the API: the same recipe gives the same clip, faults name their place."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from sqlalchemy import func, select
from starlette.testclient import TestClient

from app.persistence import blobs, clips
from app.persistence.engine import Database
from app.persistence.models import ClipRecord, FigureRecord, GraphRecord
from app.services import edits, library
from motion.bvh import read_bvh
from motion.recipe import PRESETS, Recipe
from motion.storage import clip_from_bytes
from tests.app.conftest import Researching
from tests.support.motions import walk, walk_bvh

CLIPS = "/api/v1/clips"
GRID = {"operation": "grid@1", "parameters": {"path": 0.4, "timing": 1.6}}
HEAD_DOWN = {"operation": "posture@1", "parameters": {"offsets": [{"pose": "head_down"}]}}
STEPS = [GRID, HEAD_DOWN]
SOURCE = walk().content_hash


@pytest.fixture
def author(signed_in: Researching, samples_made: int) -> Researching:
    return signed_in


def post(author: Researching, path: str = "", **more: object):
    return author.post(f"{CLIPS}{path}", json={"source": SOURCE, **more})


def made(author: Researching, **more: object) -> dict:
    response = post(author, **({"operations": STEPS} | more))
    assert response.status_code in (200, 201), response.text
    return response.json()


def edited_count(database: Database) -> int:
    with database.reading() as db:
        query = select(func.count()).select_from(ClipRecord).where(ClipRecord.source == "edited")
        return db.scalar(query)


def test_an_edited_clip_is_the_recipe_done_to_its_source(
    author: Researching, database: Database
) -> None:
    clip = made(author, name="sad one", tags={"emotion": "sad"})
    with database.reading() as db:
        stored = clip_from_bytes(library.content(db, clips.by_id(db, clip["id"])))
    expected = Recipe.parse(STEPS).apply(walk())
    assert stored.content_hash == expected.content_hash == clip["provenance"]["content_hash"]
    assert (clip["name"], clip["tags"], clip["source"]) == ("sad one", {"emotion": "sad"}, "edited")
    assert clip["recipe_source"] == clip["variant_of"] == SOURCE


def test_the_same_recipe_is_the_same_clip_however_it_is_written(
    author: Researching, database: Database
) -> None:
    first = post(author, operations=STEPS, name="first")
    # Whole numbers, other order of keys, defaults written out: the same in canonical form.
    offset = {"amount": 1, "neutral": "neutral", "pose": "head_down"}
    grid = {"parameters": {"timing": 1.6, "path": 0.4}, "operation": "grid@1"}
    again = [grid, {"operation": "posture@1", "parameters": {"offsets": [offset]}}]
    second = post(author, operations=again, name="second")
    assert (first.status_code, second.status_code) == (201, 200)
    assert first.json()["id"] == second.json()["id"]
    assert second.json()["name"] == "first"
    assert first.headers["location"] == f"{CLIPS}/{first.json()['id']}"
    assert edited_count(database) == 1


def test_another_recipe_or_source_or_engine_is_another_clip(
    author: Researching, monkeypatch: pytest.MonkeyPatch
) -> None:
    ids = {made(author)["id"], made(author, operations=[GRID])["id"]}
    ids.add(made(author, operations=STEPS[::-1])["id"])
    listed = author.get(CLIPS).json()["clips"]
    other = next(c["id"] for c in listed if c["id"] != SOURCE and c["source"] == "sample")
    ids.add(author.post(CLIPS, json={"source": other, "operations": STEPS}).json()["id"])
    monkeypatch.setattr(edits, "engine_version", lambda: "newer")
    monkeypatch.setattr(library, "engine_version", lambda: "newer")
    ids.add(made(author)["id"])
    assert len(ids) == 5


def test_the_same_recipe_at_the_same_moment_makes_one_clip(
    author: Researching, database: Database
) -> None:
    with ThreadPoolExecutor(6) as pool:
        answers = list(pool.map(lambda _: post(author, operations=STEPS), range(6)))
    assert sorted(answer.status_code for answer in answers) == [200] * 5 + [201]
    assert len({answer.json()["id"] for answer in answers}) == 1
    assert edited_count(database) == 1


def test_two_servers_that_store_the_same_clip_store_it_once(
    author: Researching, database: Database
) -> None:
    clip_id = made(author)["id"]
    with database.writing() as db:
        record = clips.by_id(db, clip_id)
        db.expunge(record)
        record.glb_blob = blobs.put(db, b"other bits", blobs.GLB)
        assert clips.add(db, record) is False
        assert blobs.content(db, record.glb_blob) is None, "what nobody needs is not kept"
        db.commit()
    assert edited_count(database) == 1


def test_a_preset_is_its_recipe(author: Researching) -> None:
    by_name = made(author, operations=None, preset="sad")
    by_steps = made(author, operations=PRESETS["sad"].operations.to_list())
    assert by_name["id"] == by_steps["id"]
    assert by_name["name"].endswith("_sad")


def test_a_preview_is_the_clip_that_would_be_stored_and_stores_nothing(
    author: Researching, database: Database
) -> None:
    preview = post(author, "/preview", operations=STEPS)
    assert preview.headers["content-type"] == "model/gltf-binary"
    assert preview.headers["x-manner-recipe"] == Recipe.parse(STEPS).hash
    assert edited_count(database) == 0
    assert author.get(made(author)["glb_url"]).content == preview.content


def test_a_check_tells_findings_contacts_and_length(author: Researching) -> None:
    told = post(author, "/check", operations=[GRID]).json()
    assert told["frames"] == walk().frames
    assert told["duration"] == pytest.approx(walk().duration)
    for stretches in told["contacts"].values():
        assert stretches
        assert all(0 <= start <= end <= told["duration"] for start, end in stretches)
    clean = post(author, "/check", operations=[]).json()["report"]
    assert clean == {"clean": True, "findings": []}


def test_easing_off_lowers_the_recipe_until_it_is_clean(author: Researching) -> None:
    wild = [{"operation": "path_length@1", "parameters": {"gain": 3.0}}]
    assert not post(author, "/check", operations=wild).json()["report"]["clean"]
    eased = post(author, "/ease-off", operations=wild).json()
    assert eased["report"]["clean"]
    assert 0 <= eased["share"] < 1
    again = post(author, "/check", operations=eased["operations"]).json()
    assert again["report"] == eased["report"]


@pytest.mark.parametrize(
    ("steps", "path"),
    [
        ([GRID, {"operation": "grid@9"}], [1, "operation"]),
        ([{"operation": "grid@1", "parameters": {"path": 3}}], [0, "parameters", "path"]),
        ([{"operation": "grid@1", "parameters": {"way": 1}}], [0, "parameters"]),
        ([{"operation": "posture@1", "parameters": {"offsets": [{"pose": "lying"}]}}],
         [0, "parameters", "offsets", 0, "pose"]),
    ],
)  # fmt: skip
@pytest.mark.parametrize("to", ["", "/preview", "/check", "/ease-off"])
def test_a_fault_names_its_step_parameter_and_mend(
    author: Researching, database: Database, steps: list, path: list, to: str
) -> None:
    response = post(author, to, operations=steps)
    error = response.json()["error"]
    assert (response.status_code, error["code"]) == (422, "recipe_invalid")
    assert error["where"]["path"] == ["operations", *path]
    assert error["where"]["step"] == path[0] + 1
    assert error["mend"]
    assert edited_count(database) == 0


def test_what_a_recipe_refers_to_must_be_there(author: Researching) -> None:
    lost = "0" * 64
    offsets = {"offsets": [{"pose": lost}]}
    response = post(author, operations=[{"operation": "posture@1", "parameters": offsets}])
    assert response.status_code == 422
    assert lost in response.json()["error"]["message"]
    response = author.post(CLIPS, json={"source": lost, "operations": STEPS})
    assert (response.status_code, response.json()["error"]["code"]) == (404, "clip_not_found")
    response = post(author, preset="saddest")
    assert (response.status_code, response.json()["error"]["code"]) == (422, "preset_unknown")
    assert "sad" in response.json()["error"]["mend"]


def test_either_operations_or_a_preset(author: Researching) -> None:
    for body in ({}, {"operations": [], "preset": "sad"}):
        assert post(author, **body).status_code == 422


def test_a_clip_that_may_still_be_read_differently_is_not_edited(author: Researching) -> None:
    waiting = author.upload("walk.bvh", walk_bvh()).json()["clip"]["id"]
    response = author.post(CLIPS, json={"source": waiting, "operations": STEPS})
    assert (response.status_code, response.json()["error"]["code"]) == (409, "clip_to_confirm")
    assert author.post(f"{CLIPS}/{waiting}/confirm").status_code == 200
    response = author.post(CLIPS, json={"source": waiting, "operations": STEPS})
    assert response.status_code == 201


def test_a_clip_tells_what_it_is_made_of(author: Researching) -> None:
    clip = made(author)
    assert author.get(f"{CLIPS}/{clip['id']}?motion=false").json() == clip
    provenance = clip["provenance"]
    assert provenance["source"] == provenance["source_hash"] == SOURCE
    assert provenance["source_name"] == walk_name(author)
    assert provenance["recipe"] == Recipe.parse(STEPS).to_list()
    assert provenance["recipe_hash"] == Recipe.parse(STEPS).hash
    assert provenance["current_engine"] is True


def walk_name(author: Researching) -> str:
    return author.get(f"{CLIPS}/{SOURCE}?motion=false").json()["name"]


def test_an_edited_clip_can_be_edited_again(author: Researching) -> None:
    first = made(author, operations=[GRID])
    second = author.post(CLIPS, json={"source": first["id"], "operations": [HEAD_DOWN]}).json()
    assert second["provenance"]["content_hash"] == made(author)["provenance"]["content_hash"]
    assert second["id"] != made(author)["id"]


def test_a_clip_is_rebuilt_to_the_last_bit(author: Researching, database: Database) -> None:
    clip = made(author)
    rebuilt = author.post(f"{CLIPS}/{clip['id']}/rebuild").json()
    assert rebuilt == {"identical": True, "clip": clip}
    assert edited_count(database) == 1
    response = author.post(f"{CLIPS}/{SOURCE}/rebuild")
    assert (response.status_code, response.json()["error"]["code"]) == (409, "not_edited")


def test_a_newer_engine_makes_its_clip_beside_the_old_one(
    author: Researching, database: Database, monkeypatch: pytest.MonkeyPatch
) -> None:
    clip = made(author, name="mine", tags={"emotion": "sad"})
    for module in (edits, library):
        monkeypatch.setattr(module, "engine_version", lambda: "newer")
    assert not author.get(f"{CLIPS}/{clip['id']}").json()["provenance"]["current_engine"]
    rebuilt = author.post(f"{CLIPS}/{clip['id']}/rebuild").json()
    assert rebuilt["identical"] is True
    assert rebuilt["clip"]["id"] != clip["id"]
    assert rebuilt["clip"]["provenance"]["engine_version"] == "newer"
    assert (rebuilt["clip"]["name"], rebuilt["clip"]["tags"]) == ("mine", {"emotion": "sad"})
    assert edited_count(database) == 2


def test_a_clip_that_comes_out_differently_is_told(author: Researching, database: Database) -> None:
    clip = made(author)
    with database.writing() as db:
        clips.by_id(db, clip["id"]).content_hash = "0" * 64
        db.commit()
    assert author.post(f"{CLIPS}/{clip['id']}/rebuild").json()["identical"] is False


def test_the_quality_of_a_kept_clip_is_found_once_and_kept(author: Researching) -> None:
    clip = made(author)
    assert clip["quality"] is None
    told = author.get(f"{CLIPS}/{clip['id']}/quality").json()
    assert told == post(author, "/check", operations=STEPS).json()
    assert author.get(f"{CLIPS}/{clip['id']}").json()["quality"] == told["report"]


def test_a_clip_from_which_others_were_made_stays(author: Researching) -> None:
    first = made(author, operations=[GRID])
    child = author.post(CLIPS, json={"source": first["id"], "operations": [HEAD_DOWN]}).json()
    response = author.delete(f"{CLIPS}/{first['id']}")
    error = response.json()["error"]
    assert (response.status_code, error["code"]) == (409, "clip_has_edits")
    assert error["message"].startswith("1 clip was made")
    assert author.delete(f"{CLIPS}/{child['id']}").status_code == 204
    assert author.delete(f"{CLIPS}/{first['id']}").status_code == 204
    assert author.get(f"{CLIPS}/{first['id']}").status_code == 404


def test_a_clip_that_a_graph_plays_stays(author: Researching, database: Database) -> None:
    clip = made(author)
    with database.writing() as db:
        db.add(GraphRecord(name="g", definition={"clips": {"walk": clip["id"]}}))
        db.commit()
    response = author.delete(f"{CLIPS}/{clip['id']}")
    assert (response.status_code, response.json()["error"]["code"]) == (409, "clip_in_use")


def test_names_and_tags_of_an_edited_clip_change_and_its_id_stays(author: Researching) -> None:
    clip = made(author)
    url = f"{CLIPS}/{clip['id']}/label"
    told = author.put(url, json={"name": "other", "tags": {"made": "modified"}}).json()
    assert (told["id"], told["name"], told["tags"]) == (clip["id"], "other", {"made": "modified"})
    assert author.put(url, json={"name": "again"}).json()["tags"] == {"made": "modified"}
    assert author.put(f"{CLIPS}/{SOURCE}/label", json={"name": "x"}).status_code == 409


def test_no_figure_is_made_twice_for_a_skeleton(author: Researching, database: Database) -> None:
    def figures() -> int:
        with database.reading() as db:
            return db.scalar(select(func.count()).select_from(FigureRecord))

    before = figures()
    clip = made(author)
    assert figures() == before
    assert author.get(clip["figure_url"]).status_code == 200


def test_strangers_see_no_edited_clip(author: Researching) -> None:
    clip = made(author)
    stranger = author.client
    stranger.cookies.clear()
    assert clip["id"] not in {c["id"] for c in stranger.get(CLIPS).json()["clips"]}
    for suffix in ("", ".json", ".glb", ".bvh"):
        assert stranger.get(f"{CLIPS}/{clip['id']}{suffix}").status_code == 401


@pytest.mark.parametrize(
    ("method", "path"),
    [
        ("post", CLIPS), ("post", f"{CLIPS}/preview"), ("post", f"{CLIPS}/check"),
        ("post", f"{CLIPS}/ease-off"), ("post", f"{CLIPS}/0/rebuild"),
        ("get", f"{CLIPS}/0/quality"), ("put", f"{CLIPS}/0/label"),
        ("get", "/api/v1/operations"), ("get", "/api/v1/operations/grid@1"),
        ("get", "/api/v1/presets"), ("get", "/api/v1/poses"), ("post", "/api/v1/poses"),
        ("delete", "/api/v1/poses/0"),
    ],
)  # fmt: skip
def test_nothing_is_edited_without_a_key(client: TestClient, method: str, path: str) -> None:
    response = getattr(client, method)(path)
    assert (response.status_code, response.json()["error"]["code"]) == (401, "key_needed")


def test_a_motion_in_json_is_the_motion(author: Researching) -> None:
    clip = made(author)
    motion = author.get(f"{CLIPS}/{clip['id']}.json").json()["motion"]
    expected = Recipe.parse(STEPS).apply(walk())
    assert motion["names"] == list(expected.skeleton.names)
    assert motion["parents"] == expected.skeleton.parents.tolist()
    np.testing.assert_array_equal(motion["offsets"], expected.skeleton.offsets)
    np.testing.assert_array_equal(motion["root_positions"], expected.root_positions)
    np.testing.assert_array_equal(motion["rotations"], expected.rotations)
    assert motion["frame_time"] == expected.frame_time


def test_an_edited_clip_goes_home_as_bvh(author: Researching) -> None:
    clip = made(author)
    response = author.get(f"{CLIPS}/{clip['id']}.bvh")
    assert read_bvh(response.content).values.shape[0] == clip["frames"]
    assert clip["name"] in response.headers["content-disposition"]


def test_an_example_must_not_leave_before_the_clip_that_follows_it(author: Researching) -> None:
    example = made(author, operations=[GRID])
    fourier = {"operation": "fourier@1", "parameters": {"clip": example["id"], "amount": 0.5}}
    made(author, operations=[fourier])
    response = author.delete(f"{CLIPS}/{example['id']}")
    assert response.json()["error"]["code"] == "clip_has_edits"


def test_the_recipe_of_a_clip_reads_back_as_it_was_sent(author: Researching) -> None:
    text = json.dumps(made(author)["provenance"]["recipe"])
    assert made(author, operations=json.loads(text))["id"] == made(author)["id"]
