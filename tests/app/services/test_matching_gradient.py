"""Made-up participants who follow the distance downhill finish with every interface."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray
from sqlalchemy import select

from app.persistence.clips import contents
from app.persistence.engine import Database
from app.persistence.models import Response
from app.schemas.spaces import TargetRequest
from app.services import matching, samples, sessions, space_samples, space_targets, spaces
from app.services.sessions import Beginning
from app.studies.matching import THRESHOLD
from motion.procedural.library import set_a, set_b
from tests.app.conftest import Researching
from tests.app.services.test_matching import answer, published, study_of

SETS = {"set_a": set_a, "set_b": set_b}
INTERFACES = ("adjectives", "features", "weights")
TARGETS = 2
SEED = 1
# Requests that a person who only feels their way needs at most; 27 weights are many.
MOST = {"adjectives": 80, "features": 80, "weights": 250}
FIRST_STEP, LAST_STEP = 0.25, 0.01

Sliders = NDArray[np.float64]


def followed(distance: Callable[[Sliders], float], start: Sliders) -> tuple[Sliders, int]:
    """Move one slider after the other whichever way is nearer, in ever smaller steps.

    Returns:
        Where it matched, or where no step helped any more, and how often the motion was made.
    """
    at, step = start, FIRST_STEP
    nearest, moves = distance(at), 1
    while nearest >= THRESHOLD and step >= LAST_STEP:
        before = nearest
        for way in (
            step * np.repeat(np.eye(len(at)), 2, axis=0) * np.tile([[1], [-1]], (len(at), 1))
        ):
            there = np.clip(at + way, 0, 1).round(3)
            found, moves = distance(there), moves + 1
            if found < nearest:
                at, nearest = there, found
            if nearest < THRESHOLD:
                return at, moves
        if nearest == before:
            step /= 2
    return at, moves


def drawn(database: Database, motion_set: str) -> tuple[dict, list[dict]]:
    """The sample space of a set of walks, and targets in it as a study file says them."""
    samples.make(database, SETS[motion_set])
    space_samples.make(database)
    name = spaces.SAMPLES[motion_set]
    with database.reading() as db:
        line = next(one for one in spaces.listed(db).spaces if one.name == name)
        definition = spaces.definition(db, line.id)
        found = space_targets.draw(
            definition,
            contents(db, [one.clip for one in definition.examples]),
            TargetRequest(count=TARGETS, seed=SEED),
        )
    space = {"name": name, "clips": [{"clip": one.clip} for one in definition.examples]}
    made = [{"made": {"space": name, "values": one.values}, "name": f"t{n}"} for n, one in
            enumerate(found.targets)]  # fmt: skip
    return space, made


@pytest.mark.parametrize("motion_set", list(SETS))
def test_who_follows_the_distance_downhill_finishes_with_every_interface(
    signed_in: Researching, database: Database, motion_set: str
) -> None:
    space, targets = drawn(database, motion_set)
    study = study_of(space, interfaces=INTERFACES, guess_first=False, threshold=THRESHOLD)
    study["parts"][0]["stimuli"] = targets
    slug = published(signed_in, study)
    with database.writing() as db:
        token = sessions.begin(db, slug, Beginning(consent_version=study["consent"]["version"]))
        db.commit()
    view = signed_in.get(f"/api/v1/sessions/{token}").json()
    told = view["parts"]["matching"]
    assert len(view["steps"]) == TARGETS * len(INTERFACES)
    for index, step in enumerate(view["steps"]):
        names = [one["id"] for one in told["sliders"][step["interface"]]]

        def distance(sliders: Sliders, index: int = index, names: list[str] = names) -> float:
            given = dict(zip(names, sliders.tolist(), strict=True))
            with database.reading() as db:
                return matching.motion(db, token, index, given).distance

        at, moves = followed(distance, np.full(len(names), told["start"]))
        assert moves <= MOST[step["interface"]], step["interface"]
        sent = answer(index, dict(zip(names, at.tolist(), strict=True)), 60.0)
        stored = signed_in.post(f"/api/v1/sessions/{token}/responses", json=sent)
        assert stored.status_code == 201, stored.text
    with database.reading() as db:
        answers = [row.answers for row in db.scalars(select(Response))]
    assert len(answers) == len(view["steps"])
    assert all(one["solved"] == 1 and one["distance"] < THRESHOLD for one in answers)
