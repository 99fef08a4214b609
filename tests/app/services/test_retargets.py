"""Skeletons that clips share, and how well a motion would fit another one."""

from __future__ import annotations

import math
from typing import Any

import pytest

from app.persistence import clips
from app.persistence.engine import Database
from app.services import retargets
from motion.retargeting import retarget
from motion.storage import clip_from_bytes
from tests.app.conftest import Researching
from tests.support.other_bodies import stranger_bvh

LINE = "/api/v1/clips/{}/retargeting"


@pytest.fixture
def author(signed_in: Researching, samples_made: int) -> Researching:
    """A signed-in researcher at a server with three walks of one body."""
    assert samples_made == 3
    return signed_in


def imported(author: Researching, keep: bool = True) -> dict[str, Any]:
    """A walk on a body of its own."""
    clip = author.upload("stranger.bvh", stranger_bvh()).json()["clip"]
    if keep:
        assert author.post(f"/api/v1/clips/{clip['id']}/confirm").status_code == 200
    return clip


def sample(author: Researching) -> dict[str, Any]:
    return next(c for c in author.get("/api/v1/clips").json()["clips"] if c["source"] == "sample")


def told(author: Researching, clip: str, onto: str, **more: Any) -> dict[str, Any]:
    answer = author.get(LINE.format(clip), params={"onto": onto, **more})
    assert answer.status_code == 200, answer.text
    return answer.json()


def test_each_skeleton_is_listed_once_with_its_clips_and_an_example(author: Researching) -> None:
    stranger = imported(author)
    listed = author.get("/api/v1/skeletons").json()["skeletons"]
    everything = author.get("/api/v1/clips").json()["clips"]
    assert [(one["id"], one["clips"]) for one in listed] == [
        (sample(author)["skeleton_hash"], 3),
        (stranger["skeleton_hash"], 1),
    ]
    for one in listed:
        assert one["example"] in everything
        assert one["example"]["skeleton_hash"] == one["id"]


def test_a_clip_that_waits_to_be_confirmed_shows_no_body(author: Researching) -> None:
    stranger = imported(author, keep=False)
    listed = author.get("/api/v1/skeletons").json()["skeletons"]
    assert stranger["skeleton_hash"] not in [one["id"] for one in listed]
    answer = author.get(LINE.format(sample(author)["id"]), params={"onto": stranger["id"]})
    assert (answer.status_code, answer.json()["error"]["code"]) == (409, "clip_to_confirm")


def test_what_is_told_is_what_the_recipe_makes(author: Researching, database: Database) -> None:
    stranger, body = imported(author)["id"], sample(author)["id"]
    said = told(author, stranger, body)
    with database.reading() as db:
        stored = clips.contents(db, [stranger, body])
    expected = retarget(clip_from_bytes(stored[stranger]), clip_from_bytes(stored[body]))
    for name in ("mean_direction", "greatest_direction", "slip", "sole_height"):
        assert said[name] == pytest.approx(getattr(expected.error, name), abs=1e-12)
    assert said["same"] is False
    assert f"{math.degrees(said['greatest_direction']):.1f}°" in said["sentence"]
    assert f"{1000 * max(said['slip'], 0.001):.0f} mm" in said["sentence"]
    recipe = {
        "source": stranger,
        "operations": [{"operation": "retarget@1", "parameters": {"clip": body}}],
    }
    made = author.post("/api/v1/clips", json=recipe).json()
    assert made["skeleton_hash"] == sample(author)["skeleton_hash"]
    assert made["provenance"]["content_hash"] == expected.clip.content_hash
    assert (made["recipe_source"], made["variant_of"]) == (stranger, None)
    assert told(author, made["id"], body)["same"] is True


def test_clips_of_one_skeleton_have_nothing_to_be_put_onto(author: Researching) -> None:
    one, other, *_ = [c["id"] for c in author.get("/api/v1/clips").json()["clips"]]
    said = told(author, one, other)
    assert (said["same"], said["greatest_direction"]) == (True, 0.0)
    assert "the same skeleton already" in said["sentence"]


def test_one_cycle_is_told_by_itself(author: Researching) -> None:
    stranger, body = imported(author)["id"], sample(author)["id"]
    said = {cut: told(author, stranger, body, cycle=cut) for cut in ("none", "found", "whole")}
    assert len({one["mean_direction"] for one in said.values()}) == 3
    assert said["found"]["fits"] is True


def test_a_motion_without_a_stride_is_told(author: Researching) -> None:
    one, other, *_ = author.get("/api/v1/clips").json()["clips"]
    cut = {"source": one["id"], "operations": [{"operation": "cut@1", "parameters": {"end": 0.3}}]}
    piece = author.post("/api/v1/clips", json=cut).json()["id"]
    answer = author.get(LINE.format(piece), params={"onto": other["id"], "cycle": "found"})
    assert (answer.status_code, answer.json()["error"]["code"]) == (422, "motion_unusable")
    assert "stride" in answer.json()["error"]["message"]


def test_joints_that_nothing_leads_are_named() -> None:
    numbers = {"greatest_direction": math.radians(2.0), "slip": 0.0042, "sole_height": 0.012}
    one = retargets._sentence({**numbers, "resting": ["LeftToe"]}, same=False, fits=True)
    assert one == (
        "The motion fits: limbs point where they pointed within 2.0°, standing feet slide by 4 mm "
        "at most and are 12 mm off the floor. One joint of the new body rests: LeftToe."
    )
    five = retargets._sentence({**numbers, "resting": list("abcde")}, same=False, fits=False)
    assert "fits loosely" in five
    assert five.endswith("5 joints of the new body rest: a, b, c ….")


def test_an_unknown_clip_is_told(author: Researching) -> None:
    body = sample(author)["id"]
    for clip, onto in ((body, "nobody"), ("nobody", body)):
        answer = author.get(LINE.format(clip), params={"onto": onto})
        assert (answer.status_code, answer.json()["error"]["code"]) == (404, "clip_not_found")
