"""The steps in which targets are matched: guesses unseen, then each interface against the clock."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from app.schemas.study import Interface, Match, Trials
from app.services.designs import williams

Step = dict[str, Any]


def matching_steps(part: Trials, task: Match, order: Sequence[int], row: int) -> list[Step]:
    """The steps of a part that matches targets, practice first.

    Args:
        part: what is shown.
        task: what it asks.
        order: its targets, by number, as they come.
        row: of the participant in the design. The interfaces' order is that row of a Williams
            square for the first target and the next row for each further one, so that it is
            balanced over participants and, within each, over targets.
    """
    steps: list[Step] = []
    for place, target in enumerate(task.practice_targets):
        turns = _turns(task, row + place)
        steps += _steps(part, target.clip, turns, seen=True, practice=True)
    for place, number in enumerate(order):
        clip, turns = part.stimuli[number].clip, _turns(task, row + place)
        if task.guess_first:
            steps += _steps(part, clip, turns, seen=False)
        steps += _steps(part, clip, turns, seen=True)
    return steps


def _turns(task: Match, row: int) -> list[Interface]:
    return [task.interfaces[index] for index in williams(len(task.interfaces), row)]


def _steps(
    part: Trials,
    clip: str | None,
    turns: Iterable[Interface],
    *,
    seen: bool,
    practice: bool = False,
) -> list[Step]:
    return [
        {
            "part": part.id,
            "clips": [clip],
            "interface": interface,
            "seen": seen,
            "practice": practice,
        }
        for interface in turns
    ]
