"""What ``manner simulate`` does, without the telling."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from sqlalchemy.orm import Session

from app.persistence.engine import Database
from app.persistence.writer import Writer
from app.schemas.effects import Effects
from app.schemas.study import StudyDefinition
from app.services import rehearsal, simulation
from app.services.effects import Taste, read_effects, tastes
from app.services.rehearsal import Effect, Found
from app.services.simulation import Course
from app.services.studies import definition_of, find, newest
from app.statistics.power import Power

Tell = Callable[[int], None]


@dataclass(frozen=True)
class Plan:
    """A study to be rehearsed, and what is felt about its clips."""

    slug: str
    definition: StudyDefinition
    effects: Effects
    tastes: list[Taste]


def planned(database: Database, slug: str, file: Path | None) -> Plan:
    """The study's newest version with the effects; without a file nothing is felt about any clip.

    Raises:
        NotFoundError: there is no such study, or it is not published.
        InvalidError: the effects file cannot be read, or does not fit the study.
    """
    with database.reading() as db:
        definition = definition_of(newest(db, find(db, slug)))
    if file is None:
        effects = Effects()
        return Plan(slug, definition, effects, tastes(definition, effects))
    effects, read = read_effects(file.read_text(encoding="utf-8", errors="replace"), file.name)
    return Plan(slug, definition, effects, tastes(definition, effects, read, file.name))


def run(
    database: Database,
    plan: Plan,
    participants: int,
    dropout: float,
    generator: np.random.Generator,
    tell: Tell,
) -> list[Course]:
    """Whole sessions through the services, stored as simulated ones."""

    def read(job: Callable[[Session], Any]) -> Any:  # noqa: ANN401 -- whatever the job gives
        with database.reading() as db:
            return job(db)

    courses = []
    raters = simulation.raters(plan.tastes, plan.effects, participants, generator)
    writer = Writer(database)
    try:
        for course in simulation.run(read, writer.write, plan.slug, raters, dropout, generator):
            courses.append(course)
            tell(len(courses))
    finally:
        writer.close()
    return courses


def found(plan: Plan, courses: Sequence[Course]) -> list[Found]:
    """Which effects the answers of one run show; the complete participants' alone."""
    counted = [row for course in courses for row in course.counted]
    return rehearsal.from_answers(plan.tastes, plan.effects, counted)


def powers(
    plan: Plan, complete: int, generator: np.random.Generator, runs: int, tell: Tell
) -> list[tuple[Effect, Power]]:
    """How often each effect is found by so many complete participants."""
    return rehearsal.repeated(
        plan.definition, plan.tastes, plan.effects, complete, generator, runs, tell
    )
