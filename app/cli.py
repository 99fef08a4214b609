"""The ``manner`` command."""

from __future__ import annotations

from typing import Annotated

import typer
import uvicorn

from app.persistence import schema
from app.persistence.engine import Database, make_engine
from app.services import researchers
from app.settings import Settings

app = typer.Typer(no_args_is_help=True, add_completion=False, help="Motion perception studies.")


@app.command()
def prepare() -> None:
    """Bring the database to its newest form and make the sample library."""
    settings = Settings()
    schema.upgrade(make_engine(settings.database))


@app.command()
def serve(
    host: Annotated[str, typer.Option(help="Address to listen on.")] = "127.0.0.1",
    port: Annotated[int, typer.Option(help="Port to listen on.")] = 8000,
    workers: Annotated[int, typer.Option(help="Server processes.")] = 1,
    reload: Annotated[bool, typer.Option(help="Start again when the code changes.")] = False,
) -> None:
    """Start the server."""
    settings = Settings()
    database = Database(make_engine(settings.database))
    with database.writing() as db:
        if not researchers.any_exists(db):
            link = researchers.make_setup_link(db, settings.public_url)
            typer.echo(f"Make your researcher's account here (the link works once):\n  {link}")
    uvicorn.run(
        "app.main:create_app",
        factory=True,
        host=host,
        port=port,
        workers=workers,
        reload=reload,
        access_log=False,
        log_level="warning",
        forwarded_allow_ips=settings.trusted_proxies,
    )


def main() -> None:
    """Run the command line."""
    app()


if __name__ == "__main__":
    main()
