"""The analysis of adjective pairs, over HTTP."""

from __future__ import annotations

import time

import numpy as np
import pytest

from app.persistence.models import Researcher
from app.services import impression_stability, rights
from app.services.job_runner import JobRunner
from tests.support import rated_pairs

GROUPS = [3, 2, 4]
PAIRS = sum(GROUPS)
API = "/api/v1/studies/adjectives/impressions"
PAGE = "/research/studies/adjectives/impressions"
OF_PART = f"{API}/{rated_pairs.PART}"


@pytest.fixture
def study(database):
    """A study of everybody's on clips without motion."""
    with database.writing() as db:
        rated_pairs.rated(db, rated_pairs.definition(10, PAIRS), rated_pairs.latent(8, 10, GROUPS))


@pytest.fixture
def walking(database, samples_made, client):
    """A study of the sample walks: their ids."""
    clips = [clip["id"] for clip in client.get("/api/v1/clips").json()["clips"]]
    stimuli = [
        {"clip": clip, "name": f"walk_{n}", "label": f"walk {n}"} for n, clip in enumerate(clips)
    ]
    with database.writing() as db:
        rated_pairs.rated(
            db,
            rated_pairs.definition(stimuli, PAIRS),
            rated_pairs.latent(8, len(clips), GROUPS),
        )
    return clips


def become(database, researcher: str, role: str) -> None:
    """Give the study to somebody else, and the one who is signed in this role in it."""
    with database.writing() as db:
        other = Researcher(email="olga@example.org", name="Olga", password_hash="-")
        db.add(other)
        db.commit()
        owner = rights.access(db, "adjectives", other.id, "own")
        rights.put_member(db, owner, researcher, role)


def test_a_stranger_gets_no_numbers(client, study):
    assert client.get(API).status_code == 401
    assert client.get(PAGE).headers["location"].startswith("/research/sign-in?next=")


def test_thresholds_and_cut_in_the_address_stand_in_for_the_saved_ones(signed_in, study):
    saved = signed_in.get(API).json()
    tried = signed_in.get(f"{API}?least_peak=0.5&most_spread=0.7&clusters=2").json()
    assert (
        tried["choices"] | {"least_peak": 1, "most_spread": 0.85, "clusters": 4}
        == (saved["choices"])
    )
    assert len(tried["clusters"]) == 2
    assert signed_in.get(API).json() == saved


def test_numbers_that_make_no_sense_are_refused(signed_in, study):
    for query in ("least_peak=-1", "clusters=0", "most_spread=many", "kind=preview"):
        assert signed_in.get(f"{API}?{query}").status_code == 422
    assert signed_in.get(f"{API}?part=nowhere").status_code == 404
    assert signed_in.put(OF_PART, json={"cluster": 3}).status_code == 422


def test_what_is_put_is_got_and_told_in_the_trail(signed_in, study):
    put = signed_in.put(OF_PART, json={"clusters": 3, "names": {"pair_8": "Size"}})
    assert put.status_code == 200
    assert put.json() == signed_in.get(API).json()
    assert "Size" in [cluster["title"] for cluster in put.json()["clusters"]]
    trail = signed_in.get("/api/v1/studies/adjectives/audit").json()["entries"]
    assert [entry["act"] for entry in trail] == ["cluster_named", "impressions_cut"]


def test_a_viewer_sees_and_changes_nothing(signed_in, database, researcher, study):
    become(database, researcher, "viewer")
    assert signed_in.get(API).json()["may_edit"] is False
    assert signed_in.get(PAGE).status_code == 200
    for refused in (
        signed_in.put(OF_PART, json={"clusters": 3}),
        signed_in.post(f"{OF_PART}/space", json={"name": "Mine"}),
    ):
        assert refused.status_code == 403
        assert refused.json()["error"]["code"] == "role_too_low"


def test_an_editor_changes_what_everybody_sees(signed_in, database, researcher, study):
    become(database, researcher, "editor")
    assert signed_in.get(API).json()["may_edit"] is True
    assert len(signed_in.put(OF_PART, json={"clusters": 2}).json()["clusters"]) == 2


def test_the_bootstrap_is_the_same_by_seed(signed_in, study):
    query = f"{OF_PART}/stability?samples=20&clusters=3&seed=5"
    first = signed_in.post(query)
    assert first.status_code == 200
    assert first.json() == signed_in.post(query).json()
    assert first.json()["samples"] == 20
    assert signed_in.post(f"{OF_PART}/stability?samples=10001").status_code == 422


def test_a_large_bootstrap_is_a_job_that_can_be_cancelled(signed_in, study, monkeypatch):
    monkeypatch.setattr(impression_stability, "AT_ONCE", 1)
    monkeypatch.setattr(JobRunner, "_run", lambda *_: time.sleep(0.01))  # it never ends
    asked = signed_in.post(f"{OF_PART}/stability?samples=20&clusters=3")
    assert asked.status_code == 202
    job = asked.json()["id"]
    assert asked.headers["location"] == f"/api/v1/jobs/{job}"
    assert signed_in.get(f"{OF_PART}/stability/{job}").json()["error"]["code"] == "job_not_done"
    assert signed_in.delete(f"/api/v1/jobs/{job}").json()["state"] == "cancelled"
    assert job in [one["id"] for one in signed_in.get("/api/v1/jobs").json()["jobs"]]


def test_two_studies_stand_side_by_side(signed_in, study):
    found = signed_in.get(f"{OF_PART}/comparison?other=adjectives").json()
    assert (found["rand"], found["moved"]) == (1.0, [])
    assert signed_in.get(f"{OF_PART}/comparison?other=nothing").status_code == 404


@pytest.mark.parametrize("name", ["heat-map", "dendrogram"])
def test_figures_come_as_svg(signed_in, study, name):
    figure = signed_in.get(f"{PAGE}/figures/{name}.svg?mode=dark&clusters=3")
    assert figure.headers["content-type"] == "image/svg+xml"
    assert figure.text.startswith("<svg")


def test_a_space_holds_what_is_saved_in_every_language(signed_in, walking):
    key = signed_in.put(OF_PART, json={"clusters": 3}).json()["clusters"][0]["key"]
    saved = signed_in.put(
        OF_PART, json={"clusters": 3, "names": {key: "Élan!"}, "moved": {"pair_0": "pair_8"}}
    ).json()
    made = signed_in.post(f"{OF_PART}/space", json={"name": "Walks"})
    assert made.status_code == 201
    line = made.json()
    assert made.headers["location"] == f"/api/v1/spaces/{line['id']}"
    assert (line["name"], line["number"], line["study"]) == ("Walks", 1, "adjectives")
    definition = signed_in.get(made.headers["location"]).json()["definition"]
    assert [one["clip"] for one in definition["examples"]] == walking
    primary = definition["adjectives"]["primary"]
    assert [one["members"] for one in primary] == [one["members"] for one in saved["clusters"]]
    for slider, cluster in zip(primary, saved["clusters"], strict=True):
        np.testing.assert_allclose(slider["values"], cluster["values"], atol=1e-6)
    named = next(place for place, one in enumerate(saved["clusters"]) if one["named"])
    assert (primary[named]["title"], primary[named]["id"]) == ("Élan!", "elan")
    pair = definition["adjectives"]["parameters"][0]
    assert (pair["id"], pair["left"]) == ("pair_0", {"en": "left 0", "fi": "vasen 0"})
    origin = definition["origin"]
    assert (origin["study"], origin["participants"], origin["kind"]) == (
        "adjectives", 8, "participant",
    )  # fmt: skip
    assert (origin["moved"], len(origin["versions"])) == (["pair_0"], 1)


def test_the_same_space_again_is_the_same_and_a_changed_one_the_next_version(signed_in, walking):
    first = signed_in.post(f"{OF_PART}/space", json={"name": "Walks"}).json()
    again = signed_in.post(f"{OF_PART}/space", json={"name": "Walks"}).json()
    signed_in.put(OF_PART, json={"clusters": 2})
    second = signed_in.post(f"{OF_PART}/space", json={"name": "Walks"}).json()
    assert again["id"] == first["id"] != second["id"]
    assert (first["number"], second["number"]) == (1, 2)
    trail = signed_in.get("/api/v1/studies/adjectives/audit").json()["entries"]
    made = [entry["sentence"] for entry in trail if entry["act"] == "space_made"]
    assert [one.split(", ")[1] for one in made] == ["version 2", "version 1"]


def test_without_clusters_there_is_no_space(signed_in, walking):
    signed_in.put(OF_PART, json={"least_peak": 10})
    refused = signed_in.post(f"{OF_PART}/space", json={"name": "Walks"})
    assert refused.status_code == 422
    assert refused.json()["error"]["code"] == "no_clusters"


def test_a_space_of_simulated_answers_says_so(signed_in, database, walking):
    with database.writing() as db:
        study = rights.store.by_slug(db, "adjectives")
        simulated = rated_pairs.latent(4, len(walking), GROUPS, seed=2)
        rated_pairs.add(db, study, simulated, kind="simulated")
    line = signed_in.post(f"{OF_PART}/space?kind=simulated", json={"name": "Walks"}).json()
    assert line["simulated"] is True
