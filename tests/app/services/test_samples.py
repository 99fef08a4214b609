"""The sample library: made once, whole, and made anew by another engine."""

from __future__ import annotations

import pytest
from sqlalchemy import Engine, select

from app.persistence import clips
from app.persistence.engine import Database
from app.persistence.models import ClipRecord
from app.services import clip_files, library, samples
from app.services.engine_version import engine_version
from motion.kinematics import forward_kinematics
from motion.storage import clip_from_bytes
from tests.support.motions import walk, walks


@pytest.fixture
def database(engine: Engine) -> Database:
    return Database(engine)


def records(database: Database) -> dict[str, ClipRecord]:
    with database.reading() as db:
        return {clip.name: clip for clip in db.scalars(select(ClipRecord))}


def test_the_library_is_ready_once_it_is_made(database: Database) -> None:
    with database.reading() as db:
        assert not clips.has_samples_of(db, engine_version())
    samples.make(database, walks)
    with database.reading() as db:
        assert clips.has_samples_of(db, engine_version())
        assert not clips.has_samples_of(db, "another engine")


def test_a_skeleton_gets_one_figure_whatever_the_number_of_its_clips(database: Database) -> None:
    samples.make(database, walks)
    made = records(database)
    assert len(made) == len(walks())
    with database.reading() as db:
        hashes = {clip.skeleton_hash for clip in made.values()}
        assert all(clips.figure(db, skeleton) for skeleton in hashes)


def test_samples_of_an_older_engine_leave_the_library_but_not_the_database(
    database: Database, monkeypatch: pytest.MonkeyPatch
) -> None:
    samples.make(database, walks)
    monkeypatch.setattr(library, "engine_version", lambda: "newer")
    monkeypatch.setattr(samples, "engine_version", lambda: "newer")
    samples.make(database, lambda: walks()[:2])
    states = {name: clip.state for name, clip in records(database).items()}
    assert [states[sample.name] for sample in walks()] == ["kept", "kept", "retired"]
    with database.reading() as db:
        assert len(clips.listed(db, imported=True)) == 2


def test_a_fault_while_making_them_leaves_none(database: Database) -> None:
    def break_off() -> object:
        yield walks()[0]
        raise RuntimeError("out of memory")

    with pytest.raises(RuntimeError):
        samples.make(database, break_off)
    assert records(database) == {}


def test_progress_names_every_sample(database: Database) -> None:
    heard: list[str] = []
    samples.make(database, walks, heard.append)
    assert heard == [sample.name for sample in walks()]


def test_the_poster_shows_a_wide_stride_of_the_middle_half() -> None:
    clip = walk()
    time = clip_files.poster_time(clip)
    frame = round(time / clip.frame_time)
    feet = [clip.skeleton.roles[f"{side}_foot"] for side in ("left", "right")]
    positions = forward_kinematics(clip).positions[:, feet]
    spread = ((positions[:, 0] - positions[:, 1]) ** 2).sum(axis=1)
    middle = range(clip.frames // 4, clip.frames * 3 // 4)
    assert frame in middle
    assert spread[frame] == max(spread[list(middle)])


def test_a_clip_without_feet_is_shown_at_its_middle() -> None:
    clip = walk()
    bare = clip.skeleton.with_roles({})
    from dataclasses import replace

    headless = replace(clip, skeleton=bare)
    assert clip_files.poster_time(headless) == clip.duration / 2
    assert clip_files.make_figure(headless) is None


def test_the_stored_clip_is_the_clip() -> None:
    files = clip_files.make_files(walk())
    assert clip_from_bytes(files.clip).content_hash == files.id == walk().content_hash
