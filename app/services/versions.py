"""A study's published versions as results and tables need them, and what they have in common.

Answers belong to a version. A part keeps its name over versions, so its answers are taken together
wherever the versions asked alike.
"""

from __future__ import annotations

from typing import NamedTuple

from sqlalchemy.orm import Session

from app.errors import NotFoundError
from app.persistence import responses, study_versions
from app.persistence.models import Study
from app.schemas.study import Stimulus, StudyDefinition, Task, Trials
from app.services.measures import Measure, measures, shown_in
from app.services.studies import definition_of, newest


class Version(NamedTuple):
    """A published version as the tables need it: `shown` is (part, clip) to the stimulus."""

    number: int
    hash: str
    definition: StudyDefinition
    shown: dict[tuple[str, str], Stimulus]
    engines: dict[str, str]  # clip to the version of the engine that made it

    @classmethod
    def of(
        cls, number: int, known_as: str, definition: StudyDefinition, engines: dict[str, str]
    ) -> Version:
        """The version with its stimuli looked up."""
        shown = {
            (part.id, one.clip): one
            for part in definition.trials
            for one in shown_in(part)
            if one.clip
        }
        return cls(number, known_as, definition, shown, engines)

    def stimulus(self, part: str, clip: str) -> Stimulus:
        """What the study says of a clip; of a clip that it does not name, the hash alone."""
        return self.shown.get((part, clip)) or Stimulus(clip=clip, name=clip)


class Pooled(NamedTuple):
    """One part with trials over all versions that asked alike.

    Attributes:
        task: of the newest of them.
        stimuli: all clips, those of the newest version first.
        measures: all values, likewise.
        versions: ids of the versions; numbers: the same as people count them.
        apart: numbers of the versions that asked otherwise under the same name.
    """

    part: str
    task: Task
    stimuli: list[Stimulus]
    measures: list[Measure]
    versions: list[int]
    numbers: list[int]
    apart: list[int]


def published(db: Session, study: Study) -> dict[int, Version]:
    """Every version by its id, the newest first.

    Raises:
        NotFoundError: none was published yet.
    """
    newest(db, study)
    found = {
        one.id: Version.of(one.number, one.definition_hash, definition_of(one), {})
        for one in study_versions.versions(db, study)
    }
    engines = responses.engines(db, {clip for one in found.values() for _, clip in one.shown})
    return {key: one._replace(engines=engines) for key, one in found.items()}


def parts_of(versions: dict[int, Version]) -> list[str]:
    """The parts that ask about clips, of all versions, the newest version's first."""
    return list(
        dict.fromkeys(part.id for one in versions.values() for part in one.definition.trials)
    )


def pooled(versions: dict[int, Version], name: str | None) -> Pooled:
    """A part over all versions; without a name the first one.

    Raises:
        NotFoundError: the study has no such part with trials.
    """
    names = parts_of(versions)
    chosen = names[0] if name is None and names else name
    if chosen is None or chosen not in names:
        raise NotFoundError(
            f"The study has no part “{(name or '')[:60]}” that asks about clips.",
            code="part_not_found",
            mend=f"It has: {', '.join(names)}." if names else "Add a part with trials.",
        )
    having = [
        (key, one.number, part)
        for key, one in versions.items()
        for part in one.definition.trials
        if part.id == chosen
    ]
    newest_part = having[0][2]
    alike = [one for one in having if _asks_alike(newest_part, one[2])]
    stimuli: dict[str | None, Stimulus] = {}
    values: dict[str, Measure] = {}
    for *_, part in alike:
        for shown in part.stimuli:
            stimuli.setdefault(shown.clip, shown)
        for measure in measures(part):
            values.setdefault(measure.id, measure)
    numbers = [number for _, number, _ in alike]
    return Pooled(
        chosen,
        newest_part.task,
        list(stimuli.values()),
        list(values.values()),
        [key for key, *_ in alike],
        numbers,
        [number for _, number, _ in having if number not in numbers],
    )


def _asks_alike(one: Trials, other: Trials) -> bool:
    """Whether the answers to two versions of a part can be taken together."""
    if one.task.kind != other.task.kind:
        return False
    ranges = {item.id: (item.lowest, item.highest) for item in measures(one)}
    return all(
        ranges.get(item.id, (item.lowest, item.highest)) == (item.lowest, item.highest)
        for item in measures(other)
    )
