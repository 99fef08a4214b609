"""The sample library: made once, whole, and made anew by another engine."""

from __future__ import annotations

import pytest
from sqlalchemy import Engine, select

from app.persistence import blobs, clips
from app.persistence.engine import Database
from app.persistence.models import ClipRecord
from app.services import clip_files, imports, library, renewal, samples
from app.services.engine_version import engine_version
from motion.kinematics import forward_kinematics
from motion.storage import clip_from_bytes
from tests.support.motions import walk, walk_bvh, walks


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


def test_an_imported_clip_gets_new_files_from_a_newer_engine_and_stays_the_same_motion(
    database: Database, monkeypatch: pytest.MonkeyPatch
) -> None:
    clip_id = imports.import_file(database, "walk.bvh", walk_bvh()).clip.id
    before = records(database)["walk"]
    assert renewal.renew_imported(database) == 0
    with database.reading() as db:
        old_figure = clips.figure(db, before.skeleton_hash)
    for module in (renewal, library):
        monkeypatch.setattr(module, "engine_version", lambda: "newer")
    monkeypatch.setattr(clip_files, "write_clip_glb", lambda clip: b"glTF of the newer engine")
    monkeypatch.setattr(clip_files, "write_figure_glb", lambda figure: b"glTF of a newer figure")
    assert renewal.renew_imported(database) == 1
    after = records(database)["walk"]
    with database.reading() as db:
        new_figure = clips.figure(db, after.skeleton_hash)
        assert blobs.content(db, after.glb_blob) == b"glTF of the newer engine"
        assert blobs.content(db, before.glb_blob) is None
    assert new_figure.glb_blob != old_figure.glb_blob
    assert (after.id, after.clip_blob, after.state) == (clip_id, before.clip_blob, before.state)
    assert after.report == before.report
    assert renewal.renew_imported(database) == 0


def test_a_fault_while_making_them_leaves_none(database: Database) -> None:
    def break_off() -> object:
        yield walks()[0]
        raise RuntimeError("out of memory")

    with pytest.raises(RuntimeError):
        samples.make(database, break_off)
    assert records(database) == {}


def test_progress_is_told_after_every_sample(database: Database) -> None:
    heard: list[tuple[int, int]] = []
    samples.make(database, walks, lambda *progress: heard.append(progress))
    assert heard == [(1, 3), (2, 3), (3, 3)]


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
