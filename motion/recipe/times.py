"""Operations on time: of limbs, of contacts, of the whole clip."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from motion.clip import Clip
from motion.editing.contacts import accelerate_contacts
from motion.editing.limbs import LIMBS
from motion.editing.tempo import change_tempo, cut, resample_rate
from motion.editing.timing import ADDED, EVEN, Timing, change_timing
from motion.editing.warping import warp_time
from motion.recipe.feet import LEGS, standing_in_place
from motion.recipe.operation import Context, bounded, operation
from motion.recipe.parameters import LATEST, Choice, Group, ListOf, Number


def _timing(
    clip: Clip,
    _: Context,
    *,
    kind: str,
    limbs: list[str] | None,
    amount: float,
    segment: float | None,
) -> Clip:
    chosen = None if limbs is None else tuple(dict.fromkeys(limbs))
    edited = change_timing(clip, Timing(kind, chosen, segment, amount))
    legs = chosen is None or any(limb.endswith("leg") for limb in chosen)
    return standing_in_place(clip, edited) if legs else edited


def _contacts(clip: Clip, _: Context, *, amount: float) -> Clip:
    return accelerate_contacts(clip, amount)


def _tempo(clip: Clip, _: Context, *, factor: float) -> Clip:
    bounded((clip.frames - 1) / factor + 1)
    return change_tempo(clip, factor)


def _resample(clip: Clip, _: Context, *, rate: float) -> Clip:
    bounded(clip.duration * rate + 1)
    return resample_rate(clip, rate)


def _cut(clip: Clip, _: Context, *, start: float, end: float | None) -> Clip:
    return cut(clip, start, clip.duration if end is None else end)


def _warp_time(clip: Clip, _: Context, *, moments: list[dict[str, float]], amount: float) -> Clip:
    return warp_time(clip, [(moment["was"], moment["shall"]) for moment in moments], amount)


def _ordered(values: Mapping[str, Any]) -> tuple[str, str] | None:
    if values["end"] is None or values["start"] < values["end"]:
        return None
    return (
        f"The end at {values['end']:g} s does not come after the start at {values['start']:g} s.",
        "Give a later end, or none for the clip's own.",
    )


def _moment(title: str, description: str) -> Number:
    return Number(title=title, description=description, unit="s", minimum=0.0, maximum=LATEST)


TIMING = operation(
    "timing@1",
    "Timing of limbs",
    "Limbs move at even speed, or pause and burst; length, first and last frame stay.",
    {
        "kind": Choice(
            title="Kind",
            description="Even speed, or added acceleration.",
            options=(EVEN, ADDED),
        ),
        "limbs": ListOf(
            title="Limbs",
            description="None chosen means all, without the legs of a motion that goes places.",
            shortest=1,
            longest=len(LIMBS),
            optional=True,
            item=Choice(title="Limb", options=LIMBS),
        ),
        "amount": Number(
            title="Amount",
            description="0 none, 1 as in the thesis.",
            minimum=0.0,
            maximum=2.0,
            default=1.0,
            neutral=0.0,
        ),
        "segment": Number(
            title="Segment",
            description="A stretch that keeps its length; usually 1.5 s, or 1 s when added.",
            unit="s",
            minimum=0.2,
            maximum=10.0,
            optional=True,
        ),
    },
    _timing,
)

CONTACTS = operation(
    "contacts@1",
    "Acceleration at contacts",
    "Limbs linger and then burst into a contact: a foot strike, a hand's sudden stop.",
    {
        "amount": Number(
            title="Amount",
            description="0 none; 1 doubles the time before a contact and halves it at its end.",
            minimum=0.0,
            maximum=2.0,
            default=1.0,
            neutral=0.0,
        )
    },
    _contacts,
    needs=LEGS,
)

TEMPO = operation(
    "tempo@1",
    "Tempo",
    "Everything faster or slower: the clip becomes shorter or longer.",
    {
        "factor": Number(
            title="Factor",
            description="Above 1 faster, below 1 slower.",
            minimum=0.25,
            maximum=4.0,
            default=1.0,
            neutral=1.0,
        )
    },
    _tempo,
    follow=_tempo,
)

RESAMPLE = operation(
    "resample@1",
    "Frame rate",
    "The same motion with another number of frames a second.",
    {
        "rate": Number(
            title="Rate",
            description="Frames a second.",
            unit="Hz",
            minimum=10.0,
            maximum=240.0,
        )
    },
    _resample,
    follow=_resample,
)

CUT = operation(
    "cut@1",
    "Cut",
    "Keeps a part of the clip.",
    {
        "start": Number(
            title="Start",
            description="The first moment that stays.",
            unit="s",
            minimum=0.0,
            maximum=LATEST,
            default=0.0,
        ),
        "end": Number(
            title="End",
            description="The last moment that stays; usually the clip's own last.",
            unit="s",
            minimum=0.0,
            maximum=LATEST,
            optional=True,
        ),
    },
    _cut,
    follow=_cut,
    rule=_ordered,
)

WARP_TIME = operation(
    "warp_time@1",
    "Move moments",
    "What happens at one time happens at another; length, first and last frame stay.",
    {
        "moments": ListOf(
            title="Moments",
            description="They must not overtake each other.",
            longest=64,
            item=Group(
                title="Moment",
                members={
                    "was": _moment("Was", "When it happens."),
                    "shall": _moment("Shall be", "When it shall happen."),
                },
            ),
        ),
        "amount": Number(
            title="Amount",
            description="0 none, 1 all the way.",
            minimum=0.0,
            maximum=1.0,
            default=1.0,
            neutral=0.0,
        ),
    },
    _warp_time,
    follow=_warp_time,
)
