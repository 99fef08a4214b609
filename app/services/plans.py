"""A participant's plan: which steps, in which order.

It follows from the version's definition, the session's seed and the slot, and from nothing else.
"""

from __future__ import annotations

from itertools import combinations
from typing import Any

from app.schemas.study import (
    OF_ONE,
    OF_TWO,
    AnyPart,
    Break,
    Catch,
    Instructed,
    Match,
    Repeated,
    SemanticDifferential,
    Stimulus,
    StudyDefinition,
    Trials,
    Words,
)
from app.services.designs import Draws, draws_of, subset, williams
from app.services.matching_plan import matching_steps

Plan = dict[str, Any]
Step = dict[str, Any]
# The stimuli, by number, that stand together in one trial.
Unit = tuple[int, ...]

PAUSE = Break(
    id="pause",
    heading=Words({"en": "Time for a pause", "fi": "Tauon paikka", "ja": "ひと休み"}),
    text=Words(
        {
            "en": "Rest your eyes for as long as you like, then go on.",
            "fi": "Lepuuta silmiäsi niin kauan kuin haluat ja jatka sitten.",
            "ja": "好きなだけ目を休めてから、続けてください。",
        }
    ),
)


def group_of(definition: StudyDefinition, slot: int) -> str | None:
    """The between-subject group of a slot; None where there are none."""
    groups = definition.groups
    return groups[slot % len(groups)].id if groups else None


def draw_plan(definition: StudyDefinition, seed: int, slot: int, design: str) -> Plan:
    """The steps of one participant.

    Args:
        definition: the published study.
        seed: the session's; from it come shuffles, practice, places on the page and checks.
        slot: the place in the design; from it come group, Latin-square row and subset.
        design: the version's hash, which tells its designs from another version's.
    """
    draws, group = Draws(seed), group_of(definition, slot)
    row = slot // max(1, len(definition.groups))
    steps: list[Step] = []
    scales: dict[str, list[str]] = {}
    for part in _in_order(definition, group, draws):
        if not isinstance(part, Trials):
            steps.append({"part": part.id})
            continue
        steps += _trials(part, draws, row, design)
        task = part.task
        if isinstance(task, SemanticDifferential) and task.shuffle_scales:
            scales[part.id] = [task.scales[i].id for i in draws.shuffle(len(task.scales))]
    _name_repeats(steps)
    return {"steps": steps, "scales": scales}


def units(part: Trials) -> list[Unit]:
    """What stands together in each trial of a part, in the order of the definition."""
    number = len(part.stimuli)
    if part.task.kind in OF_ONE:
        return [(index,) for index in range(number)]
    if part.sets is not None:
        places = {stimulus.name: index for index, stimulus in enumerate(part.stimuli)}
        return [tuple(places[name] for name in names) for names in part.sets]
    if part.task.kind in OF_TWO:
        return list(combinations(range(number), 2))
    return [tuple(range(number))]


def _in_order(definition: StudyDefinition, group: str | None, draws: Draws) -> list[AnyPart]:
    parts = list(definition.parts)
    for block in definition.blocks:
        places = [index for index, part in enumerate(parts) if part.id in block]
        members = [parts[index] for index in places]
        for place, drawn in zip(places, draws.shuffle(len(members)), strict=True):
            parts[place] = members[drawn]
    return [part for part in parts if part.groups is None or group in part.groups]


def _trials(part: Trials, draws: Draws, row: int, design: str) -> list[Step]:
    every = units(part)
    practice = draws.shuffle(len(every))[: part.practice]
    order = _order(part, every, draws, row, design)
    if isinstance(part.task, Match):
        return _with_pauses(matching_steps(part, part.task, order, row), part)
    analysed = [_step(part, every[index], draws) for index in order]
    for check in part.checks:
        _add_check(analysed, check, part, draws)
    steps = [_step(part, every[index], draws, practice=True) for index in practice]
    return _with_pauses([*steps, *analysed], part)


def _order(part: Trials, every: list[Unit], draws: Draws, row: int, design: str) -> list[int]:
    chosen = list(range(len(every)))
    if part.subset is not None:
        chosen = sorted(subset(len(every), part.subset, row, design, part.id))
    if part.order == "fixed":
        return chosen
    blocks = _blocks(part, every, chosen)
    if part.order == "latin_square" and len(blocks) > 1:
        named = draws_of(design, part.id, "square").shuffle(len(blocks))
        sequence = [named[place] for place in williams(len(blocks), row)]
    else:
        sequence = draws.shuffle(len(blocks))
    return [
        blocks[number][index] for number in sequence for index in draws.shuffle(len(blocks[number]))
    ]


def _blocks(part: Trials, every: list[Unit], chosen: list[int]) -> list[list[int]]:
    """What changes places as a whole: single trials, or those of one body or style."""
    if part.block_by is None:
        return [[index] for index in chosen]
    found: dict[str | None, list[int]] = {}
    for index in chosen:
        found.setdefault(getattr(part.stimuli[every[index][0]], part.block_by), []).append(index)
    return list(found.values())


def _step(part: Trials, unit: Unit, draws: Draws, *, practice: bool = False) -> Step:
    places = list(unit)
    if len(unit) > 1 and part.order != "fixed":
        places = [unit[index] for index in draws.shuffle(len(unit))]
    step: Step = {"part": part.id, "clips": [part.stimuli[place].clip for place in places]}
    if part.task.kind == "abx":
        step["x"] = draws.below(2)
    return {**step, "practice": practice}


def _add_check(
    steps: list[Step], check: Instructed | Repeated | Catch, part: Trials, draws: Draws
) -> None:
    """Put an attention check somewhere among the trials, never first."""
    if isinstance(check, Repeated):
        early = [step for step in steps[: (len(steps) + 1) // 2] if "check" not in step]
        again = [early[index] for index in draws.shuffle(len(early))[: check.count]]
        late = 2 * len(steps) // 3
        for step in again:
            place = late + 1 + draws.below(max(1, len(steps) - late))
            steps.insert(place, {**step, "check": check.id})
        return
    if isinstance(check, Catch):
        shown: Stimulus = check.stimulus
    else:
        shown = part.stimuli[draws.below(len(part.stimuli))]
    place = 1 + draws.below(max(1, len(steps)))
    steps.insert(
        place, {"part": part.id, "clips": [shown.clip], "practice": False, "check": check.id}
    )


def _name_repeats(steps: list[Step]) -> None:
    """A repeated trial names the step that it repeats: `of`."""
    first: dict[tuple[str, tuple[str, ...]], int] = {}
    for index, step in enumerate(steps):
        if "clips" not in step or step["practice"]:
            continue
        shown = step["part"], tuple(sorted(step["clips"]))
        if "check" not in step:
            first.setdefault(shown, index)
        elif shown in first:
            step["of"] = first[shown]


def _with_pauses(steps: list[Step], part: Trials) -> list[Step]:
    if part.break_every is None:
        return steps
    found: list[Step] = []
    for number, step in enumerate(steps):
        if number and number % part.break_every == 0:
            found.append({"part": PAUSE.id})
        found.append(step)
    return found


def planned_steps(plan: Plan | None) -> list[Step]:
    """The steps of a session's plan in order; none after a withdrawal."""
    steps: list[Step] = (plan or {"steps": []})["steps"]
    return steps
