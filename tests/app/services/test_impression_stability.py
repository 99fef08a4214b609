"""The bootstrap over participants, at once or as a job."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from app.errors import ConflictError, InvalidError, NotFoundError
from app.persistence import jobs
from app.persistence.engine import Database, make_engine
from app.persistence.models import Researcher
from app.persistence.writer import Writer
from app.schemas.impressions import Agreement, ByParticipants
from app.schemas.jobs import JobDetail
from app.services import batches, impression_run, impression_stability, job_runner, rights
from app.services.impression_bootstrap import Order, combined, piece, whole
from app.services.impression_enough import enough
from app.services.impressions import Live
from app.services.job_pool import JobPool
from app.services.job_runner import JobRunner
from app.statistics.stability import Bootstrap, sizes
from tests.app.conftest import InPlace
from tests.support import rated_pairs

GROUPS = [3, 2, 4]
SLUG, PART = "adjectives", rated_pairs.PART
THREE = Live(clusters=3)
PATIENCE = 120  # seconds until a test gives up waiting


class ThreadPool(JobPool):
    """Computes in a thread, which a test can hold before each piece."""

    def __init__(self) -> None:
        super().__init__(processes=1)
        self.may_go = threading.Event()
        self._thread = ThreadPoolExecutor(1)

    def submit(self, function, *arguments):
        def held():
            assert self.may_go.wait(PATIENCE)
            return function(*arguments)

        return self._thread.submit(held)

    def close(self) -> None:
        pass


@pytest.fixture
def database(database_url: str) -> Iterator[Database]:
    database = Database(make_engine(database_url))
    with database.writing() as db:
        db.add(Researcher(email="rosa@example.org", name="Rosa", password_hash="-"))
        db.commit()
    yield database
    database.engine.dispose()


@pytest.fixture
def study(database):
    put(database, rated_pairs.latent(8, 10, GROUPS))


@pytest.fixture
def pool(database, monkeypatch) -> Iterator[ThreadPool]:
    """What a server's runner computes with; it waits until it may go."""
    monkeypatch.setattr(job_runner, "LOOK_EVERY", 0.05)
    pool, writer = ThreadPool(), Writer(database)
    runner = JobRunner(database, writer, pool)
    yield pool
    pool.may_go.set()
    runner.close()
    writer.close()


def put(database, ratings):
    with database.writing() as db:
        rated_pairs.rated(db, rated_pairs.definition(10, sum(GROUPS)), ratings)


def access(database):
    with database.reading() as db:
        return rights.access(db, SLUG, 1, "view")


def computed(database, samples=60, seed=1, live=THREE):
    return impression_stability.stability(
        database, InPlace(), access(database), PART, "participant", live, samples, seed
    )


def result(database, job_id):
    with database.reading() as db:
        return impression_stability.result(db, access(database), PART, job_id)


def until(database, job_id, state) -> JobDetail:
    end = time.monotonic() + PATIENCE
    while True:
        with database.reading() as db:
            found = batches.find(db, job_id)
        if found.state == state:
            return found
        assert time.monotonic() < end, f"it is {found.state} and never was {state}"
        time.sleep(0.02)


def test_the_same_seed_gives_the_same_samples_and_another_one_others(database):
    put(database, rated_pairs.latent(8, 10, GROUPS, noise=1.2))
    assert computed(database) == computed(database)
    assert computed(database).pairs != computed(database, seed=2).pairs


def test_clear_factors_are_found_again_and_every_pair_is_kept(database, study):
    found = computed(database)
    assert {pair.kept for pair in found.pairs} == {1.0}
    assert found.whole.mean == pytest.approx(1.0, abs=0.05)
    assert found.shared == found.whole  # nothing is left out
    assert min(one.overlap for one in found.clusters) > 0.9
    assert found.sentence.startswith("With other participants of the same kind, 9 of the 9 kept")
    tried = [one.participants for one in found.by_participants]
    assert tried == sizes(8)
    assert found.enough.whole in tried
    assert f"from about {found.enough.whole} participants on" in found.enough.sentence


def test_pure_noise_is_not_called_stable(database):
    put(database, np.random.default_rng(3).integers(-2, 3, (6, 10, 9)).astype(float))
    found = computed(database, live=Live(0.0, 10.0, 3))
    assert found.whole.mean < 0.7
    assert found.enough.whole is None
    assert "with 12 participants the index is 0." in found.enough.sentence


def test_enough_participants_are_the_least_from_which_on_the_index_is_good():
    def at(participants, whole, shared):
        index = shared and Agreement(mean=shared, low=shared - 0.2, high=1)
        return ByParticipants(
            participants=participants, whole=Agreement(mean=whole, low=whole - 0.3, high=1),
            shared=index, kept_alike=0.9,
        )  # fmt: skip

    tried = [at(4, 0.92, None), at(8, 0.85, 0.91), at(14, 0.9, 0.95), at(28, 0.97, 0.99)]
    found = enough(tried)
    assert (found.whole, found.shared, found.most) == (14, 8, 28)
    assert "with 14 it is 0.90 (95 % of draws: 0.60 to 1.00)" in found.sentence
    assert "0.91 (95 % of draws: 0.71 to 1.00) with 8." in found.sentence
    assert enough(tried[:2]).whole is None


def test_every_piece_is_drawn_by_its_own_seed():
    ratings = rated_pairs.latent(8, 10, GROUPS, noise=1.0)
    order = Order(ratings, 1.0, 1.5, 3, 120, 7)
    ours, bootstrap = whole(order), Bootstrap.of(ratings, most_spread=1.5, clusters=3)
    seeds = np.random.SeedSequence(7).spawn(order.pieces)
    first, second = (
        bootstrap.drawn(count, np.random.default_rng(seed))
        for count, seed in zip((100, 20), seeds, strict=False)
    )
    np.testing.assert_array_equal(ours.whole, [*first.whole, *second.whole])
    kept_share = (100 * first.kept_share + 20 * second.kept_share) / 120
    np.testing.assert_allclose(ours.kept_share, kept_share)
    assert [one.participants for one in ours.by_participants] == sizes(8)
    last = bootstrap.by_size(16, 24, np.random.default_rng(seeds[-1]))
    assert ours.by_participants[-1] == last


def test_several_processes_give_what_one_gives():
    order = Order(rated_pairs.latent(8, 10, GROUPS, noise=1.0), 1.0, 1.5, 3, 600, 7)
    with ThreadPoolExecutor(2) as pool:
        many = combined(list(pool.map(piece, [order] * order.pieces, range(order.pieces))))
    one = whole(order)
    assert len(one.whole) == 600
    for ours, theirs in zip(one[:4], many[:4], strict=True):
        np.testing.assert_array_equal(ours, theirs)
    assert one.by_participants == many.by_participants


def test_a_large_bootstrap_becomes_a_job_with_the_same_result(database, study, pool, monkeypatch):
    small = computed(database)
    monkeypatch.setattr(impression_stability, "AT_ONCE", 1)
    job = computed(database)
    assert (job.kind, job.done, job.items) == ("stability", 0, [])
    assert until(database, job.id, "running").total == 1 + len(sizes(8))
    with pytest.raises(ConflictError, match="it is running"):
        result(database, job.id)
    pool.may_go.set()
    ended = until(database, job.id, "done")
    assert ended.done == ended.total
    assert result(database, job.id) == small


def test_a_cancelled_bootstrap_is_given_up(database, study, pool, monkeypatch):
    monkeypatch.setattr(impression_stability, "AT_ONCE", 1)
    first, second = computed(database), computed(database)
    until(database, first.id, "running")
    with database.writing() as db:
        assert batches.cancel(db, first.id).state == "cancelled"
    until(database, second.id, "running")  # its turn has come
    with pytest.raises(ConflictError, match="it is cancelled"):
        result(database, first.id)


def test_a_bootstrap_that_a_killed_server_left_is_begun_again(database, study, pool, monkeypatch):
    small = computed(database)
    monkeypatch.setattr(impression_stability, "AT_ONCE", 1)
    monkeypatch.setattr(jobs, "OPEN", ("running",))  # the runner overlooks what waits
    job = computed(database)
    with database.writing() as db:
        jobs.by_id(db, job.id).state = "running"
        jobs.by_id(db, job.id).done = 3
        db.commit()
    pool.may_go.set()
    until(database, job.id, "done")
    assert result(database, job.id) == small


def test_a_bootstrap_whose_clusters_are_gone_meanwhile_fails(database, study, pool, monkeypatch):
    monkeypatch.setattr(impression_stability, "AT_ONCE", 1)

    def gone(*_: object) -> None:
        raise InvalidError("Nobody is left.", code="no_clusters", mend="Wait for answers.")

    monkeypatch.setattr(impression_run, "prepared", gone)
    assert until(database, computed(database).id, "failed").done == 0


def test_another_parts_job_has_no_result_here(database, study, monkeypatch):
    monkeypatch.setattr(impression_stability, "AT_ONCE", 1)
    job = computed(database)
    with database.reading() as db, pytest.raises(NotFoundError, match="no such job"):
        impression_stability.result(db, access(database), "another_part", job.id)


def test_without_clusters_there_is_nothing_to_be_stable(database, study):
    with pytest.raises(InvalidError, match="no pair is kept"):
        computed(database, live=Live(most_spread=0.0))
