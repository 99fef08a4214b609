"""``manner simulate`` from the command line."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from sqlalchemy import func, select
from typer.testing import CliRunner, Result

from app.cli import app, main
from app.errors import MannerError
from app.persistence import schema
from app.persistence.engine import Database, make_engine
from app.persistence.models import StudySession
from app.settings import Settings
from app.studies import emotion
from tests.support.simulate import add_study

EFFECTS = "effects:\n  sad_happy:\n    sad: -1.5\n"


@pytest.fixture
def database(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Database:
    monkeypatch.setenv("MANNER_DATA_DIRECTORY", str(tmp_path))
    found = Database(make_engine(Settings().database))
    schema.upgrade(found.engine)
    with found.writing() as db:
        add_study(db)
    return found


@pytest.fixture
def effects(tmp_path: Path) -> Path:
    file = tmp_path / "effects.yaml"
    file.write_text(EFFECTS, "utf-8")
    return file


def run(*words: object) -> Result:
    return CliRunner().invoke(app, ["simulate", emotion.SLUG, *map(str, words)])


def stored(database: Database) -> int:
    with database.reading() as db:
        return db.scalar(select(func.count()).select_from(StudySession)) or 0


def test_it_stores_the_sessions_and_tells_what_was_found(database: Database, effects: Path) -> None:
    done = run("--participants", 8, "--effects", effects, "--dropout", 0.25, "--seed", 1)
    assert done.exit_code == 0
    assert "6 of 8 simulated participants are complete." in done.output
    assert f"/research/studies/{emotion.SLUG}?kind=simulated" in done.output
    assert "that “sad” is 1.50 steps less than the others is found here, p < .001" in done.output
    assert stored(database) == 8


def test_the_power_is_told_without_storing(database: Database, effects: Path) -> None:
    words = ("--participants", 12, "--effects", effects, "--no-store", "--repeat", 40, "--seed", 2)
    done = run(*words)
    assert "With 12 complete participants:" in done.output
    assert "is found in 100 % of 40 simulated runs (91 to 100 %)" in done.output
    assert stored(database) == 0
    assert run(*words).output == done.output


def test_a_wrong_file_stores_nothing_and_is_told(
    database: Database,
    effects: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    effects.write_text(EFFECTS.replace("sad_happy", "sad_hapy"), "utf-8")
    monkeypatch.setattr("sys.argv", ["manner", "simulate", emotion.SLUG, "--effects", str(effects)])
    with pytest.raises(SystemExit) as ended:
        main()
    assert ended.value.code == 1
    told = " ".join(capsys.readouterr().out.split())
    assert "effects.yaml, line 2: effects → sad_hapy" in told
    assert "Is “sad_happy” meant?" in told
    assert stored(database) == 0


def test_without_playwright_it_says_what_to_install_and_begins_nothing(
    database: Database, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "playwright.sync_api", None)
    done = run("--participants", 1, "--browsers", 1)
    assert isinstance(done.exception, MannerError)
    assert done.exception.code == "playwright_missing"
    assert "manner[dev]" in (done.exception.mend or "")
    assert stored(database) == 0
