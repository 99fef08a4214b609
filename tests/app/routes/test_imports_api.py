"""Files into the library: whole or not at all, asked about, corrected, kept."""

from __future__ import annotations

import json

import pytest
from sqlalchemy import func, select

from app.persistence.engine import Database
from app.persistence.models import Base, Study
from app.services import imports
from tests.app.conftest import Researching
from tests.support.motions import faulty_bvh, walk, walk_bvh


def row_counts(database: Database) -> dict[str, int]:
    with database.reading() as db:
        return {
            name: db.scalar(select(func.count()).select_from(table)) or 0
            for name, table in Base.metadata.tables.items()
        }


def test_a_file_becomes_a_clip_that_waits_for_confirmation(signed_in: Researching) -> None:
    response = signed_in.upload("C:\\motions\\walk one.bvh", walk_bvh())
    assert response.status_code == 201
    told = response.json()
    assert told["clip"]["name"] == "walk one"
    assert told["clip"]["state"] == "to_confirm"
    assert told["clip"]["source"] == "imported"
    assert told["clip"]["frames"] == told["report"]["frames"] == walk().frames
    assert told["report"]["unit"] == 0.01
    assert told["report"]["roles"]["left_forearm"] in told["report"]["joint_names"]
    assert told["already_there"] is False
    again = signed_in.get(f"/api/v1/clips/{told['clip']['id']}").json()
    assert again["report"] == told["report"]


def test_a_confirmed_clip_is_kept(signed_in: Researching) -> None:
    clip = signed_in.upload("walk.bvh", walk_bvh()).json()["clip"]
    assert signed_in.post(f"/api/v1/clips/{clip['id']}/confirm").json()["state"] == "kept"
    assert signed_in.get(f"/api/v1/clips/{clip['id']}").json()["state"] == "kept"


def test_the_same_file_again_is_the_same_clip_and_says_so(
    signed_in: Researching, database: Database
) -> None:
    first = signed_in.upload("walk.bvh", walk_bvh())
    counts = row_counts(database)
    again = signed_in.upload("copy of walk.bvh", walk_bvh())
    assert again.status_code == 200
    assert again.json()["already_there"] is True
    assert again.json()["clip"] == first.json()["clip"]
    assert row_counts(database) == counts


def test_a_faulty_file_is_refused_with_its_place_and_leaves_nothing(
    signed_in: Researching, database: Database
) -> None:
    before = row_counts(database)
    response = signed_in.upload("walk.bvh", faulty_bvh())
    assert response.status_code == 422
    error = response.json()["error"]
    line = next(i for i, t in enumerate(faulty_bvh().split(b"\n"), 1) if b"nonsense" in t)
    column = faulty_bvh().split(b"\n")[line - 1].index(b"nonsense") + 1
    assert (error["where"]["line"], error["where"]["column"]) == (line, column)
    assert error["where"]["frame"] == 10
    assert any("nonsense" in text for _, text in error["where"]["context"])
    assert row_counts(database) == before


def test_a_fault_while_storing_leaves_nothing(
    signed_in: Researching, database: Database, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = row_counts(database)

    def fail(*_: object) -> None:
        raise RuntimeError("the disk is full")

    monkeypatch.setattr(imports, "_told", fail)  # the last step
    monkeypatch.setattr(imports.clips, "put", fail)  # after the blobs
    assert signed_in.upload("walk.bvh", walk_bvh()).status_code == 500
    assert row_counts(database) == before


def test_a_correction_reads_the_file_again_under_a_new_id(
    signed_in: Researching, database: Database
) -> None:
    first = signed_in.upload("walk.bvh", walk_bvh()).json()
    counts = row_counts(database)
    corrected = signed_in.patch(f"/api/v1/clips/{first['clip']['id']}", json={"unit": 0.012}).json()
    assert corrected["report"]["stature"] == pytest.approx(first["report"]["stature"] * 1.2)
    assert corrected["clip"]["id"] != first["clip"]["id"]
    assert corrected["clip"]["name"] == "walk"
    assert signed_in.get(f"/api/v1/clips/{first['clip']['id']}").status_code == 404
    after = row_counts(database)
    assert after["clips"] == counts["clips"]


def test_corrections_add_up(signed_in: Researching) -> None:
    first = signed_in.upload("walk.bvh", walk_bvh()).json()
    roles = first["report"]["roles"]
    swapped = {"left_hand": roles["right_hand"], "right_hand": roles["left_hand"]}
    second = signed_in.patch(f"/api/v1/clips/{first['clip']['id']}", json={"unit": 0.012}).json()
    third = signed_in.patch(f"/api/v1/clips/{second['clip']['id']}", json={"roles": swapped}).json()
    assert third["report"]["unit"] == 0.012
    assert {role: third["report"]["roles"][role] for role in swapped} == swapped
    assert third["report"]["roles"]["left_forearm"] == roles["left_forearm"]


def test_a_correction_that_cannot_be_leaves_the_clip_as_it_is(signed_in: Researching) -> None:
    first = signed_in.upload("walk.bvh", walk_bvh()).json()
    url = f"/api/v1/clips/{first['clip']['id']}"
    refused = signed_in.patch(url, json={"roles": {"head": "no such joint"}})
    assert refused.status_code == 422
    assert "no such joint" in refused.json()["error"]["message"]
    assert signed_in.get(url).json()["report"] == first["report"]


def test_a_confirmed_clip_is_not_changed_any_more(signed_in: Researching) -> None:
    clip = signed_in.upload("walk.bvh", walk_bvh()).json()["clip"]
    signed_in.post(f"/api/v1/clips/{clip['id']}/confirm")
    refused = signed_in.patch(f"/api/v1/clips/{clip['id']}", json={"unit": 1})
    assert refused.status_code == 409
    assert refused.json()["error"]["code"] == "clip_confirmed"


def test_a_deleted_clip_takes_its_files_along(signed_in: Researching, database: Database) -> None:
    empty = row_counts(database)
    clip = signed_in.upload("walk.bvh", walk_bvh()).json()["clip"]
    assert signed_in.delete(f"/api/v1/clips/{clip['id']}").status_code == 204
    after = row_counts(database)
    assert after["clips"] == empty["clips"]
    assert after["blobs"] - empty["blobs"] == after["figures"] - empty["figures"]  # figures stay
    assert signed_in.client.get(clip["glb_url"]).status_code == 404


def test_a_clip_that_a_study_shows_stays(signed_in: Researching, database: Database) -> None:
    clip = signed_in.upload("walk.bvh", walk_bvh()).json()["clip"]
    with database.writing() as db:
        shown = {"stimuli": [{"clip": clip["id"]}]}
        db.add(Study(slug="s", title="S", draft=shown))
        db.commit()
    refused = signed_in.delete(f"/api/v1/clips/{clip['id']}")
    assert refused.status_code == 409
    assert refused.json()["error"]["code"] == "clip_in_use"
    assert signed_in.client.get(clip["glb_url"]).status_code == 200


def test_options_come_along_with_the_file(signed_in: Researching) -> None:
    told = signed_in.upload("walk.bvh", walk_bvh(), options=json.dumps({"unit": 0.009})).json()
    assert told["report"]["unit"] == 0.009
    for wrong in ("{", '{"unit": -1}', '{"colour": "red"}'):
        refused = signed_in.upload("walk.bvh", walk_bvh(), options=wrong)
        assert refused.status_code == 422
        assert refused.json()["error"]["where"]["field"].startswith("options")


@pytest.mark.parametrize("data", [b"", b"nothing of the kind", b"\x00\xff" * 500, b"HIERARCHY"])
def test_what_is_no_motion_is_refused_with_a_reason(signed_in: Researching, data: bytes) -> None:
    response = signed_in.upload("walk.bvh", data)
    assert response.status_code == 422
    assert response.json()["error"]["message"]
