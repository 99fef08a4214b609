"""Many clips at once: all or none accepted, each made once, whatever happens meanwhile."""

from __future__ import annotations

import hashlib
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from concurrent.futures.process import BrokenProcessPool
from uuid import UUID

import pytest

from app.errors import ConflictError, InvalidError
from app.persistence import clips, jobs, poses, researchers
from app.persistence.engine import Database, make_engine
from app.persistence.locks import job_lock
from app.persistence.models import PoseRecord
from app.persistence.writer import Writer
from app.schemas.edits import ClipRequest
from app.schemas.jobs import Batch, JobDetail
from app.services import batches, catalogue, edits, library, samples
from app.services.job_pool import JobPool
from app.services.job_runner import JobRunner
from tests.support.motions import walks

PATIENCE = 120  # seconds until a test gives up waiting


class HerePool(JobPool):
    """Does the work in this process, one piece after the other, with a hook before each."""

    def __init__(self, before: Callable[[int], None] = lambda piece: None) -> None:
        super().__init__(processes=1)
        self.before = before
        self.pieces = 0

    def submit(self, function, *arguments):
        promise: Future = Future()
        self.pieces += 1
        try:
            self.before(self.pieces)
            promise.set_result(function(*arguments))
        except Exception as error:
            promise.set_exception(error)
        return promise


@pytest.fixture
def database(database_url: str) -> Iterator[Database]:
    database = Database(make_engine(database_url))
    samples.make(database, walks)
    with database.writing() as db:
        researchers.add(db, email="rosa@example.org", name="Rosa", password_hash="-")
        db.commit()
    yield database
    database.engine.dispose()


@pytest.fixture
def runner(database: Database) -> Iterator[Callable[[JobPool], JobRunner]]:
    """Starts runners, and ends them with the test."""
    started: list[tuple[JobRunner, Writer]] = []

    def start(pool: JobPool) -> JobRunner:
        writer = Writer(database)
        started.append((JobRunner(database, writer, pool), writer))
        return started[-1][0]

    yield start
    for one, writer in started:
        one.close()
        writer.close()


def walk_ids() -> list[str]:
    return [walk.clip.content_hash for walk in walks()]


def tempo(factor: float) -> list[dict]:
    return [{"operation": "tempo@1", "parameters": {"factor": factor}}]


def tempos(count: int) -> Batch:
    """So many small edits of the walks in turn."""
    items = [
        {
            "source": walk_ids()[i % 3],
            "operations": tempo(1 + (i + 1) / 1000),
            "name": f"clip {i}",
            "tags": {"set": "test", "number": str(i)},
        }
        for i in range(count)
    ]
    return Batch.model_validate({"items": items})


def submit(database: Database, batch: Batch) -> UUID:
    with database.writing() as db:
        return batches.submit(db, 1, batch).id


def find(database: Database, job_id: UUID) -> JobDetail:
    with database.reading() as db:
        return batches.find(db, job_id)


def until(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, "it never came true"
        time.sleep(0.02)


def ended(database: Database, job_id: UUID) -> JobDetail:
    until(lambda: find(database, job_id).ended_at is not None)
    return find(database, job_id)


def edited(database: Database) -> list:
    with database.reading() as db:
        return [clip for clip, _ in clips.listed(db, imported=True) if clip.source == "edited"]


def test_every_item_becomes_the_clip_it_asks_for_in_its_place(database: Database, runner) -> None:
    job_id = submit(database, tempos(40))
    runner(HerePool())
    job = ended(database, job_id)
    assert (job.state, job.total, job.done, job.failed) == ("done", 40, 40, 0)
    with database.reading() as db:
        for i, (item, asked) in enumerate(zip(job.items, tempos(40).items, strict=True)):
            clip = clips.by_id(db, item.clip)
            assert (clip.name, item.name) == (f"clip {i}", f"clip {i}")
            assert clip.tags == {"set": "test", "number": str(i)}
            assert clip.recipe_source == asked.source == item.source
            assert clip.recipe[0]["parameters"]["factor"] == 1 + (i + 1) / 1000
            assert clip.id == edits.edited_id(asked.source, edits.read_recipe(asked))


def test_the_processes_of_a_pool_make_the_same_as_this_one(database: Database, runner) -> None:
    batch = Batch(sources=walk_ids(), presets=["sad", "angry"])
    job = ended(database, (submit(database, batch), runner(JobPool()))[0])
    assert (job.state, job.done) == ("done", 6)
    hashes = {clip.id: clip.content_hash for clip in edited(database)}
    from app.services.rendering import Supplies, render
    from motion.recipe import PRESETS
    from motion.storage import clip_to_bytes

    for item, preset in zip(job.items, ["sad", "angry"] * 3, strict=True):
        source = next(w.clip for w in walks() if w.clip.content_hash == item.source)
        steps = PRESETS[preset].operations.to_list()
        assert render(clip_to_bytes(source), steps, Supplies(), 1.7).id == hashes[item.clip]


def test_one_clip_that_cannot_be_made_does_not_hinder_the_rest(database: Database, runner) -> None:
    batch = tempos(5)
    batch.items[2].operations = [{"operation": "cut@1", "parameters": {"start": 0, "end": 900}}]
    job = ended(database, (submit(database, batch), runner(HerePool()))[0])
    assert (job.state, job.done, job.failed) == ("done", 4, 1)
    assert [item.clip is None for item in job.items] == [False, False, True, False, False]
    assert "cut" in job.items[2].error.lower()
    assert len(edited(database)) == 4


def test_a_job_of_which_nothing_can_be_made_has_failed(database: Database, runner) -> None:
    batch = tempos(1)
    batch.items[0].operations = [{"operation": "cut@1", "parameters": {"start": 0, "end": 900}}]
    job = ended(database, (submit(database, batch), runner(HerePool()))[0])
    assert (job.state, job.done, job.failed) == ("failed", 0, 1)


@pytest.mark.parametrize(
    ("wrong", "code"),
    [
        ({"preset": "furious"}, "preset_unknown"),
        ({"operations": [{"operation": "grid@1", "parameters": {"path": 7}}]}, "recipe_invalid"),
        ({"source": "0" * 64, "preset": "sad"}, "clip_not_found"),
        (
            {"operations": [{"operation": "posture@1",
              "parameters": {"offsets": [{"pose": "a" * 64, "amount": 1}]}}]},
            "recipe_invalid",
        ),
    ],
)  # fmt: skip
def test_a_wrong_item_is_named_and_nothing_begins(
    database: Database, wrong: dict, code: str
) -> None:
    batch = tempos(3)
    batch.items[1] = ClipRequest.model_validate({"source": walk_ids()[0], **wrong})
    with pytest.raises(InvalidError) as refused:
        submit(database, batch)
    assert refused.value.where["item"] == 1
    assert refused.value.message.startswith("Item 2: ")
    assert refused.value.code == code
    with database.reading() as db:
        assert batches.listed(db).jobs == []


def test_what_is_there_already_is_not_made_again(database: Database, runner) -> None:
    first, second = HerePool(), HerePool()
    one = runner(first)
    before = ended(database, submit(database, tempos(20)))
    one.close()
    runner(second)
    after = ended(database, submit(database, tempos(20)))
    assert [item.clip for item in after.items] == [item.clip for item in before.items]
    assert (after.state, after.done) == ("done", 20)
    assert (first.pieces > 0, second.pieces) == (True, 0)
    assert len(edited(database)) == 20


def test_the_same_clip_asked_for_twice_in_a_job_is_made_once(database: Database, runner) -> None:
    batch = Batch(items=[*tempos(2).items, *tempos(2).items])
    job = ended(database, (submit(database, batch), runner(HerePool()))[0])
    assert (job.done, job.failed) == (4, 0)
    assert [item.clip for item in job.items[:2]] == [item.clip for item in job.items[2:]]
    assert len(edited(database)) == 2


def test_cancelling_stops_and_keeps_what_is_done(database: Database, runner) -> None:
    reached, go_on = threading.Event(), threading.Event()

    def before(piece: int) -> None:
        if piece == 3:
            reached.set()
            go_on.wait(PATIENCE)

    job_id = submit(database, tempos(200))
    runner(HerePool(before))
    assert reached.wait(PATIENCE)
    with database.writing() as db:
        cancelled = batches.cancel(db, job_id)
    go_on.set()
    next_id = submit(database, tempos(1))
    ended(database, next_id)  # the runner has gone on, so the cancelled job is left
    job = find(database, job_id)
    assert job.state == cancelled.state == "cancelled"
    assert job.items == cancelled.items  # nothing more was written down after the answer
    assert 0 < job.done < 200
    kept = {item.clip for item in job.items if item.clip}
    assert kept <= {clip.id for clip in edited(database)}
    assert len(kept) == job.done


def test_a_job_that_waits_is_cancelled_before_it_begins(database: Database) -> None:
    job_id = submit(database, tempos(3))
    with database.writing() as db:
        assert batches.cancel(db, job_id).state == "cancelled"
        assert batches.cancel(db, job_id).state == "cancelled"
        assert jobs.claim(db) is None


def test_a_job_that_is_done_cannot_be_cancelled_any_more(database: Database, runner) -> None:
    job = ended(database, (submit(database, tempos(2)), runner(HerePool()))[0])
    with database.writing() as db:
        assert batches.cancel(db, job.id) == job


def test_a_job_goes_on_where_its_server_left_it(database: Database, runner) -> None:
    held = threading.Event()
    first = HerePool(lambda piece: held.set() if piece == 3 else None)
    job_id = submit(database, tempos(200))
    one = runner(first)
    assert held.wait(PATIENCE)
    one.close()
    left = find(database, job_id)
    assert left.state == "running"
    assert 0 < left.done < 200
    second = HerePool()
    runner(second)
    job = ended(database, job_id)
    assert (job.state, job.done) == ("done", 200)
    assert job.started_at == left.started_at
    assert first.pieces + second.pieces < 2 * len(edited(database)) / 16 + 3  # nothing twice
    made = {i: item.clip for i, item in enumerate(left.items) if item.clip}
    assert {i: job.items[i].clip for i in made} == made


def test_only_one_of_two_servers_works(database: Database, runner) -> None:
    other = Database(make_engine(database.engine.url.render_as_string(hide_password=False)))
    pool = HerePool()
    with job_lock(other.engine) as held:
        assert held
        with job_lock(database.engine) as again:
            assert not again
        runner(pool)
        job_id = submit(database, tempos(2))
        with job_lock(database.engine) as again:
            assert not again
        assert find(database, job_id).state == "waiting"
    job = ended(database, job_id)  # the lock is free: the other takes over
    assert (job.state, pool.pieces) == ("done", 2)
    other.engine.dispose()


def test_jobs_are_taken_in_their_order(database: Database, runner) -> None:
    ids = [submit(database, tempos(2)) for _ in range(4)]
    runner(HerePool())
    done = [ended(database, job_id) for job_id in ids]
    starts = [job.started_at for job in done]
    assert starts == sorted(starts)
    with database.reading() as db:
        assert [job.id for job in batches.listed(db).jobs] == ids[::-1]


def test_a_clip_that_kills_its_process_is_named_and_the_rest_is_made(
    database: Database, runner
) -> None:
    batch = tempos(6)
    deadly = batch.items[3].operations

    class Deadly(HerePool):
        def submit(self, function, *arguments):
            if any(steps[0]["parameters"]["factor"] == deadly[0]["parameters"]["factor"]
                   for steps, _ in arguments[2]):  # fmt: skip
                promise: Future = Future()
                promise.set_exception(BrokenProcessPool("killed"))
                return promise
            return super().submit(function, *arguments)

    job = ended(database, (submit(database, batch), runner(Deadly()))[0])
    assert (job.state, job.done, job.failed) == ("done", 5, 1)
    assert "memory" in job.items[3].error


def test_a_source_deleted_meanwhile_is_told(database: Database, runner) -> None:
    first, second = submit(database, tempos(1)), tempos(1)
    one = runner(HerePool())
    made = ended(database, first).items[0].clip
    one.close()
    second.items[0].source = made
    of_edited = submit(database, second)
    with database.writing() as db:
        clips.delete(db, clips.by_id(db, made))
        db.commit()
    runner(HerePool())
    job = ended(database, of_edited)
    assert (job.state, job.items[0].error) == ("failed", "Its source was deleted meanwhile.")


def test_what_a_job_still_needs_stays(database: Database, runner) -> None:
    first, second = submit(database, tempos(1)), tempos(1)
    one = runner(HerePool())
    made = ended(database, first).items[0].clip
    one.close()
    with database.writing() as db:
        turns = {"head": [1.0, 0.0, 0.0, 0.0]}
        poses.put(db, PoseRecord(id="a" * 64, name="bent", rotations=turns, frame=0))
        db.commit()
    offsets = [{"pose": "a" * 64, "amount": 1.0}]
    posture = [{"operation": "posture@1", "parameters": {"offsets": offsets}}]
    second.items[0] = ClipRequest(source=made, operations=posture)
    job = submit(database, second)
    for delete, what in ((library.delete, made), (catalogue.delete_pose, "a" * 64)):
        with database.writing() as db, pytest.raises(ConflictError, match="job"):
            delete(db, what)
    with database.writing() as db:
        batches.cancel(db, job)
        library.delete(db, made)
        catalogue.delete_pose(db, "a" * 64)
    assert edited(database) == []


def test_too_many_clips_are_refused_at_once(database: Database) -> None:
    batch = Batch(sources=walk_ids(), presets=["sad"] * 2000)
    with database.writing() as db:
        assert len(batches.submit(db, 1, batch).items) == 3  # each once
    names = [hashlib.sha256(str(i).encode()).hexdigest() for i in range(2001)]
    with pytest.raises(ValueError, match="2000"):
        Batch(sources=names, presets=["sad"])
