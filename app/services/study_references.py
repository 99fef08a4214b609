"""Where a study names clips: every place in its file, with what stands there."""

from __future__ import annotations

from collections.abc import Iterator

from app.schemas.study import (
    Catch,
    Instructions,
    Made,
    Match,
    Stimulus,
    StudyDefinition,
    Trials,
)
from app.services.study_text import Path


def references(definition: StudyDefinition) -> Iterator[tuple[Path, str]]:
    """Every clip that is named, with its place in the file."""
    if definition.welcome.example is not None:
        yield ("welcome", "example"), definition.welcome.example
    for index, part in enumerate(definition.parts):
        place: Path = ("parts", index)
        if isinstance(part, Instructions):
            for number, figure in enumerate(part.figures):
                yield (*place, "figures", number, "clip"), figure.clip
        if isinstance(part, Trials) and (reference := getattr(part.task, "reference", None)):
            yield (*place, "task", "reference"), reference
    for path, stimulus in stimuli(definition):
        if stimulus.clip is not None:
            yield (*path, "clip"), stimulus.clip
        elif isinstance(stimulus.made, Made):
            yield (*path, "made", "source"), stimulus.made.source


def matches(definition: StudyDefinition) -> Iterator[tuple[Path, Match]]:
    """Every task that matches targets, with its place in the file."""
    for index, part in enumerate(definition.parts):
        if isinstance(part, Trials) and isinstance(part.task, Match):
            yield ("parts", index, "task"), part.task


def stimuli(definition: StudyDefinition) -> Iterator[tuple[Path, Stimulus]]:
    """Every clip that is asked about, however it comes about, with its place in the file."""
    for index, part in enumerate(definition.parts):
        if not isinstance(part, Trials):
            continue
        for number, stimulus in enumerate(part.stimuli):
            yield ("parts", index, "stimuli", number), stimulus
        for number, stimulus in enumerate(getattr(part.task, "practice_targets", ())):
            yield ("parts", index, "task", "practice_targets", number), stimulus
        for number, check in enumerate(part.checks):
            if isinstance(check, Catch):
                yield ("parts", index, "checks", number, "stimulus"), check.stimulus
