"""The bootstrap over participants, in one process or many."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

import numpy as np
import pytest

from app.errors import BusyError, InvalidError
from app.persistence.engine import Database
from app.services import impression_stability
from app.services.impression_bootstrap import Order, combined, piece, whole
from app.services.impressions import Live
from app.statistics import stability as statistics
from tests.app.conftest import InPlace
from tests.support import rated_pairs

GROUPS = [3, 2, 4]
SLUG, PART = "adjectives", rated_pairs.PART
THREE = Live(clusters=3)


@pytest.fixture
def database(db):
    """The test's own transaction, for what opens its database sessions itself."""
    return Database(db.connection())


@pytest.fixture
def study(db):
    ratings = rated_pairs.latent(8, 10, GROUPS)
    return rated_pairs.rated(db, rated_pairs.definition(10, sum(GROUPS)), ratings)


def computed(database, samples=60, seed=1, live=THREE):
    return impression_stability.stability(
        database, InPlace(), "", SLUG, PART, "participant", live, samples, seed
    )


def test_the_same_seed_gives_the_same_samples_and_another_one_others(database, study):
    assert computed(database) == computed(database)
    assert computed(database).rand_low != computed(database, seed=2) or (
        computed(database).clusters != computed(database, seed=2).clusters
    )


def test_clear_factors_are_found_again_and_every_pair_is_kept(database, study):
    found = computed(database)
    assert {pair.kept for pair in found.pairs} == {1.0}
    assert found.rand_mean == pytest.approx(1.0, abs=0.05)
    assert min(one.overlap for one in found.clusters) > 0.9
    assert found.sentence.startswith("With other participants of the same kind, 9 of the 9 kept")
    assert found.by_participants[0].participants < 8 < found.by_participants[-1].participants


def test_pure_noise_is_not_called_stable(db, database):
    noise = np.random.default_rng(3).integers(-2, 3, (6, 10, 9)).astype(float)
    rated_pairs.rated(db, rated_pairs.definition(10, 9), noise)
    found = computed(database, live=Live(0.0, 10.0, 3))
    assert found.rand_mean < 0.7
    assert "would not bring it to 0.9" in found.sentence


def test_up_to_a_thousand_samples_are_those_of_the_statistics_module(study):
    ratings = rated_pairs.latent(8, 10, GROUPS)
    ours = whole(Order(ratings, 1.0, 0.85, 3, 50, 7))
    generator = np.random.default_rng(np.random.SeedSequence(7).spawn(1)[0])
    theirs = statistics.stability(ratings, clusters=3, samples=50, generator=generator)
    np.testing.assert_array_equal(ours.rand, theirs.rand)
    np.testing.assert_array_equal(ours.kept_share, theirs.kept_share)
    assert ours.by_participants == theirs.by_participants


def test_several_processes_give_what_one_gives():
    order = Order(rated_pairs.latent(8, 10, GROUPS, noise=1.0), 1.0, 1.5, 3, 2100, 7)
    assert order.pieces == 3
    one = whole(order)
    with ThreadPoolExecutor(2) as pool:
        many = combined(list(pool.map(piece, [order] * 3, range(3))))
    assert len(one.rand) == 2100
    for ours, theirs in zip(one[:3], many[:3], strict=True):
        np.testing.assert_array_equal(ours, theirs)


def test_a_large_bootstrap_goes_through_the_engine(database, study, monkeypatch):
    small = computed(database)
    schedulers = []

    @contextmanager
    def engine(scheduler):
        schedulers.append(scheduler)
        with ThreadPoolExecutor(2) as pool:
            yield pool

    monkeypatch.setattr(impression_stability, "executor", engine)
    monkeypatch.setattr(impression_stability, "AT_ONCE", 1)
    assert computed(database) == small
    assert schedulers == [""]


def test_without_clusters_there_is_nothing_to_be_stable(database, study):
    with pytest.raises(InvalidError, match="no pair is kept"):
        computed(database, live=Live(most_spread=0.0))


def test_a_second_large_bootstrap_is_asked_to_wait(database, study, monkeypatch):
    monkeypatch.setattr(impression_stability, "AT_ONCE", 1)
    with impression_stability._engine, pytest.raises(BusyError, match="Another large bootstrap"):
        computed(database)
    assert not impression_stability._engine.locked()
