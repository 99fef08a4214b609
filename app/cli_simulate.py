"""``manner simulate``: rehearse a study with participants whose feelings are known."""

from __future__ import annotations

import secrets
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

from app.persistence.engine import Database, make_engine
from app.services import preparation
from app.settings import Settings

if TYPE_CHECKING:
    from app.services.rehearsal import Effect, Found
    from app.services.simulation import Course
    from app.statistics.power import Power

console = Console(highlight=False)


def simulate(
    study: Annotated[str, typer.Argument(help="The study's address, such as emotion-in-walking.")],
    participants: Annotated[int, typer.Option(min=1, max=100_000, help="How many begin.")] = 200,
    effects: Annotated[
        Path | None,
        typer.Option(exists=True, dir_okay=False, help="What is felt (docs/simulation.md)."),
    ] = None,
    dropout: Annotated[float, typer.Option(min=0, max=1, help="The part that leaves early.")] = 0.0,
    seed: Annotated[
        int | None, typer.Option(min=0, help="The same seed, the same answers.")
    ] = None,
    repeat: Annotated[
        int, typer.Option(min=0, max=100_000, help="Runs for the power; none of them is stored.")
    ] = 0,
    store: Annotated[bool, typer.Option(help="Store one run, to look at its results.")] = True,
    browsers: Annotated[
        int, typer.Option(min=0, max=20, help="Real browsers instead, so many at once.")
    ] = 0,
    address: Annotated[
        str, typer.Option(help="Where the server listens, for browsers.")
    ] = "http://127.0.0.1:8000",
) -> None:
    """Take simulated participants through a study, and tell which stated effects it would find.

    They are kept apart from people: the results page shows them with ?kind=simulated.
    """
    import numpy as np

    from app.services import command_line_simulation as rehearsing

    drawn = secrets.randbits(32) if seed is None else seed
    generator = np.random.default_rng(drawn)
    database = _prepared()
    plan = rehearsing.planned(database, study, effects)
    console.print(f"Seed {drawn}.")
    if store or browsers:
        with _progress("Participants", participants) as tell:
            if browsers:
                from app.services import browser_simulation

                courses = browser_simulation.run(
                    database, plan, participants, browsers, address, generator, tell
                )
            else:
                courses = rehearsing.run(database, plan, participants, dropout, generator, tell)
        _tell_courses(study, courses)
        _tell_found(rehearsing.found(plan, courses))
    if repeat:
        complete = max(1, round(participants * (1 - dropout)))
        with _progress("Runs", repeat) as tell:
            powers = rehearsing.powers(plan, complete, generator, repeat, tell)
        _tell_powers(powers, complete)


def _prepared() -> Database:
    database = Database(make_engine(Settings().database))
    if preparation.needs_migration(database):
        console.print("The database is not prepared. Run: manner prepare")
        raise typer.Exit(1)
    return database


class _progress:  # noqa: N801 -- used as a function
    """A bar that is told how many are done."""

    def __init__(self, what: str, total: int) -> None:
        self._bar = Progress(
            TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), console=console
        )
        self._task = self._bar.add_task(what, total=total)

    def __enter__(self) -> Callable[[int], None]:
        self._bar.start()
        return lambda done: self._bar.update(self._task, completed=done)

    def __exit__(self, *_: object) -> None:
        self._bar.stop()


def _tell_courses(study: str, courses: Iterable[Course]) -> None:
    courses = list(courses)
    complete = sum(course.complete for course in courses)
    console.print(f"{complete} of {len(courses)} simulated participants are complete.")
    console.print(
        f"Their results: /research/studies/{study}?kind=simulated", markup=False, soft_wrap=True
    )


def _tell_found(found: Iterable[Found]) -> None:
    lines = []
    for one in found:
        p = "< .001" if one.p < 0.001 else f"= {one.p:.3f}".replace("0.", ".", 1)
        lines.append(f"{_named(one.effect)} is {'' if one.found else 'not '}found here, p {p}")
    _say("In these answers, after Holm’s correction:", lines)


def _tell_powers(powers: Iterable[tuple[Effect, Power]], participants: int) -> None:
    lines = []
    for effect, power in powers:
        interval = f"{100 * power.low:.0f} to {100 * power.high:.0f} %"
        share = f"{100 * power.share:.0f} % of {power.runs} simulated runs"
        lines.append(f"{_named(effect)} is found in {share} ({interval})")
    _say(f"With {participants} complete participants:", lines)


def _named(effect: Effect) -> str:
    size = f"{abs(effect.size):.2f} steps"
    if effect.value == "right answers":
        return f"{effect.part}: that figures differ by up to {size}"
    sign = "less" if effect.size < 0 else "more"
    value = (
        effect.value if effect.value.startswith(effect.part) else f"{effect.part}, {effect.value}"
    )
    return f"{value}: that “{effect.about}” is {size} {sign} than the others"


def _say(heading: str, lines: list[str]) -> None:
    console.print(heading)
    for line in lines or ["no effect is stated that the study could see"]:
        console.print(f"  {line}", markup=False, soft_wrap=True)
