"""Made-up participants who follow the distance downhill finish with every interface."""

from __future__ import annotations

import numpy as np
import pytest
from sqlalchemy import select

from app.errors import InvalidError
from app.persistence.clips import contents
from app.persistence.engine import Database
from app.persistence.models import Response
from app.schemas.spaces import START, TargetRequest
from app.services import (
    browser_simulation,
    samples,
    simulation,
    space_samples,
    space_targets,
    spaces,
)
from app.services.command_line_simulation import Plan, planned
from app.services.simulated_matching import Hand, follow
from app.studies.matching import THRESHOLD
from motion.procedural.library import set_a, set_b
from tests.app.conftest import Researching
from tests.app.services.test_matching import published, study_of

SETS = {"set_a": set_a, "set_b": set_b}
INTERFACES = ("adjectives", "features", "weights")
TARGETS = 2
SEED = 1
# Moves that a person who only feels their way needs at most; 27 weights are many.
MOST = {"adjectives": 160, "features": 160, "weights": 500}


def drawn(database: Database, motion_set: str) -> tuple[dict, list[dict]]:
    """The sample space of a set of walks, and targets in it as a study file says them."""
    samples.make(database, SETS[motion_set])
    space_samples.make(database)
    name = spaces.SAMPLES[motion_set]
    with database.reading() as db:
        line = next(one for one in spaces.listed(db, 0).spaces if one.name == name)
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


def simulated(database: Database, plan: Plan) -> list[Response]:
    (rater,) = simulation.raters(plan.tastes, plan.effects, 1, np.random.default_rng(SEED))
    with database.writing() as db:
        assert simulation.take_part(db, plan.slug, rater).complete
        db.commit()
        return list(db.scalars(select(Response).order_by(Response.received_at.desc())))


@pytest.mark.parametrize("motion_set", list(SETS))
def test_who_follows_the_distance_downhill_finishes_with_every_interface(
    signed_in: Researching, database: Database, motion_set: str
) -> None:
    space, targets = drawn(database, motion_set)
    study = study_of(space, interfaces=INTERFACES, threshold=THRESHOLD, seconds=3600)
    study["parts"][0]["stimuli"] = targets
    plan = planned(database, published(signed_in, study), None)
    answers = simulated(database, plan)
    assert len(answers) == 2 * TARGETS * len(INTERFACES)
    for row in answers:
        given, path = row.answers, row.record["path"]
        at = {name: position for _, name, position in path}
        assert {name: given[name] for name in at} == at
        assert [ms for ms, _, _ in path] == sorted(ms for ms, _, _ in path)
        if given["seen"]:
            assert (given["solved"], given["distance"] < THRESHOLD) == (1, True)
            assert len(path) <= MOST[given["interface"]], given["interface"]
            assert row.record["path"][-1][0] == pytest.approx(1000 * given["seconds"], abs=1)
    with pytest.raises(InvalidError, match="targets are matched"):
        browser_simulation.run(
            database, plan, 1, 1, "http://127.0.0.1", np.random.default_rng(1), lambda _: None
        )


@pytest.mark.parametrize(
    ("threshold", "limit"), [(0.1, 60.0), (0.0, 60.0), (0.0, np.inf)], ids=["met", "late", "stuck"]
)
def test_a_made_up_hand_stops_where_it_matches_or_when_the_time_is_up(
    threshold: float, limit: float
) -> None:
    target = {"a": 0.9, "b": 0.15}
    hand = Hand(dict.fromkeys(target, START), limit, np.random.default_rng(SEED))

    def distance(at: dict[str, float]) -> float:
        return 0.01 + sum(abs(at[name] - there) for name, there in target.items())

    follow(hand, distance, threshold)
    if threshold:
        assert distance(hand.at) < threshold
        assert hand.seconds < limit
    else:
        assert hand.seconds == limit
    assert all(ms <= 1000 * hand.seconds for ms, _, _ in hand.path)
