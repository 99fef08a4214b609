"""The ``manner`` command."""

from __future__ import annotations

import json
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer
from pydantic import ValidationError
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

from app import cli_recover, cli_simulate, cli_studies
from app.errors import MannerError
from app.persistence.engine import Database, make_engine
from app.services import preparation, researchers
from app.settings import Settings

# The commands import what they need when they run: `manner serve` should not wait for SciPy.


class SetName(StrEnum):
    """The sets that have a name."""

    foerger = "foerger"


app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_show_locals=False,
    help="Manner: perception studies and authoring of human motion.",
)
app.add_typer(cli_studies.app, name="study")
app.command()(cli_simulate.simulate)
app.command()(cli_recover.recover)
console = Console(highlight=False)


@app.command()
def prepare() -> None:
    """Bring the database to its newest form and make the sample library. Safe to repeat."""
    database = Database(make_engine(Settings().database))
    with _progress() as progress:
        task = progress.add_task("Making motions", total=None, visible=False)
        preparation.prepare(
            database,
            lambda done, total: progress.update(task, completed=done, total=total, visible=True),
        )


@app.command()
def serve(
    host: Annotated[str, typer.Option(help="Address to listen on.")] = "127.0.0.1",
    port: Annotated[int, typer.Option(help="Port to listen on.")] = 8000,
    workers: Annotated[int, typer.Option(help="Server processes.")] = 1,
    reload: Annotated[bool, typer.Option(help="Start again when the code changes.")] = False,
) -> None:
    """Start the server. The first start prints the link that makes a researcher's account."""
    import uvicorn

    settings = Settings()
    database = _prepared_database(settings)
    with database.writing() as db:
        if not researchers.any_exists(db):
            _print_link(researchers.make_setup_link(db, _address(settings, host, port)))
    database.engine.dispose()
    typer.echo(f"Manner listens on http://{host}:{port}", err=True)
    uvicorn.run(
        "app.main:app_to_serve",
        factory=True,
        host=host,
        port=port,
        workers=workers,
        reload=reload,
        access_log=False,  # it would hold people's addresses and participants' tokens
        log_level="warning",
        server_header=False,
        timeout_worker_healthcheck=60,  # a busy machine needs a while to load the code
        timeout_graceful_shutdown=15,  # s; a computation that takes longer is asked for again
        forwarded_allow_ips=settings.trusted_proxies,
    )


@app.command("import")
def import_files(
    files: Annotated[list[Path], typer.Argument(help="BVH files.", exists=True, dir_okay=False)],
    yes: Annotated[bool, typer.Option("--yes", help="Confirm all that is guessed.")] = False,
) -> None:
    """Import motion files. One that cannot be read does not hinder the others."""
    from app.services import command_line_imports

    settings = Settings()
    database = _prepared_database(settings)
    with _progress() as progress:
        task = progress.add_task("Importing", total=len(files))
        failed = 0
        for told in command_line_imports.import_paths(
            database, files, confirm=yes, scheduler=settings.scheduler
        ):
            progress.console.print(told.text, markup=False, soft_wrap=True)
            failed += told.failed
            progress.advance(task)
    if failed:
        console.print(f"{failed} of {len(files)} files could not be imported.")
        raise typer.Exit(1)


@app.command("make-set")
def make_set(
    name: Annotated[SetName, typer.Argument(help="foerger: his 20 modified clips of 2 neutral.")],
) -> None:
    """Make a whole set of clips. What is in the library already is not made again."""
    from app.services import command_line_sets

    settings = Settings()
    database = _prepared_database(settings)
    with _progress() as progress:
        task = progress.add_task("Making clips", total=None)
        job = command_line_sets.make(
            database,
            command_line_sets.SETS[name.value],
            lambda done, total: progress.update(task, completed=done, total=total),
            settings.scheduler,
        )
    for item in job.items:
        if item.error:
            console.print(f"{item.name}: {item.error}", markup=False, soft_wrap=True)
    console.print(f"{job.done} of {job.total} clips are in the library.")
    if job.done < job.total:
        raise typer.Exit(1)


@app.command()
def sweep() -> None:
    """Delete the answers whose study's retention time is over. The server does it once a day."""
    from app.persistence.writer import Writer
    from app.services import retention

    database = _prepared_database(Settings())
    writer = Writer(database)
    try:
        deleted = retention.sweep(database, writer)
    finally:
        writer.close()
    typer.echo(f"Deleted: {deleted} participant{'' if deleted == 1 else 's'}.")


@app.command()
def openapi() -> None:
    """Print the API's OpenAPI document, from which the front end's types are generated."""
    from app.main import create_app

    settings = Settings(database_url="sqlite://", secret_key="x" * 32)
    typer.echo(json.dumps(create_app(settings).openapi(), indent=2))


@app.command("set-up-link")
def set_up_link() -> None:
    """Print another one-time link that makes a researcher's account."""
    settings = Settings()
    with _prepared_database(settings).writing() as db:
        _print_link(researchers.make_setup_link(db, settings.public_url))


@app.command("reset-password")
def reset_password(email: str) -> None:
    """Give a researcher a new password, and end all earlier sign-ins."""
    password = typer.prompt("New password", hide_input=True, confirmation_prompt=True)
    with _prepared_database(Settings()).writing() as db:
        researchers.reset_password(db, email, password)
    typer.echo("The password is changed.")


def main() -> None:
    """Run the command line; a fault that a person can mend is told without a trace."""
    try:
        app()
    except MannerError as error:
        console.print(f"{error.message} {error.mend or ''}", markup=False)
        raise SystemExit(1) from error
    except ValidationError as error:
        if error.title != Settings.__name__:
            raise
        for fault in error.errors():
            name = "MANNER_" + "_".join(map(str, fault["loc"])).upper()
            console.print(f"{name}: {fault['msg'].removeprefix('Value error, ')}", markup=False)
        raise SystemExit(1) from error


def _prepared_database(settings: Settings) -> Database:
    database = Database(make_engine(settings.database))
    if preparation.needs_migration(database):
        console.print("The database is not prepared. Run: manner prepare")
        raise typer.Exit(1)
    return database


def _address(settings: Settings, host: str, port: int) -> str:
    """Where people reach the server: what the operator has said, else where it listens."""
    if "public_url" in settings.model_fields_set:
        return settings.public_url
    anywhere = host in ("0.0.0.0", "::")  # noqa: S104 -- compared, not listened on
    return f"http://{'127.0.0.1' if anywhere else host}:{port}"


def _print_link(link: str) -> None:
    # Not by rich, which would break the line in the middle of the link.
    typer.echo(f"Make a researcher's account here; the link works once:\n\n  {link}\n")


def _progress() -> Progress:
    return Progress(
        TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), console=console
    )


if __name__ == "__main__":
    main()
