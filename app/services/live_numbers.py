"""The live page's numbers from what the database has counted. Pure functions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from itertools import accumulate
from typing import Any

from app.persistence.live import Active, Seen, Total
from app.schemas.live import (
    ClipCount,
    Dropout,
    DropoutStep,
    DurationBin,
    Durations,
    GroupCounts,
    LiveCounts,
    PartStart,
    Stands,
)
from app.schemas.study import StudyDefinition
from app.services.summaries import counted

WIDTHS = (5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600, 7200, 21_600, 86_400)  # seconds
MOST_BINS = 16
EVERYBODY = "Everybody"


def stands(state: str, going: bool = False) -> Stands:
    """Where somebody stands, by the session's state and by whether there was a sign lately."""
    if state == "active":
        return "under_way" if going else "left_early"
    if state in ("screened_out", "failed_attention"):
        return "ended_early"
    return "complete" if state == "complete" else "withdrawn"


def counts(
    totals: Sequence[Total], active: Sequence[Active], seen: Sequence[Seen], excluded: int
) -> LiveCounts:
    """How many stand where in all."""
    found = Counter[str]()
    for one in totals:
        found[one.state] += one.sessions
    going = sum(one.sessions for one in active if one.going)
    return LiveCounts(
        complete=found["complete"],
        under_way=going,
        left_early=sum(one.sessions for one in active) - going,
        ended_early=found["screened_out"] + found["failed_attention"],
        withdrawn=found["withdrawn"],
        excluded=excluded,
        answers=sum(one.answered for one in seen),
    )


def by_group(
    totals: Sequence[Total], active: Sequence[Active], labels: Mapping[str, str]
) -> list[GroupCounts]:
    """The same by group, in the definition's order; one row of everybody where there are none."""
    names: list[str | None] = [*labels] or [None]
    found: dict[str | None, Counter[Stands]] = {name: Counter() for name in names}
    told = [(one.group, stands(one.state), one.sessions) for one in totals if one.state != "active"]
    told += [(one.group, stands("active", one.going), one.sessions) for one in active]
    for group, where, sessions in told:
        if where != "withdrawn":  # of whom nothing is known, the group neither
            found.setdefault(group, Counter())[where] += sessions
    without = "No group" if labels else EVERYBODY
    return [
        GroupCounts(
            id=name,
            label=without if name is None else labels.get(name, name),
            complete=group["complete"],
            under_way=group["under_way"],
            left_early=group["left_early"],
            ended_early=group["ended_early"],
        )
        for name, group in found.items()
    ]


def dropout(
    complete: int, active: Sequence[Active], seen: Sequence[Seen], parts: Sequence[PartStart] = ()
) -> Dropout:
    """How many are still there after each step, of those who are complete or have left."""
    left = Counter[int]()
    for one in active:
        if not one.going:
            left[one.answered] += one.sessions
    total = complete + left.total()
    length = max((one.steps for one in seen), default=0)
    gone = accumulate((left[answered] for answered in range(length)), initial=0)
    steps = [
        DropoutStep(answered=answered, still=total - before, left=left[answered])
        for answered, before in enumerate(gone)
    ]
    return Dropout(
        of=total,
        steps=steps if total and length else [],
        parts=list(parts),
        sentence=_left_where(left, total),
    )


def part_starts(definition: StudyDefinition, plan: Sequence[Mapping[str, Any]]) -> list[PartStart]:
    """Where each part begins in a plan; none where participants go different ways."""
    if definition.groups or definition.blocks:
        return []
    names = [step["part"] for step in plan]
    return [
        PartStart(start=at, name=name)
        for at, name in enumerate(names)
        if at == 0 or (name != names[at - 1] and name not in names[:at])
    ]


def durations(histogram: Sequence[tuple[int, int]]) -> Durations:
    """How long they took, from seconds and how many took them."""
    total = sum(count for _, count in histogram)
    if not total:
        return Durations(median_seconds=None, bins=[], sentence="Nobody has completed it yet.")
    low, middle, high = (quantile(histogram, share) for share in (0.25, 0.5, 0.75))
    sentence = f"Half of them took {spoken(low)} to {spoken(high)}; the median is {spoken(middle)}."
    if total < 4:
        sentence = f"The median is {spoken(middle)}."
    return Durations(median_seconds=middle, bins=_bins(histogram), sentence=sentence)


def clip_counts(
    seen: Iterable[Seen],
    places: Mapping[int, Sequence[str]],
    labels: Mapping[str, str],
) -> list[ClipCount]:
    """How often each clip was judged.

    Args:
        seen: what the sessions of each version have judged.
        places: version to its clips, in the order of their places.
        labels: the clips to be listed, in their order.
    """
    found: dict[bool, Counter[str]] = {True: Counter(), False: Counter()}
    for one in seen:
        for place, times in counted(one.clips).items():
            found[one.complete][places[one.version_id][place]] += times
    return [
        ClipCount(clip=clip, label=label, complete=found[True][clip], others=found[False][clip])
        for clip, label in labels.items()
    ]


def clips_sentence(clips: Sequence[ClipCount]) -> str:
    """How evenly the clips were judged, in words."""
    if not clips:
        return "This study shows no clips."
    times = [clip.complete + clip.others for clip in clips]
    low, high = min(times), max(times)
    if high == 0:
        return "No clip was judged yet."
    many = "The clip was" if len(clips) == 1 else f"Each of {len(clips)} clips was"
    between = f"{low:,}" if low == high else f"{low:,} to {high:,}"
    times_said = "once" if low == high == 1 else f"{between} times"
    return f"{many} judged {times_said}.".replace(",", "\u202f")


def quantile(histogram: Sequence[tuple[int, int]], share: float) -> float:
    """A quantile of values given with how often they occur, in rising order.

    Linear between the neighbours, as NumPy's default (Hyndman and Fan's seventh kind).
    """
    ends = list(accumulate(count for _, count in histogram))
    place = share * (ends[-1] - 1)

    def at(index: int) -> int:
        return next(v for (v, _), end in zip(histogram, ends, strict=True) if index < end)

    low = int(place)
    below, above = at(low), at(min(low + 1, ends[-1] - 1))
    return below + (place - low) * (above - below)


def spoken(seconds: float) -> str:
    """A length of time as one says it: 12 min 40 s."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min" + (f" {whole % 60} s" if whole % 60 and whole < 1800 else "")
    if whole < 172_800:
        return f"{whole // 3600} h {whole % 3600 // 60} min"
    return f"{whole // 86_400} days"


def _bins(histogram: Sequence[tuple[int, int]]) -> list[DurationBin]:
    """Bins of a round width; who took very much longer than most stands in the last, open one."""
    longest = min(histogram[-1][0], int(1.5 * quantile(histogram, 0.95)))
    span = longest - histogram[0][0]
    width = next((w for w in WIDTHS if span < MOST_BINS * w), WIDTHS[-1])
    last = longest // width
    found = Counter[int]()
    for seconds, count in histogram:
        found[min(seconds // width, last)] += count
    first = min(found)
    is_open = histogram[-1][0] >= (last + 1) * width
    return [
        DurationBin(
            start=index * width,
            end=None if is_open and index == last else (index + 1) * width,
            count=found[index],
        )
        for index in range(first, last + 1)
    ]


def _left_where(left: Counter[int], total: int) -> str:
    if not total:
        return "Nobody has come to an end yet."
    if not left:
        return f"Nobody left: all {total} are complete." if total > 1 else "Nobody left."
    told = f"{left.total()} of {total} left early"
    answered, most = max(left.items(), key=lambda item: (item[1], -item[0]))
    if len(left) == 1:
        return f"{told}, at step {answered + 1}."
    return f"{told}; most of them, {most}, at step {answered + 1}." if most > 1 else f"{told}."
