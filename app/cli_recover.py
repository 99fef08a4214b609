"""``manner recover``: does the analysis of adjectives find what simulated raters had in mind?"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

console = Console(highlight=False)


def recover(
    seeds: Annotated[
        int, typer.Option(min=1, max=100_000, help="Simulated studies a point.")
    ] = 100,
    seed: Annotated[int, typer.Option(min=0, help="The same seed, the same page.")] = 1,
    into: Annotated[
        Path, typer.Option(file_okay=False, help="Where recovery.md and recovery.svg go.")
    ] = Path(),
) -> None:
    """Simulate raters with known qualities, and write how well they are found again.

    No database is needed. A hundred studies a point take half a minute on two processors.
    """
    from app.services import recovery, recovery_report

    settings = recovery.settings()
    with Progress(
        TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), console=console
    ) as progress:
        task = progress.add_task("Points", total=len(settings))
        points = recovery.points(
            settings, seeds, seed, lambda done: progress.update(task, completed=done)
        )
    recovery_report.write(points, into, seed)
    console.print(f"Written: {into / recovery_report.PAGE}", markup=False, soft_wrap=True)
