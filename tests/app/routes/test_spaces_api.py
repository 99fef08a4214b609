"""Authoring spaces over the API: points to weights, weights to motion, points to recipes."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np
import pytest

from app.persistence.engine import Database
from app.services import library, samples, space_samples
from app.services.spaces import SAMPLES
from motion.procedural.library import set_a
from motion.storage import clip_from_bytes
from tests.app.conftest import Researching
from tests.app.services.test_matching import published, study_of
from tests.support.motions import walk_bvh

SPACES = "/api/v1/spaces"


@pytest.fixture
def author(signed_in: Researching, samples_made: int) -> Researching:
    """A signed-in researcher at a server with three walks."""
    return signed_in


def walks(author: Researching) -> list[dict[str, Any]]:
    return author.get("/api/v1/clips").json()["clips"]


def made(author: Researching, name: str = "Three walks", **more: Any) -> dict[str, Any]:
    body = {"name": name, "clips": [clip["id"] for clip in walks(author)], **more}
    response = author.post(SPACES, json=body)
    assert response.status_code == 201, response.text
    return response.json()


def middle(space: dict[str, Any]) -> dict[str, Any]:
    """The point half-way along every primary slider of motion features."""
    names = [one["id"] for one in space["definition"]["features"]["primary"]]
    return {"interface": "features", "values": dict.fromkeys(names, 0.5)}


def asked(author: Researching, space: dict[str, Any], what: str, point: Any) -> Any:
    return author.post(f"{SPACES}/{space['id']}/{what}", json=point)


def refusal(response: Any) -> tuple[int, str]:
    return response.status_code, response.json()["error"]["code"]


def animation(glb: bytes) -> tuple[np.ndarray, np.ndarray]:
    """The root's way (T, 3) and the joints' rotations (J, T, 4) of a clip's GLB file."""
    size = struct.unpack_from("<I", glb, 12)[0]
    document, data = json.loads(glb[20 : 20 + size]), glb[28 + size :]

    def numbers(index: int, kind: str, width: int) -> np.ndarray:
        accessor = document["accessors"][index]
        start = document["bufferViews"][accessor["bufferView"]]["byteOffset"]
        start += accessor.get("byteOffset", 0)
        count = accessor["count"] * width
        return np.frombuffer(data, kind, count, start).reshape(-1, width)

    root, *turns = document["animations"][0]["samplers"]
    rotations = [numbers(turn["output"], "<i2", 4) for turn in turns]
    return numbers(root["output"], "<f4", 3), np.array(rotations)


def test_a_space_of_clips_has_the_features_as_sliders(author: Researching) -> None:
    space = made(author)
    assert author.get(f"{SPACES}/{space['id']}").json() == space
    (listed,) = author.get(SPACES).json()["spaces"]
    assert (listed.pop("study_title"), listed.pop("may_delete")) == (None, True)
    assert listed == {key: space[key] for key in listed}
    assert space["interfaces"] == ["features", "weights"]
    assert (space["made_by"], space["study"], space["simulated"]) == ("Rosa", None, False)
    sliders = space["definition"]["features"]
    assert (len(sliders["primary"]), len(sliders["parameters"])) == (4, 51)
    members = [name for one in sliders["primary"] for name in one["members"]]
    assert sorted(members) == sorted(one["id"] for one in sliders["parameters"])
    for one in sliders["primary"] + sliders["parameters"]:
        assert (min(one["values"]), max(one["values"])) in [(0.0, 1.0), (0.5, 0.5)]
    assert [clip["name"] for clip in space["clips"]] == [clip["name"] for clip in walks(author)]


def test_the_same_space_again_is_the_same_and_another_gets_the_next_number(
    author: Researching,
) -> None:
    first, again = made(author), made(author)
    assert first == again
    clips = [clip["id"] for clip in walks(author)][:2]
    second = made(author, clips=clips)
    other = made(author, "Other", clips=clips)
    numbers = {s["id"]: (s["number"], s["newest"]) for s in author.get(SPACES).json()["spaces"]}
    assert numbers == {
        first["id"]: (1, False),
        second["id"]: (2, True),
        other["id"]: (1, True),
    }


def test_at_an_example_it_weighs_everything(author: Researching) -> None:
    space = made(author)
    sliders = space["definition"]["features"]["primary"]
    for place in range(3):
        values = {one["id"]: one["values"][place] for one in sliders}
        weighed = asked(author, space, "weights", {"interface": "features", "values": values})
        assert weighed.json()["weights"] == [float(place == n) for n in range(3)]
        assert weighed.json()["outside"] == 0.0


def test_bare_weights_are_brought_to_a_sum_of_one(author: Researching) -> None:
    space = made(author)
    ids = [example["clip"] for example in space["definition"]["examples"]]
    point = {"interface": "weights", "values": {ids[0]: 0.5, ids[2]: 0.25}}
    assert asked(author, space, "weights", point).json() == {
        "weights": [0.666667, 0.0, 0.333333],
        "outside": 0.0,
        "notes": [],
    }


def test_what_a_point_cannot_mean_is_told_with_the_mend(author: Researching) -> None:
    space = made(author)
    ids = [example["clip"] for example in space["definition"]["examples"]]
    nothing = {"interface": "weights", "values": {ids[0]: 0.0}}
    assert refusal(asked(author, space, "weights", nothing)) == (422, "nothing_weighs")
    nobody = {"interface": "adjectives", "values": {"quickness": 0.5}}
    assert refusal(asked(author, space, "motion", nobody)) == (422, "no_adjectives")
    misspelt = {"interface": "features", "values": {"step_lenght": 0.5}}
    answer = asked(author, space, "recipe", misspelt)
    assert refusal(answer) == (422, "slider_unknown")
    assert "step_length" in answer.json()["error"]["mend"]
    stranger = {"interface": "weights", "values": {"0" * 64: 0.5}}
    assert refusal(asked(author, space, "weights", stranger)) == (422, "slider_unknown")
    assert refusal(author.get(f"{SPACES}/{'0' * 64}")) == (404, "space_not_found")


def test_the_clip_that_a_recipe_makes_is_the_motion_that_was_shown(
    author: Researching, database: Database
) -> None:
    space = made(author)
    for point in (
        middle(space),
        {"interface": "features", "values": {"step_length": 0.8}},
        {"interface": "weights", "values": {space["clips"][1]["clip"]: 0.3,
                                            space["clips"][2]["clip"]: 0.9}},
    ):  # fmt: skip
        shown = asked(author, space, "motion", point)
        assert shown.headers["content-type"] == "model/gltf-binary"
        weights = [float(w) for w in shown.headers["manner-weights"].split(",")]
        recipe = asked(author, space, "recipe", point).json()
        assert weights == [round(weight, 4) for weight in recipe["weights"]]
        assert float(shown.headers["manner-outside"]) == round(recipe["outside"], 4)
        wanted = {"source": recipe["source"], "operations": recipe["operations"]}
        clip = author.post("/api/v1/clips", json=wanted)
        assert clip.status_code == 201, clip.text
        with database.reading() as db:
            record = library.find(db, clip.json()["id"], signed_in=True)
            kept = clip_from_bytes(library.content(db, record))
        root, rotations = animation(shown.content)
        np.testing.assert_allclose(root, kept.root_positions, atol=1e-6)
        kept_root, kept_rotations = animation(
            author.get(f"/api/v1/clips/{clip.json()['id']}.glb?figure=false").content
        )
        np.testing.assert_array_equal(root, kept_root)
        np.testing.assert_array_equal(rotations, kept_rotations)
        assert author.get(f"/api/v1/clips/{clip.json()['id']}.bvh").status_code == 200
    page = author.get(clip.json()["page_url"]).text
    assert "A mix of 2 examples" in page
    for example in space["clips"][1:3]:
        assert f"Clip: {example['name']}, Weight: 0." in page
    assert "Keytimes: Left strike: " in page


def test_a_recipe_needs_no_space_and_names_what_weighs_only(author: Researching) -> None:
    space = made(author)
    ids = [example["clip"] for example in space["definition"]["examples"]]
    point = {"interface": "weights", "values": {ids[1]: 1, ids[2]: 0.000_000_1}}
    recipe = asked(author, space, "recipe", point).json()
    (step,) = recipe["operations"]
    assert step["operation"] == "blend@1"
    (example,) = step["parameters"]["examples"]
    assert (recipe["source"], example["clip"], example["weight"]) == (ids[0], ids[1], 1.0)
    assert example["keytimes"] == space["definition"]["examples"][1]["keytimes"]


def test_clips_of_other_skeletons_are_named_with_the_mend(author: Researching) -> None:
    uploaded = author.upload("stranger.bvh", walk_bvh()).json()["clip"]["id"]
    author.post(f"/api/v1/clips/{uploaded}/confirm")
    clips = [clip["id"] for clip in walks(author) if clip["id"] != uploaded]
    answer = author.post(SPACES, json={"name": "Mixed", "clips": [*clips, uploaded]})
    assert refusal(answer) == (422, "skeletons_differ")
    error = answer.json()["error"]
    assert error["where"] == {"field": "clips", "clips": [uploaded], "onto": clips[0]}
    assert "“stranger”" in error["message"]
    assert "retarget@1" in error["mend"]
    assert author.get(SPACES).json() == {"spaces": []}


def test_only_some_cycles_are_named_with_the_mend(author: Researching) -> None:
    first, second, third = (clip["id"] for clip in walks(author))
    cut = {"source": third, "operations": [{"operation": "cut@1", "parameters": {"end": 0.5}}]}
    piece = author.post("/api/v1/clips", json={**cut, "name": "piece"}).json()["id"]
    answer = author.post(SPACES, json={"name": "Mixed", "clips": [first, second, piece]})
    assert refusal(answer) == (422, "cycles_differ")
    assert "“piece”" in answer.json()["error"]["message"]
    assert "cycle@1" in answer.json()["error"]["mend"]


def test_a_clip_is_given_once_and_keytimes_of_the_spaces_own_clips(author: Researching) -> None:
    first, second, third = (clip["id"] for clip in walks(author))

    def told(clips: list[str], keytimes: Any) -> tuple[int, str]:
        body = {"name": "Wrong", "clips": clips, "keytimes": keytimes}
        return refusal(author.post(SPACES, json=body))

    assert told([first, first], {}) == (422, "clip_twice")
    assert told([first, second], {third: {}}) == (422, "keytimes_unknown")
    assert told([first, second], {first: {"left_strike": 100}}) == (422, "keytime_outside")
    assert told([first, second], {first: {"hop": 0.1}}) == (422, "keytime_unknown")
    assert told([first, "0" * 64], {}) == (404, "clip_not_found")


def test_keytimes_of_a_clip_are_those_that_a_space_finds(author: Researching) -> None:
    space = made(author)
    for example in space["definition"]["examples"]:
        found = author.get(f"/api/v1/clips/{example['clip']}/keytimes").json()["keytimes"]
        assert found == example["keytimes"]
        assert set(found) == {"left_strike", "left_off", "right_strike", "right_off"}
    assert refusal(author.get(f"/api/v1/clips/{'0' * 64}/keytimes")) == (404, "clip_not_found")


def test_a_new_version_holds_other_keytimes_and_leaves_the_old_one(author: Researching) -> None:
    space = made(author)
    example = space["definition"]["examples"][0]
    moved = {event: round(time * 0.9 + 0.01, 6) for event, time in example["keytimes"].items()}
    url = f"{SPACES}/{space['id']}/versions"
    response = author.post(url, json={"keytimes": {example["clip"]: moved}})
    assert response.status_code == 201, response.text
    version = response.json()
    assert response.headers["Location"] == f"{SPACES}/{version['id']}"
    assert (version["name"], version["number"]) == (space["name"], 2)
    assert version["definition"]["examples"][0]["keytimes"] == moved
    assert version["definition"]["examples"][1:] == space["definition"]["examples"][1:]
    assert version["definition"]["origin"]["before"] == space["id"]
    before = author.get(f"{SPACES}/{space['id']}").json()
    assert before["definition"] == space["definition"]
    assert refusal(author.post(url, json={})) == (422, "nothing_changes")
    same = {"keytimes": {example["clip"]: example["keytimes"]}}
    assert refusal(author.post(url, json=same)) == (422, "nothing_changes")


def test_no_more_clips_join_than_a_space_takes(author: Researching) -> None:
    space = made(author)
    others = [f"{number:064x}" for number in range(62)]
    response = author.post(f"{SPACES}/{space['id']}/versions", json={"join": others})
    assert refusal(response) == (422, "space_too_large")
    assert response.json()["error"]["mend"] == "Join 61 clips at most."


def test_a_clip_of_a_space_can_be_deleted_once_the_space_is(author: Researching) -> None:
    first = walks(author)[0]["id"]
    tempo = [{"operation": "tempo@1", "parameters": {"factor": 1.1}}]
    edited = author.post("/api/v1/clips", json={"source": first, "operations": tempo}).json()["id"]
    space = made(author, clips=[first, edited])
    answer = author.delete(f"/api/v1/clips/{edited}")
    assert refusal(answer) == (409, "clip_in_use")
    told = answer.json()["error"]
    assert told["message"] == ("The authoring space “Three walks”, version 1, blends this clip.")
    assert told["spaces"] == [space["id"]]
    assert author.delete(f"{SPACES}/{space['id']}").status_code == 204
    assert author.delete(f"/api/v1/clips/{edited}").status_code == 204


def test_a_deleted_space_is_gone_and_what_was_made_in_it_stays(author: Researching) -> None:
    space = made(author)
    point = middle(space)
    assert asked(author, space, "motion", point).status_code == 200  # and it is kept ready
    recipe = asked(author, space, "recipe", point).json()
    wanted = {"source": recipe["source"], "operations": recipe["operations"]}
    clip = author.post("/api/v1/clips", json=wanted).json()["id"]
    assert author.delete(f"{SPACES}/{space['id']}").status_code == 204
    assert author.get(SPACES).json() == {"spaces": []}
    for what in ("weights", "motion", "recipe", "targets"):
        body = {} if what == "targets" else point
        assert refusal(asked(author, space, what, body)) == (404, "space_not_found"), what
    for answer in (author.get(f"{SPACES}/{space['id']}"), author.delete(f"{SPACES}/{space['id']}")):
        assert refusal(answer) == (404, "space_not_found")
    assert author.get(f"/api/v1/clips/{clip}.bvh").status_code == 200
    assert len(walks(author)) == 4


def test_a_published_study_keeps_the_version_that_its_stimuli_were_made_in(
    author: Researching,
) -> None:
    space = made(author)
    slug = published(author, study_of(space))
    (part,) = author.get(f"/api/v1/studies/{slug}").json()["definition"]["parts"]
    named = [part["task"]["space"], *(one["made"]["space"] for one in part["stimuli"])]
    assert named == [space["id"]] * 3
    newer = made(author, clips=[clip["id"] for clip in walks(author)][:2])
    answer = author.delete(f"{SPACES}/{space['id']}")
    assert refusal(answer) == (409, "space_in_use")
    assert answer.json()["error"]["where"] == {"studies": [slug]}
    assert author.delete(f"{SPACES}/{newer['id']}").status_code == 204


def test_pages_of_spaces_show_to_the_signed_in(author: Researching) -> None:
    space = made(author)
    assert author.get("/studio/spaces").status_code == 200
    assert space["id"] in author.get(f"/studio/spaces/{space['id']}").text
    assert author.get(f"/studio/spaces/{'0' * 64}").status_code == 404


def test_a_clip_that_nobody_judged_joins_a_space_of_adjectives(
    signed_in: Researching, database: Database
) -> None:
    samples.make(database, set_a)
    space_samples.make(database)
    (space,) = signed_in.get(SPACES).json()["spaces"]
    assert (space["name"], space["simulated"]) == (SAMPLES["set_a"], True)
    assert space["interfaces"] == ["adjectives", "features", "weights"]
    before = signed_in.get(f"{SPACES}/{space['id']}").json()["definition"]
    quicker = {"source": before["examples"][0]["clip"],
               "operations": [{"operation": "tempo@1", "parameters": {"factor": 1.3}}]}  # fmt: skip
    new = signed_in.post("/api/v1/clips", json=quicker).json()["id"]
    told = signed_in.get(f"{SPACES}/{space['id']}/predictions/{new}").json()
    assert told["can_join"], told["sentence"]
    kept = [row["id"] for row in told["parameters"] if not row["refused"]]
    version = signed_in.post(f"{SPACES}/{space['id']}/versions", json={"join": [new]}).json()
    after = version["definition"]
    assert after["examples"][-1]["clip"] == new
    assert after["examples"][-1]["predicted"]
    assert [one["id"] for one in after["adjectives"]["parameters"]] == kept
    values = {row["id"]: row["value"] for row in told["parameters"]}
    for one in after["adjectives"]["parameters"]:
        assert one["values"][-1] == round(values[one["id"]], 6)
    again = signed_in.post(f"{SPACES}/{version['id']}/versions", json={"join": [new]})
    assert refusal(again) == (422, "clip_twice")


def test_targets_over_the_api_are_recipes_that_make_clips(
    signed_in: Researching, database: Database
) -> None:
    samples.make(database, set_a)
    space_samples.make(database)
    (space,) = signed_in.get(SPACES).json()["spaces"]
    url = f"{SPACES}/{space['id']}/targets"
    targets = signed_in.post(url, json={"count": 2, "seed": 7}).json()["targets"]
    assert targets == signed_in.post(url, json={"count": 2, "seed": 7}).json()["targets"]
    for target in targets:
        point = {"interface": "adjectives", "values": target["values"]}
        assert asked(signed_in, space, "weights", point).json()["weights"] == target["weights"]
        clip = {key: target[key] for key in ("source", "operations", "name")}
        assert signed_in.post("/api/v1/clips", json=clip).status_code == 201
