"""The command line: prepare, import, the one-time link."""

from __future__ import annotations

import json
import re
from datetime import timedelta
from pathlib import Path

import numpy as np
import pytest
from sqlalchemy import select, update
from typer.testing import CliRunner, Result

from app.cli import app, main
from app.persistence import schema
from app.persistence.engine import Database, make_engine
from app.persistence.models import ClipRecord, Response, now
from app.services import command_line_imports, samples, sessions
from app.settings import Settings
from motion.procedural.library import acted
from tests.support import simulate
from tests.support.motions import faulty_bvh, walk_bvh, walks


@pytest.fixture
def settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Settings:
    monkeypatch.setenv("MANNER_DATA_DIRECTORY", str(tmp_path / "data"))
    monkeypatch.setattr(samples.make, "__defaults__", (walks, lambda done, total: None))
    return Settings()


def run(*words: object) -> Result:
    return CliRunner().invoke(app, [str(word) for word in words], env={"COLUMNS": "200"})


def states(settings: Settings) -> dict[str, str]:
    with Database(make_engine(settings.database)).reading() as db:
        return {clip.name: clip.state for clip in db.scalars(select(ClipRecord))}


def test_preparing_an_empty_folder_makes_everything_and_again_nothing(settings: Settings) -> None:
    first = run("prepare")
    assert first.exit_code == 0
    assert set(states(settings)) == {sample.name for sample in walks()}
    again = run("prepare")
    assert again.exit_code == 0
    assert "Making" not in again.output


def test_nothing_works_on_an_unprepared_database_but_says_why(settings: Settings) -> None:
    result = run("import", __file__)
    assert result.exit_code == 1
    assert "manner prepare" in result.output


def test_one_bad_file_fails_the_command_but_not_the_other_files(
    settings: Settings, tmp_path: Path
) -> None:
    run("prepare")
    (tmp_path / "bad.bvh").write_bytes(faulty_bvh())
    (tmp_path / "good.bvh").write_bytes(walk_bvh())
    result = run("import", tmp_path / "bad.bvh", tmp_path / "good.bvh")
    assert result.exit_code == 1
    assert re.search(r"✗ bad\.bvh\s+Line \d+, column \d+", result.output)
    assert "✓ good.bvh" in result.output
    assert states(settings)["good"] == "to_confirm"
    assert "bad" not in states(settings)


def test_many_files_are_read_side_by_side_and_told_in_order(
    settings: Settings, tmp_path: Path
) -> None:
    run("prepare")
    paths = [tmp_path / f"walk_{number:02}.bvh" for number in range(command_line_imports.MANY)]
    for number, path in enumerate(paths):
        path.write_bytes(faulty_bvh() if number == 3 else walk_bvh() + b"\n" * number)
    gone = tmp_path / "gone.bvh"
    database = Database(make_engine(settings.database))
    told = list(command_line_imports.import_paths(database, [*paths, gone], confirm=True))
    assert [line.text.split()[1] for line in told] == [path.name for path in [*paths, gone]]
    assert [line.text.split()[1] for line in told if line.failed] == [paths[3].name, gone.name]
    assert told[0].text.startswith("✓")
    assert all("in the library already" in line.text for line in told[1:] if not line.failed)
    assert states(settings)["walk_00"] == "kept"


def test_yes_confirms_what_was_guessed(settings: Settings, tmp_path: Path) -> None:
    run("prepare")
    (tmp_path / "walk.bvh").write_bytes(walk_bvh())
    assert run("import", "--yes", tmp_path / "walk.bvh").exit_code == 0
    assert states(settings)["walk"] == "kept"
    again = run("import", tmp_path / "walk.bvh")
    assert again.exit_code == 0
    assert "is in the library already" in again.output


def test_foergers_set_is_made_from_the_two_neutral_clips_and_only_once(
    settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    neutral = [sample for sample in acted() if sample.tags["emotion"] == "neutral"]
    monkeypatch.setattr(samples.make, "__defaults__", (lambda: neutral, lambda done, total: None))
    run("prepare")
    first = run("make-set", "foerger")
    assert first.exit_code == 0
    assert "20 of 20 clips" in first.output
    made = states(settings)
    assert "acted_female_neutral · masculine" in made
    assert "acted_male_neutral · energetic sadness" in made
    assert run("make-set", "foerger").exit_code == 0
    assert states(settings) == made
    assert len(made) == 22


def test_a_set_without_its_samples_says_how_to_get_them(settings: Settings) -> None:
    run("prepare")
    result = run("make-set", "foerger")
    assert result.exit_code == 1
    assert "manner prepare" in str(result.exception.mend)


def test_the_set_up_link_stands_whole_on_one_line(settings: Settings) -> None:
    run("prepare")
    output = run("set-up-link").output
    assert re.search(r"^ +http://127\.0\.0\.1:8000/research/set-up/[\w-]{32}$", output, re.M)


@pytest.mark.parametrize(
    ("public_url", "words", "address"),
    [
        (None, ["--port", "8110"], "http://127.0.0.1:8110"),
        (None, ["--host", "0.0.0.0"], "http://127.0.0.1:8000"),
        ("https://study.example.org", ["--port", "8110"], "https://study.example.org"),
    ],
)
def test_the_first_start_links_to_where_the_server_is_reached(
    settings: Settings, monkeypatch: pytest.MonkeyPatch,
    public_url: str | None, words: list[str], address: str,
) -> None:  # fmt: skip
    run("prepare")
    monkeypatch.setattr("uvicorn.run", lambda *_, **__: None)
    if public_url:
        monkeypatch.setenv("MANNER_PUBLIC_URL", public_url)
    assert f"  {address}/research/set-up/" in run("serve", *words).output


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("MANNER_UPLOAD_LIMIT", "many"),
        ("MANNER_SIGN_IN_ATTEMPTS", "lots"),
        ("MANNER_DATABASE_URL", "geheim"),
        ("MANNER_PUBLIC_URL", "study.example.org"),
    ],
)
def test_a_wrong_setting_stops_the_command_with_one_line_that_names_it(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], name: str, value: str
) -> None:
    monkeypatch.setenv(name, value)
    monkeypatch.setattr("sys.argv", ["manner", "prepare"])
    with pytest.raises(SystemExit) as stopped:
        main()
    told = capsys.readouterr().out
    assert stopped.value.code == 1
    assert told.startswith(f"{name}: ")
    assert "Traceback" not in told
    assert "geheim" not in told


def test_the_openapi_document_is_printed_without_touching_a_database(settings: Settings) -> None:
    result = run("openapi")
    assert json.loads(result.stdout)["openapi"].startswith("3.")
    assert not settings.data_directory.exists()


def test_the_sweep_deletes_what_its_study_keeps_no_longer(settings: Settings) -> None:
    database = Database(make_engine(settings.database))
    schema.upgrade(database.engine)
    with database.writing() as db:
        simulate.add_study(db)
        token = simulate.take_part(simulate.directly(db), np.random.default_rng(1), answered=2)
        db.commit()
    assert "Deleted: 0 participants." in run("sweep").stdout
    with database.writing() as db:
        session = sessions.open_session(db, token)
        session.study.running = {"retention_days": 1}
        long_ago = now() - timedelta(days=3)
        session.created_at = long_ago
        db.execute(update(Response).values(received_at=long_ago))
        db.commit()
    assert "Deleted: 1 participant." in run("sweep").stdout
    with database.reading() as db:
        assert sessions.open_session(db, token).state == "withdrawn"
    database.engine.dispose()
