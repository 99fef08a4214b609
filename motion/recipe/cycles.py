"""Operations that make clips fit for one blending space: one cycle each, on one skeleton."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from motion.body import REQUIRED
from motion.clip import Clip
from motion.editing.cycle_cut import cut_cycle
from motion.recipe.operation import Context, operation
from motion.recipe.parameters import LATEST, Number, Reference
from motion.retargeting import retarget


def _cycle(clip: Clip, _: Context, *, start: float | None, end: float | None) -> Clip:
    return cut_cycle(clip, start, end)


def _retarget(source: Clip, context: Context, *, clip: str) -> Clip:
    return retarget(source, context.materials.clips[clip]).clip


def _both_or_neither(values: Mapping[str, Any]) -> tuple[str, str] | None:
    start, end = values["start"], values["end"]
    if (start is None) != (end is None):
        given = "start" if end is None else "end"
        return f"Only the {given} of the cycle is given.", "Give both start and end, or neither."
    if start is not None and end <= start:
        return (
            f"The end at {end:g} s does not come after the start at {start:g} s.",
            "Give a later end, or neither.",
        )
    return None


def _moment(title: str, description: str) -> Number:
    return Number(
        title=title,
        description=description,
        unit="s",
        minimum=0.0,
        maximum=LATEST,
        optional=True,
    )


CYCLE = operation(
    "cycle@1",
    "One cycle",
    "Cuts one stride, left strike to left strike, and makes it go on where it began.",
    {
        "start": _moment("Start", "Where the cycle begins; none for the stride that fits best."),
        "end": _moment("End", "Where it has begun again; none for the stride that fits best."),
    },
    _cycle,
    follow=_cycle,
    rule=_both_or_neither,
)

RETARGET = operation(
    "retarget@1",
    "Onto another body",
    "Puts the motion onto another clip's skeleton; limbs keep their directions, feet stand.",
    {
        "clip": Reference(
            title="Body",
            description="A clip of the skeleton that shall move.",
            kind="clip",
        )
    },
    _retarget,
    follow=_retarget,
    needs=REQUIRED,
)
