"""``manner study``: files checked by line, begun from templates, published."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from sqlalchemy import select
from typer.testing import CliRunner, Result

from app.cli import app
from app.persistence import researchers
from app.persistence.engine import Database, make_engine
from app.persistence.models import ClipRecord, Study, StudyVersion
from app.services import command_line_studies, samples, study_files
from app.settings import Settings
from app.studies import TEMPLATES
from tests.support.motions import walks


class Here:
    """Does in this process what workers do."""

    def run(self, _: str, function, *arguments):
        return function(*arguments)

    def close(self) -> None:
        pass


@pytest.fixture
def settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Settings:
    monkeypatch.setenv("MANNER_DATA_DIRECTORY", str(tmp_path / "data"))
    monkeypatch.setattr(samples.make, "__defaults__", (walks, lambda done, total: None))
    monkeypatch.setattr(command_line_studies, "Workers", Here)
    return Settings()


@pytest.fixture
def database(settings: Settings) -> Database:
    """Prepared, with a researcher."""
    assert run("prepare").exit_code == 0
    database = Database(make_engine(settings.database))
    with database.writing() as db:
        researchers.add(db, email="rosa@example.org", name="Rosa", password_hash="-")
        db.commit()
    return database


def run(*words: object) -> Result:
    return CliRunner().invoke(app, ["study", *map(str, words)] if words[0] != "prepare" else words)


def study_file(folder: Path, *stimuli: object, **members: object) -> Path:
    """A small study in a file."""
    document = TEMPLATES["adjectives-short"].build() | members
    document["parts"][2]["stimuli"] = list(stimuli) or ["set_a_neutral", "set_a_proud"]
    path = folder / "study.yaml"
    path.write_text(study_files.write(document), encoding="utf-8")
    return path


@pytest.mark.parametrize("name", TEMPLATES)
def test_a_new_file_of_every_template_has_no_faults(
    settings: Settings, tmp_path: Path, name: str
) -> None:
    made = run("new", name)
    assert made.stdout.startswith("# ")
    path = tmp_path / "study.yaml"
    path.write_text(made.stdout, encoding="utf-8")
    checked = run("check", path)
    assert (checked.exit_code, checked.output.count("\n")) == (0, 1)
    assert "no faults" in checked.output
    assert not settings.data_directory.exists()


def test_the_templates_and_their_options_are_listed(settings: Settings) -> None:
    listed = run("new").output
    assert all(name in listed for name in TEMPLATES)
    assert "--set from=" in listed
    assert "gain: 0.25" in run("new", "most-natural", "--set", "from=0.25").output


def test_an_unknown_template_or_option_is_told_with_the_known_ones(settings: Settings) -> None:
    assert "adjectives-a" in run("new", "adjektives").exception.mend
    assert "parameter" in run("new", "most-natural", "--set", "form=1").exception.mend


def test_faults_are_told_by_file_line_and_column_and_end_the_command_with_1(
    settings: Settings, tmp_path: Path
) -> None:
    path = study_file(tmp_path)
    text = path.read_text(encoding="utf-8").replace("reference:", "referense:")
    path.write_text(text, encoding="utf-8")
    line = text.count("\n", 0, text.index("referense")) + 1
    told = run("check", path)
    assert told.exit_code == 1
    first, mend = told.output.splitlines()
    assert first.startswith(f"{path}:{line}:7: part 3 (adjectives) › task › referense: ")
    assert mend == "    Did you mean “reference”?"


def test_clips_are_looked_up_where_there_is_a_library(database: Database, tmp_path: Path) -> None:
    path = study_file(tmp_path, "set_a_neutral", "set_a_prood")
    told = run("check", path)
    line = path.read_text(encoding="utf-8").splitlines().index("      - set_a_prood") + 1
    assert told.exit_code == 1
    assert f"{path}:{line}:9: part 3 (adjectives) › stimulus 2 › clip: " in told.output
    assert "Did you mean “set_a_proud”?" in told.output


def test_a_file_that_is_no_text_is_told_and_not_read(settings: Settings, tmp_path: Path) -> None:
    path = tmp_path / "study.yaml"
    path.write_bytes(b"title: x\nslug: \xff\xfe")
    told = run("check", path)
    assert told.exit_code == 1
    assert f"{path}:2:1: The file is not written in UTF-8." in told.output


def test_publishing_makes_clips_study_and_version_once(database: Database, tmp_path: Path) -> None:
    made = {"made": {"source": "set_a_proud", "preset": "tired"}}
    path = study_file(tmp_path, "set_a_neutral", made, running={"quota": 12})
    first = run("publish", path)
    assert first.exit_code == 0, first.output
    assert "version 1 is published" in first.output
    assert "/studies/four-qualities-of-walks" in first.output
    again = run("publish", path)
    assert "version 1 stays as it is" in again.output
    with database.reading() as db:
        study = db.scalars(select(Study).where(Study.slug == "four-qualities-of-walks")).one()
        (version,) = db.scalars(select(StudyVersion).where(StudyVersion.study_id == study.id))
        shown = [stimulus["clip"] for stimulus in version.definition["parts"][2]["stimuli"]]
        assert all(db.get(ClipRecord, clip) for clip in shown)
        assert (study.state, study.draft, study.running["quota"]) == ("open", None, 12)


def test_a_changed_file_is_the_next_version_and_says_what_changed(
    database: Database, tmp_path: Path
) -> None:
    assert run("publish", study_file(tmp_path)).exit_code == 0
    told = run("publish", study_file(tmp_path, title="Other qualities"))
    assert "version 2 is published" in told.output
    assert len(told.output.splitlines()) > 2


def test_nothing_is_published_of_a_file_with_faults(database: Database, tmp_path: Path) -> None:
    told = run("publish", study_file(tmp_path, "set_a_nothing"))
    assert told.exit_code == 1
    assert "no clip “set_a_nothing”" in told.output
    with database.reading() as db:
        slugs = set(db.scalars(select(Study.slug)))
    assert "four-qualities-of-walks" not in slugs


def test_publishing_needs_a_database_and_a_researcher(settings: Settings, tmp_path: Path) -> None:
    path = study_file(tmp_path)
    assert "manner prepare" in run("publish", path).exception.mend
    run("prepare")
    assert "set-up-link" in run("publish", path).exception.mend
    assert "address" in run("publish", path, "--by", "ghost@example.org").exception.message


def test_the_json_schema_is_printed(settings: Settings) -> None:
    schema = json.loads(run("schema").stdout)
    assert {"parts", "running"} <= set(schema["properties"])
