"""Authoring spaces: what they are made of, prediction for newcomers, targets, the samples."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor
from functools import cache

import numpy as np
import pytest
from scipy.cluster.hierarchy import fcluster, linkage
from sqlalchemy import Engine

from app.errors import InvalidError, NotFoundError
from app.persistence.engine import Database
from app.persistence.studies import sample_clips
from app.schemas.spaces import (
    Parameter,
    Point,
    Primary,
    Sliders,
    SpaceDefinition,
    TargetRequest,
)
from app.services import new_spaces, samples, space_joining, space_samples, space_targets, spaces
from app.services.space_clips import Source
from app.services.space_making import define
from app.services.space_motion import Prepared, prepared
from app.services.space_points import Recent
from app.services.space_sliders import feature_sliders
from app.statistics.agreement import adjusted_rand
from motion.blending.distance import matching_distance
from motion.features import FEATURE_GROUPS, FEATURES, features
from motion.procedural.library import set_a, set_b
from motion.storage import clip_from_bytes, clip_to_bytes


@pytest.fixture
def database(engine: Engine) -> Database:
    return Database(engine)


@cache
def walks() -> tuple[Source, ...]:
    both = (*set_a(), *set_b())
    return tuple(Source(w.clip.content_hash, w.name, clip_to_bytes(w.clip)) for w in both)


def sources(number: int = 10) -> list[Source]:
    return list(walks()[:number])


def contents(of: list[Source]) -> dict[str, bytes]:
    return {one.id: one.content for one in of}


def measured(of: list[Source]) -> np.ndarray:
    return np.stack([features(clip_from_bytes(one.content)) for one in of])


def rated(of: list[Source], columns: dict[str, np.ndarray]) -> Sliders:
    """Pairs with these values of the examples (N,), two and two on a primary slider."""
    names = list(columns)
    members = [tuple(names[n : n + 2]) for n in range(0, len(names), 2)]
    return Sliders(
        primary=tuple(
            Primary(
                id=f"primary_{n}",
                title=f"Primary {n}",
                members=pair,
                values=tuple(np.mean([columns[name] for name in pair], axis=0)),
            )
            for n, pair in enumerate(members)
        ),
        parameters=tuple(
            Parameter(id=name, left=f"less {name}", right=name, values=tuple(values))
            for name, values in columns.items()
        ),
    )


def judged(of: list[Source]) -> SpaceDefinition:
    """A space with two pairs that follow the motion and two that follow nothing."""
    columns = {name: scaled(measured(of)[:, place]) for name, place in FOLLOWING.items()}
    drawn = np.random.default_rng(4).random((2, len(of)))
    columns |= {"drawn": drawn[0], "lots": drawn[1]}
    ordered = {name: columns[name] for name in ("quick", "drawn", "wide", "lots")}
    return define("Judged", of, {}, rated(of, ordered))


def scaled(column: np.ndarray) -> np.ndarray:
    return (column - column.min()) / np.ptp(column)


def place_of(feature: str) -> int:
    return [one.id for one in FEATURES].index(feature)


FOLLOWING = {"quick": place_of("motion_duration"), "wide": place_of("step_length")}


def test_feature_sliders_reach_from_the_least_to_the_greatest_example() -> None:
    values = measured(sources(4))
    values[:, 7] = 3.0
    sliders = feature_sliders(values)
    for place, one in enumerate(sliders.parameters):
        if place == 7:
            assert one.values == (0.5,) * 4
            assert one.lowest == one.highest == 3.0
        else:
            restored = one.lowest + np.array(one.values) * (one.highest - one.lowest)
            np.testing.assert_allclose(restored, values[:, place], atol=1e-5)


def test_clusters_of_features_are_those_of_ward_with_the_papers_titles_once_each() -> None:
    values = measured(sources())
    sliders = feature_sliders(values)
    standardised = (values - values.mean(axis=0)) / values.std(axis=0)
    theirs = fcluster(linkage(standardised.T, "ward"), 4, "maxclust")
    ours = np.array(
        [next(n for n, one in enumerate(sliders.primary) if feature.id in one.members)
         for feature in FEATURES]
    )  # fmt: skip
    assert adjusted_rand(ours, theirs) == 1.0
    assert sorted(str(one.title) for one in sliders.primary) == sorted(FEATURE_GROUPS.values())
    for one in sliders.primary:
        mean = standardised[:, [place_of(name) for name in one.members]].mean(axis=1)
        np.testing.assert_allclose(one.values, scaled(mean), atol=1e-6)


def test_the_same_clips_give_the_same_space_to_the_last_letter(database: Database) -> None:
    one, other = (define("Walks", sources(3), {}) for _ in range(2))
    assert one.content_hash == other.content_hash
    samples.make(database, lambda: [*set_a()][:3])
    with database.writing() as db:
        space = new_spaces.keep(db, one, study_id=None, made_by=None)
        db.commit()
    with database.reading() as db:
        assert spaces.definition(db, space.id).content_hash == space.id == one.content_hash


@pytest.mark.parametrize("place", [0, 1])
def test_a_clip_without_keytimes_among_others_is_named(place: int) -> None:
    of = sources(3)
    with pytest.raises(InvalidError) as refused:
        define("Walks", of, {of[place].id: {}})
    assert refused.value.message.startswith(f"“{of[place].name}” has no keytimes")
    assert refused.value.where == {"field": "keytimes", "clips": [of[place].id]}
    every = define("Walks", of, {one.id: {} for one in of})
    assert not any(one.keytimes for one in every.examples)


def test_a_space_whose_clip_is_gone_meanwhile_is_not_kept(database: Database) -> None:
    samples.make(database, lambda: [*set_a()][:2])
    with database.writing() as db, pytest.raises(NotFoundError):
        new_spaces.keep(db, define("Walks", sources(3), {}), study_id=None, made_by=None)
    with database.reading() as db:
        assert spaces.listed(db, 1).spaces == []


def test_weights_come_in_millionths_whose_sum_is_one() -> None:
    ready = Prepared.of(define("Walks", of := sources(), {}), contents(of))
    names = [one.id for one in ready.definition.features.primary]
    for row in np.random.default_rng(2).random((50, len(names))):
        point = Point(interface="features", values=dict(zip(names, row, strict=True)))
        weights = ready.weights(point).weights
        assert sum(round(weight * 1e6) for weight in weights) == 1_000_000
        assert all(weight == round(weight, 6) >= 0.0 for weight in weights)


def test_only_the_named_sliders_span_the_space() -> None:
    ready = Prepared.of(define("Walks", of := sources(), {}), contents(of))
    (step,) = (o for o in ready.definition.features.parameters if o.id == "step_length")
    for place, value in enumerate(step.values):
        weights = ready.weights(Point(interface="features", values={"step_length": value})).weights
        alike = [n for n, other in enumerate(step.values) if abs(other - value) < 1e-9]
        assert sum(weights[n] for n in alike) == pytest.approx(1.0, abs=2e-6)
        assert place in alike


def test_a_newcomer_joins_by_the_pairs_that_its_motion_tells() -> None:
    of = sources(21)
    before = judged(of[:20])
    version = space_joining.renew(before, of, {})
    assert [one.predicted for one in version.examples] == [False] * 20 + [True]
    assert version.origin.before == before.content_hash
    left = [one.id for one in version.adjectives.parameters]
    assert left == ["quick", "wide"], version.origin.note
    assert "less drawn–drawn, less lots–lots" in version.origin.note
    assert of[20].name in version.origin.note
    for one in version.adjectives.parameters:
        old = next(o for o in before.adjectives.parameters if o.id == one.id)
        assert one.values[:20] == old.values
    for one, (name,) in zip(version.adjectives.primary, [("quick",), ("wide",)], strict=True):
        assert one.members == (name,)
        assert one.values == version.adjectives.parameters[left.index(name)].values
    ready = Prepared.of(version, contents(of))
    assert ready.weights(Point(interface="weights", values={of[20].id: 1.0})).weights[20] == 1.0


def test_the_next_version_learns_from_what_people_said_only() -> None:
    *of, joins, last = sources(22)
    first = judged(of)
    second = space_joining.renew(first, [*of, joins], {})
    at_once = space_joining.renew(first, [*of, last], {}).adjectives.parameters
    later = space_joining.renew(second, [*of, joins, last], {}).adjectives.parameters
    assert at_once
    for one, other in zip(at_once, later, strict=True):
        assert one.values[-1] == pytest.approx(other.values[-1], abs=1e-4)


def test_a_prediction_says_which_pairs_and_how_well() -> None:
    of = sources(21)
    space = judged(of[:20])
    told = space_joining.predict(space, of[0], of[20])
    assert told.can_join
    assert {row.id: row.refused for row in told.parameters} == {
        "quick": False, "drawn": True, "wide": False, "lots": True,
    }  # fmt: skip
    for row in told.parameters:
        if row.refused:
            assert (row.value, row.low, row.high) == (None, None, None)
            assert row.sentence.startswith("Not predicted")
        else:
            assert 0.0 <= row.low <= row.value <= row.high <= 1.0
            assert row.error < row.error_of_mean
    assert not space_joining.predict(space, of[0], of[4]).can_join


def test_nothing_joins_where_no_pair_follows_the_motion() -> None:
    of = sources()
    drawn = np.random.default_rng(8).random((2, 9))
    space = define("Lots", of[:9], {}, rated(of[:9], {"one": drawn[0], "two": drawn[1]}))
    with pytest.raises(InvalidError) as fault:
        space_joining.renew(space, of, {})
    assert fault.value.code == "nothing_predictable"
    assert "study" in fault.value.mend
    assert not space_joining.predict(space, of[0], of[9]).can_join


def test_without_adjectives_a_clip_joins_by_its_features() -> None:
    of = sources(4)
    space = define("Walks", of[:3], {})
    assert space_joining.predict(space, of[0], of[3]).can_join
    version = space_joining.renew(space, of, {})
    assert [one.clip for one in version.examples] == [one.id for one in of]
    assert not any(one.predicted for one in version.examples)
    assert version.features == define("Walks", of, {}).features


def test_targets_are_the_same_by_seed_and_lie_far_from_each_other() -> None:
    of = sources()
    space = judged(of)
    targets, again, others = (
        space_targets.draw(space, contents(of), TargetRequest(count=4, seed=seed)).targets
        for seed in (5, 5, 6)
    )
    assert targets == again != others
    assert [target.name for target in targets] == [f"Target {n}" for n in range(1, 5)]
    ready = Prepared.of(space, contents(of))
    drawn = np.random.default_rng(5).random((4, 2))  # as they would be without a choice
    plain = [
        Point(interface="adjectives", values={"primary_0": a, "primary_1": b}) for a, b in drawn
    ]
    for target in targets:
        point = Point(interface="adjectives", values=target.values)
        assert ready.recipe(point).operations == target.operations
    assert least_apart(ready, [t.weights for t in targets]) > least_apart(
        ready, [ready.weights(point).weights for point in plain]
    )


def least_apart(ready: Prepared, weights: list[list[float]]) -> float:
    clips = [ready.clip(row) for row in weights]
    return min(matching_distance(a, b) for n, a in enumerate(clips) for b in clips[:n])


def test_targets_need_adjectives() -> None:
    of = sources(3)
    with pytest.raises(InvalidError, match="nobody has judged"):
        space_targets.draw(define("Walks", of, {}), contents(of), TargetRequest())


def test_a_fresh_server_has_a_space_of_each_set_which_says_what_it_is(
    database: Database,
) -> None:
    samples.make(database, lambda: [*set_a(), *set_b()])
    with database.reading() as db:
        assert not spaces.has_samples(db)
    for _ in range(2):
        space_samples.make(database)
    with database.reading() as db:
        assert spaces.has_samples(db)
        found = {space.name: space for space in spaces.listed(db, 1).spaces}
        assert {name: space.number for name, space in found.items()} == dict.fromkeys(
            spaces.SAMPLES.values(), 1
        )
    for motion_set, name in spaces.SAMPLES.items():
        space = found[name]
        assert space.simulated
        definition = prepared(database, space.id).definition
        assert "Nobody has judged" in definition.origin.note
        assert [str(one.title).lower() for one in definition.adjectives.primary] != []
        assert {one.id for one in definition.adjectives.primary} == {
            "quickness", "clearness", "activeness", "largeness",
        }  # fmt: skip
        with database.reading() as db:
            clips = sample_clips(db, motion_set[-1].upper())
        assert {one.clip for one in definition.examples} == {clip.id for clip in clips}


def test_a_library_of_other_samples_gets_no_space(database: Database) -> None:
    samples.make(database, lambda: [*set_a()][:3])
    space_samples.make(database)
    with database.reading() as db:
        assert spaces.listed(db, 1).spaces == []


def test_what_many_ask_for_at_one_moment_is_made_once() -> None:
    kept: Recent[str, int] = Recent(2)
    made: list[str] = []
    together = threading.Barrier(8)

    def ask(_: int) -> int:
        together.wait()
        return kept.get("a", lambda: made.append("a") or len(made))

    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(ask, range(8))) == [1] * 8
    assert made == ["a"]


def test_the_last_ones_are_kept_and_what_cannot_be_made_pushes_out_none() -> None:
    kept: Recent[str, int] = Recent(2)
    made: list[str] = []

    def get(key: str) -> int:
        return kept.get(key, lambda: made.append(key) or len(made))

    def fail() -> int:
        raise KeyError("nobody")

    for key in ("a", "b", "a"):
        get(key)
    with pytest.raises(KeyError):
        kept.get("c", fail)
    get("b")
    get("a")
    assert made == ["a", "b"]
    get("d")  # pushes out b, which nobody asked for longest
    get("a")
    get("b")
    assert made == ["a", "b", "d", "b"]
