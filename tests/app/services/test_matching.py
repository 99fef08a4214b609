"""Matching a target, from the study file to the stored distance."""

from __future__ import annotations

import csv
import io
import threading
import zipfile
from typing import Any

import numpy as np
import pytest
from sqlalchemy import select

from app.persistence.clips import contents
from app.persistence.engine import Database
from app.persistence.models import ClipRecord, Response, SpaceRecord
from app.schemas.spaces import SpaceDefinition
from app.services import sessions, space_motion
from app.services.sessions import Beginning
from app.services.space_points import Recent
from motion.blending.distance import matching_distance
from motion.storage import clip_from_bytes
from tests.app.conftest import Researching
from tests.app.services.test_psych_ds import data_files, hold_to_the_rules
from tests.support.study_files import CONSENT, TEXTS, THANKS

THRESHOLD = 0.06


@pytest.fixture
def space(signed_in: Researching, samples_made: int) -> dict[str, Any]:
    """An authoring space of three walks that nobody judged."""
    clips = signed_in.get("/api/v1/clips").json()["clips"]
    body = {"name": "Three walks", "clips": [clip["id"] for clip in clips]}
    response = signed_in.post("/api/v1/spaces", json=body)
    assert response.status_code == 201, response.text
    return response.json()


def study_of(space: dict[str, Any], /, **task: Any) -> dict[str, Any]:
    """A study file that matches two targets of the space."""
    clips = [example["clip"] for example in space["clips"]]
    targets = [
        {"made": {"space": space["name"], "interface": "weights", "values": {a: 0.7, b: 0.3}},
         "name": name, "label": name}
        for name, a, b in (("one", clips[0], clips[1]), ("two", clips[1], clips[2]))
    ]  # fmt: skip
    asked = {
        "kind": "match", "question": "Match it.", "space": space["name"],
        "interfaces": ["weights", "features"], "threshold": THRESHOLD, **task,
    }  # fmt: skip
    part = {"kind": "trials", "id": "matching", "task": asked, "stimuli": targets}
    return {
        "manner": 1, "slug": "matching", "title": "Matching", "welcome": TEXTS, "thanks": THANKS,
        "consent": CONSENT, "parts": [part],
    }  # fmt: skip


def published(researcher: Researching, study: dict[str, Any]) -> str:
    made = researcher.post("/api/v1/studies", json={"definition": study})
    assert made.status_code == 201, made.text
    slug = made.json()["slug"]
    response = researcher.post(f"/api/v1/studies/{slug}/publish")
    assert response.status_code == 200, response.text
    return slug


def begun(database: Database, slug: str, study: dict[str, Any]) -> str:
    version = study["consent"]["version"]
    with database.writing() as db:
        token = sessions.begin(db, slug, Beginning(consent_version=version))
        db.commit()
    return token


def answer(index: int, sliders: dict[str, float], seconds: float, **more: Any) -> dict[str, Any]:
    return {
        "trial_index": index,
        "revision": 1,
        "answers": {**sliders, "seconds": seconds},
        "touched": list(sliders),
        "rt_ms": seconds * 1000,
        "time_elapsed_ms": seconds * 1000,
        "client_time": "2026-11-22T12:00:00Z",
        "record": {"path": [[10.0, next(iter(sliders)), 0.4], [200.5, next(iter(sliders)), 0.7]]},
        **more,
    }


def test_a_target_is_made_in_the_space_guessed_seen_and_measured(
    signed_in: Researching, space: dict[str, Any], database: Database
) -> None:
    study = study_of(space)
    token = begun(database, published(signed_in, study), study)
    at = f"/api/v1/sessions/{token}"
    view = signed_in.get(at).json()
    assert [(s["interface"], s["seen"]) for s in view["steps"][:4]] == [
        ("weights", False), ("features", False), ("weights", True), ("features", True),
    ]  # fmt: skip
    told = view["parts"]["matching"]
    assert "space" not in told
    assert [one["id"] for one in told["sliders"]["weights"]] == ["e0", "e1", "e2"]
    assert len(told["sliders"]["features"]) == 4
    assert [one["caption"] for one in told["example_figures"]] == ["1", "2", "3"]

    sliders = {"e0": 0.7, "e1": 0.3, "e2": 0.0}
    unseen = signed_in.post(f"{at}/steps/0/motion", json={"values": sliders})
    assert (unseen.status_code, unseen.json()["error"]["code"]) == (409, "unseen")
    features = {one["id"]: 0.5 for one in told["sliders"]["features"]}
    tried = {**sliders, "e2": 0.9}
    for index, given, seconds in ((0, sliders, 3.0), (1, features, 4.0), (2, tried, 20.0)):
        if index == 2:
            seen = signed_in.post(f"{at}/steps/2/motion", json={"values": sliders})
            assert seen.status_code == 200
            assert seen.content[:4] == b"glTF"
        sent = signed_in.post(f"{at}/responses", json=answer(index, given, seconds))
        assert sent.status_code == 201, sent.text
    again = signed_in.post(f"{at}/responses", json=answer(0, sliders, 3.0))
    assert again.status_code == 200
    assert signed_in.get(at).json()["responses"]["0"]["answers"] == {**sliders, "seconds": 3.0}

    with database.reading() as db:
        rows = {row.trial_index: row for row in db.scalars(select(Response))}
        record = db.scalar(select(SpaceRecord))
        definition = SpaceDefinition.model_validate(record.definition)
        clips = contents(db, [one.clip for one in definition.examples])
        target = clip_from_bytes(contents(db, [rows[0].clip_id])[rows[0].clip_id])
        recipe = db.get(ClipRecord, rows[0].clip_id).recipe
    assert recipe[0]["operation"] == "blend@1"
    blender = space_motion.Prepared.of(definition, clips)
    for index, given in ((0, (0.7, 0.3, 0.0)), (2, (0.7, 0.3, 0.9))):
        weights = np.array(given) / sum(given)
        distance = matching_distance(target, blender.clip(weights))
        assert rows[index].answers["distance"] == pytest.approx(distance, abs=1e-5)
        assert rows[index].answers["solved"] == int(distance < THRESHOLD)
    assert [rows[i].answers["seen"] for i in (0, 2)] == [0, 1]
    if view["steps"][0]["figures"] == view["steps"][2]["figures"]:
        assert float(seen.headers["Manner-Distance"]) == pytest.approx(
            rows[0].answers["distance"], abs=1e-4
        )
    assert rows[2].record["path"] == [[10.0, "e0", 0.4], [200.5, "e0", 0.7]]


def test_the_writer_reads_no_space(
    signed_in: Researching,
    space: dict[str, Any],
    database: Database,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It would keep everybody else's answers waiting."""
    study = study_of(space, interfaces=["weights"])
    token = begun(database, published(signed_in, study), study)
    readers: list[str] = []
    prepared = space_motion.Prepared.of

    def of(*given: Any) -> space_motion.Prepared:
        readers.append(threading.current_thread().name)
        return prepared(*given)

    monkeypatch.setattr(space_motion, "_prepared", Recent(1))  # as after a restart
    monkeypatch.setattr(space_motion.Prepared, "of", of)
    body = answer(0, {"e0": 1.0, "e1": 0.0, "e2": 0.0}, 3.0)
    assert signed_in.post(f"/api/v1/sessions/{token}/responses", json=body).status_code == 201
    assert len(readers) == 1
    assert readers[0] != "writer"


def test_too_late_is_not_solved(
    signed_in: Researching, space: dict[str, Any], database: Database
) -> None:
    study = study_of(space, seconds=30, threshold=1.0, guess_first=False, interfaces=["weights"])
    token = begun(database, published(signed_in, study), study)
    for index, seconds in ((0, 30.0), (1, 30.5)):
        body = answer(index, {"e0": 1.0, "e1": 0.0, "e2": 0.0}, seconds)
        assert signed_in.post(f"/api/v1/sessions/{token}/responses", json=body).status_code == 201
    with database.reading() as db:
        solved = {row.trial_index: row.answers["solved"] for row in db.scalars(select(Response))}
    assert solved == {0: 1, 1: 0}


@pytest.mark.parametrize(
    ("sliders", "fault"),
    [
        ({"e9": 0.5}, "no slider “e9”"),
        ({"e0": 1.5}, "not within 0 … 1"),
        ({}, "“a slider” is not answered"),
    ],
)
def test_what_is_no_position_is_refused(
    signed_in: Researching,
    space: dict[str, Any],
    database: Database,
    sliders: dict[str, float],
    fault: str,
) -> None:
    study = study_of(space)
    token = begun(database, published(signed_in, study), study)
    body = {**answer(0, {"e0": 1.0}, 3.0), "answers": {**sliders, "seconds": 3.0}, "touched": []}
    refused = signed_in.post(f"/api/v1/sessions/{token}/responses", json=body)
    assert refused.status_code == 422
    assert fault in refused.json()["error"]["message"]


def test_nothing_moves_once_the_session_has_ended(
    signed_in: Researching, space: dict[str, Any], database: Database
) -> None:
    study = study_of(space, guess_first=False, interfaces=["weights"])
    token = begun(database, published(signed_in, study), study)
    at, sliders = f"/api/v1/sessions/{token}", {"e0": 1.0, "e1": 0.0, "e2": 0.0}
    for index in range(2):
        sent = signed_in.post(f"{at}/responses", json=answer(index, sliders, 3.0))
        assert sent.status_code == 201
    assert signed_in.post(f"{at}/steps/1/motion", json={"values": sliders}).status_code == 200
    assert signed_in.post(f"{at}/complete").status_code == 200
    refused = signed_in.post(f"{at}/steps/1/motion", json={"values": sliders})
    assert (refused.status_code, refused.json()["error"]["code"]) == (409, "session_complete")


def test_a_target_moves_only_in_its_turn_and_afterwards_as_it_was_handed_in(
    signed_in: Researching, space: dict[str, Any], database: Database
) -> None:
    study = study_of(space, guess_first=False, interfaces=["weights"])
    token = begun(database, published(signed_in, study), study)
    at, sliders = f"/api/v1/sessions/{token}", {"e0": 1.0, "e1": 0.25, "e2": 0.0}

    def asked(index: int, values: dict[str, float]) -> tuple[int, str | None]:
        reply = signed_in.post(f"{at}/steps/{index}/motion", json={"values": values})
        return reply.status_code, None if reply.is_success else reply.json()["error"]["code"]

    assert asked(1, sliders) == (409, "too_early")
    assert asked(0, sliders) == (200, None)
    assert signed_in.post(f"{at}/responses", json=answer(0, sliders, 3.0)).status_code == 201
    assert asked(0, {**sliders, "e2": 0.5}) == (409, "already_answered")
    assert asked(0, sliders) == (200, None)
    assert asked(1, sliders) == (200, None)


def test_who_asks_for_more_motions_than_a_hand_can_is_braked_alone(
    signed_in: Researching, space: dict[str, Any], database: Database
) -> None:
    study = study_of(space, guess_first=False, interfaces=["weights"])
    slug = published(signed_in, study)
    quick, other = (begun(database, slug, study) for _ in range(2))
    for _ in range(300):
        signed_in.client.app.state.motion_limiter.count(quick)

    def asked(token: str) -> Any:
        at = f"/api/v1/sessions/{token}/steps/0/motion"
        return signed_in.post(at, json={"values": {"e0": 1.0}})

    assert asked(quick).status_code == 429
    assert "Wait 10 seconds" in asked(quick).json()["error"]["mend"]
    assert asked(other).status_code == 200


@pytest.mark.parametrize("what", ["some", "others"])
def test_a_match_is_made_by_all_sliders_of_the_page_and_no_others(
    signed_in: Researching, space: dict[str, Any], database: Database, what: str
) -> None:
    study = study_of(space, guess_first=False, interfaces=["features"])
    token = begun(database, published(signed_in, study), study)
    sliders = space["definition"]["features"]
    primary, single = ([one["id"] for one in sliders[of]] for of in ("primary", "parameters"))
    given = dict.fromkeys(primary[:2] if what == "some" else [*primary, single[0]], 0.5)
    at = f"/api/v1/sessions/{token}"
    for refused in (
        signed_in.post(f"{at}/steps/0/motion", json={"values": given}),
        signed_in.post(f"{at}/responses", json=answer(0, given, 3.0)),
    ):
        assert (refused.status_code, refused.json()["error"]["code"]) == (422, "answer_invalid")


def test_all_weights_at_the_bottom_are_the_mean_of_the_examples(
    signed_in: Researching, space: dict[str, Any], database: Database
) -> None:
    study = study_of(space, guess_first=False, interfaces=["weights"])
    token = begun(database, published(signed_in, study), study)
    at = f"/api/v1/sessions/{token}/steps/0/motion"
    none, same = (
        signed_in.post(at, json={"values": dict.fromkeys(("e0", "e1", "e2"), value)})
        for value in (0.0, 0.4)
    )
    assert none.content == same.content


@pytest.mark.parametrize(
    ("task", "place", "message"),
    [
        ({"space": "Nowhere"}, "space", "There is no authoring space “Nowhere”"),
        ({"interfaces": ["adjectives"]}, "interfaces", "it has no adjectives"),
    ],
)
def test_a_space_that_is_not_there_or_lacks_adjectives_is_told_at_its_place(
    signed_in: Researching, space: dict[str, Any], task: Any, place: str, message: str
) -> None:
    made = signed_in.post("/api/v1/studies", json={"definition": study_of(space, **task)})
    problems = signed_in.get(f"/api/v1/studies/{made.json()['slug']}").json()["problems"]
    assert [problem["where"] for problem in problems] == [["parts", 0, "task", place]]
    assert message in problems[0]["message"]


def test_a_point_off_the_space_is_told_at_its_stimulus(
    signed_in: Researching, space: dict[str, Any]
) -> None:
    study = study_of(space)
    study["parts"][0]["stimuli"][1]["made"] = {"space": space["name"], "values": {"quickness": 1}}
    made = signed_in.post("/api/v1/studies", json={"definition": study})
    problems = signed_in.get(f"/api/v1/studies/{made.json()['slug']}").json()["problems"]
    assert problems[0]["where"][:4] == ["parts", 0, "stimuli", 1]
    assert "no adjectives" in problems[0]["message"]


def test_a_preview_moves_as_well_and_keeps_nothing(
    signed_in: Researching, space: dict[str, Any], database: Database
) -> None:
    slug = published(signed_in, study_of(space, guess_first=False))
    motion = signed_in.post(
        f"/api/v1/studies/{slug}/preview/steps/0/motion", json={"values": {"e0": 1.0}}
    )
    assert motion.status_code == 200, motion.text
    assert 0 <= float(motion.headers["Manner-Distance"]) < 1
    with database.reading() as db:
        assert db.scalar(select(Response)) is None


def test_the_tables_tell_every_interface_apart_and_every_move(
    signed_in: Researching, space: dict[str, Any], database: Database
) -> None:
    study = study_of(space, interfaces=["weights"])
    slug = published(signed_in, study)
    token = begun(database, slug, study)
    for index in range(4):
        body = answer(index, {"e0": 0.1 * index, "e1": 0.5, "e2": 0.5}, 10.0 + index)
        assert signed_in.post(f"/api/v1/sessions/{token}/responses", json=body).status_code == 201
    at = f"/research/studies/{slug}"
    long = list(csv.DictReader(io.StringIO(signed_in.get(f"{at}/responses.csv").text)))
    assert [row["interface"] for row in long] == ["weights"] * 4
    assert [row["seen"] for row in long] == ["0", "1", "0", "1"]
    (wide,) = csv.DictReader(io.StringIO(signed_in.get(f"{at}/wide.csv").text))
    for row in long:
        way = "match" if row["seen"] == "1" else "guess"
        begun_with = f"{row['stimulus']}__weights_{way}"
        assert wide[f"{begun_with}__distance"] == row["distance"]
        assert wide[f"{begun_with}__seconds"] == row["seconds"]
    moves = list(csv.DictReader(io.StringIO(signed_in.get(f"{at}/moves.csv").text)))
    assert len(moves) == 8
    assert [moves[0][name] for name in ("milliseconds", "slider", "position")] == [
        "10.0", "e0", "0.4",
    ]  # fmt: skip
    assert {row["stimulus"] for row in moves} == {"one", "two"}
    with zipfile.ZipFile(io.BytesIO(signed_in.get(f"{at}/psych-ds.zip").content)) as archive:
        files = {name.partition("/")[2]: archive.read(name) for name in archive.namelist()}
    hold_to_the_rules(files)
    (path,) = (content for name, content in files.items() if "_description-moves_" in name)
    assert list(csv.DictReader(io.StringIO(path.decode()))) == moves
    assert len(data_files(files)) == 2
