"""What simulated participants feel about the clips of a study, read from an effects file."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from pydantic import ValidationError

from app.errors import InvalidError
from app.schemas.effects import Effects
from app.schemas.study import Match, Stimulus, StudyDefinition, Trials
from app.services.measures import CHOICES, Measure, measures
from app.services.study_text import StudyText, StudyTextError, read_text
from app.statistics.intervals import Samples

SLIDER_STEP = 10.0  # points


@dataclass(frozen=True)
class Taste:
    """What is felt about the clips of one part.

    Attributes:
        measures: the numbers that the part asks for, or the one choice.
        latent: (clips, measures), away from the middle, in the measures' own units.
    """

    part: Trials
    measures: list[Measure]
    latent: Samples

    @property
    def scale(self) -> float:
        """The length of a step in the measures' unit."""
        return SLIDER_STEP if self.part.task.kind in ("analogue", "parallel") else 1.0

    def matching(self, key: str) -> list[int]:
        """The clips, by number, that a name, style or body fits."""
        return [i for i, one in enumerate(self.part.stimuli) if key in _keys(one)]


def read_effects(text: str, name: str = "") -> tuple[Effects, StudyText]:
    """An effects file, YAML or JSON, and where in it everything stands.

    Raises:
        InvalidError: it cannot be read; the message says where.
    """
    try:
        read = read_text(text, name)
        return Effects.model_validate(read.data), read
    except StudyTextError as error:
        raise _fault(name, error.line, error.message, error.mend) from error
    except ValidationError as error:
        fault = error.errors()[0]
        line = read.place(tuple(fault["loc"]))[0]
        told = " → ".join(map(str, fault["loc"]))
        raise _fault(
            name, line, f"{told}: {fault['msg']}.", "It has noise, rater_sd and effects."
        ) from error


def tastes(
    definition: StudyDefinition, effects: Effects, read: StudyText | None = None, name: str = ""
) -> list[Taste]:
    """What is felt about the clips of each part; about targets, which are matched, nothing.

    Raises:
        InvalidError: the effects name a value or a clip that the study has not.
    """
    judged = [part for part in definition.trials if not isinstance(part.task, Match)]
    found = [_taste(part, effects) for part in judged]
    values = {key for one in found for measure in one.measures for key in _names(measure)}
    for value, clips in effects.effects.items():
        path = ("effects", value)
        if value not in values:
            raise _unknown(name, read, path, f"the study asks for no “{value}”", values)
        known = {
            key
            for one in found
            if any(value in _names(measure) for measure in one.measures)
            for stimulus in one.part.stimuli
            for key in _keys(stimulus)
        }
        for clip in clips:
            if clip not in known:
                message = f"no clip, style or body is called “{clip}”"
                raise _unknown(name, read, (*path, clip), message, known)
    return found


def _taste(part: Trials, effects: Effects) -> Taste:
    asked = [one for one in measures(part) if one.numeric or one.id == "choice"]
    taste = Taste(part, asked, np.zeros((len(part.stimuli), len(asked))))
    for column, measure in enumerate(asked):
        for key in _names(measure):
            for clip, size in effects.effects.get(key, {}).items():
                taste.latent[taste.matching(clip), column] += size * taste.scale
    return taste


def felt_of(measure: Measure, effects: Effects) -> Iterable[str]:
    """What moves a measure, by the effects."""
    return dict.fromkeys(clip for key in _names(measure) for clip in effects.effects.get(key, {}))


def choosing(taste: Taste) -> bool:
    """Whether the part is answered by choosing."""
    return taste.part.task.kind in CHOICES


def _names(measure: Measure) -> tuple[str, str]:
    return measure.id, f"{measure.part}__{measure.id}"


def _keys(stimulus: Stimulus) -> set[str]:
    return {key for key in (stimulus.name, stimulus.style, stimulus.body) if key}


def _unknown(
    name: str, read: StudyText | None, path: tuple[str, ...], message: str, known: set[str]
) -> InvalidError:
    near = difflib.get_close_matches(path[-1], sorted(known), n=1)
    listed = ", ".join(sorted(known)[:12])
    mend = f"Is “{near[0]}” meant?" if near else f"There are: {listed}."
    return _fault(name, read.place(path)[0] if read else None, f"{' → '.join(path)}: {message}.",
                  mend)  # fmt: skip


def _fault(name: str, line: int | None, message: str, mend: str) -> InvalidError:
    before = f"{name or 'The effects'}{'' if line is None else f', line {line}'}: "
    return InvalidError(before + message, code="effects_invalid", where={"line": line}, mend=mend)
