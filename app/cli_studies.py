"""``manner study``: study files from the command line."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated

import typer

from app.errors import MannerError
from app.persistence.engine import Database, make_engine
from app.services import preparation
from app.settings import Settings

# The commands import what they need when they run.

app = typer.Typer(no_args_is_help=True, help="Check, begin and publish study files.")
StudyPath = Annotated[Path, typer.Argument(help="YAML or JSON.", exists=True, dir_okay=False)]


@app.command()
def check(file: StudyPath) -> None:
    """Tell every fault of a study file at its line, with the mend."""
    from app.services import command_line_studies

    read = command_line_studies.read(file)
    faults = list(read.faults)
    database = _database()
    if database is not None:
        with database.reading() as db:
            faults += command_line_studies.faults_of_clips(db, read)
    for fault in sorted(faults, key=lambda one: (one.line, one.column)):
        typer.echo(fault.told(str(file)))
    if faults:
        raise typer.Exit(1)
    clips = " No clip was looked up: the database is not prepared." if database is None else ""
    typer.echo(f"{file}: no faults.{clips}")


@app.command()
def new(
    template: Annotated[str, typer.Argument(help="Its name; left out, all are listed.")] = "",
    option: Annotated[
        list[str] | None, typer.Option("--set", help="An option of the template: from=0.5.")
    ] = None,
) -> None:
    """Print a study file to begin with: manner study new emotion > study.yaml."""
    from app.services import study_files
    from app.studies import TEMPLATES

    if not template:
        for one in TEMPLATES.values():
            typer.echo(f"{one.id:18}{one.summary}")
            for name, meaning in one.options.items():
                typer.echo(f"{'':20}--set {name}=…  {meaning}")
        return
    if template not in TEMPLATES:
        message = f"There is no template {template}."
        raise MannerError(message, mend=f"Use one of {', '.join(TEMPLATES)}.")
    chosen = TEMPLATES[template]
    typer.echo(f"# {chosen.notes}")
    typer.echo(study_files.write(chosen.build(**_options(option or []))), nl=False)


@app.command()
def publish(
    file: StudyPath,
    by: Annotated[
        str, typer.Option(help="In this researcher's name; else whoever set the server up.")
    ] = "",
) -> None:
    """Make the study of a file, or its next version, and open it."""
    from app.services import command_line_studies

    database = _database()
    if database is None:
        raise MannerError("The database is not prepared.", mend="Run: manner prepare")
    read = command_line_studies.read(file)
    with database.reading() as db:
        faults = [*read.faults, *command_line_studies.faults_of_clips(db, read)]
    if faults or read.definition is None:
        for fault in faults:
            typer.echo(fault.told(str(file)))
        raise typer.Exit(1)
    told = command_line_studies.publish(database, read, by or None)
    what = "stays as it is" if told.same else "is published"
    typer.echo(f"{read.definition.title}: version {told.number} {what}.")
    for sentence in told.changes if not told.same else []:
        typer.echo(f"  {sentence}")
    typer.echo(f"{Settings().public_url}/studies/{read.definition.slug}")


@app.command()
def schema() -> None:
    """Print the JSON Schema of study files, by which editors complete and check them."""
    from app.services import study_schema

    typer.echo(json.dumps(study_schema.schema(), indent=2, ensure_ascii=False))


def _options(given: list[str]) -> dict[str, str]:
    pairs = [one.partition("=") for one in given]
    return {name.strip(): value.strip() for name, _, value in pairs}


def _database() -> Database | None:
    """The database if it is prepared."""
    settings = Settings()
    if not settings.database_url and not (settings.data_directory / "manner.sqlite3").exists():
        return None  # looking would make one
    database = Database(make_engine(settings.database))
    return None if preparation.needs_migration(database) else database
