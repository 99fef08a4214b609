"""The live page's numbers from what the database has counted. Pure functions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from itertools import accumulate

from app.persistence.live import Standing
from app.schemas.live import (
    ClipCount,
    Dropout,
    DropoutStep,
    DurationBin,
    Durations,
    GroupCounts,
    LiveCounts,
    Stands,
)
from app.services.summaries import counted

WIDTHS = (5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600, 7200, 21_600, 86_400)  # seconds
MOST_BINS = 24
EVERYBODY = "Everybody"


def stands(state: str, going: bool) -> Stands:
    """Where somebody stands, by the session's state and by whether there was a sign lately."""
    if state == "active":
        return "under_way" if going else "left_early"
    if state in ("screened_out", "failed_attention"):
        return "ended_early"
    return "complete" if state == "complete" else "withdrawn"


def counts(standings: Sequence[Standing], excluded: int) -> LiveCounts:
    """How many stand where in all."""
    found = Counter[Stands]()
    for one in standings:
        found[stands(one.state, one.going)] += one.sessions
    return LiveCounts(
        complete=found["complete"],
        under_way=found["under_way"],
        left_early=found["left_early"],
        ended_early=found["ended_early"],
        withdrawn=found["withdrawn"],
        excluded=excluded,
        answers=sum(one.answered * one.sessions for one in standings),
    )


def by_group(standings: Sequence[Standing], labels: Mapping[str, str]) -> list[GroupCounts]:
    """The same by group, in the definition's order; one row of everybody where there are none."""
    names: list[str | None] = [*labels] or [None]
    found: dict[str | None, Counter[Stands]] = {name: Counter() for name in names}
    for one in standings:
        if one.state != "withdrawn":  # of whom nothing is known, the group neither
            group = found.setdefault(one.group, Counter())
            group[stands(one.state, one.going)] += one.sessions
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


def dropout(standings: Sequence[Standing]) -> Dropout:
    """How many are still there after each step, of those who are complete or have left."""
    complete, left = 0, Counter[int]()
    for one in standings:
        where = stands(one.state, one.going)
        if where == "complete":
            complete += one.sessions
        elif where == "left_early":
            left[one.answered] += one.sessions
    total = complete + left.total()
    length = max((max(one.steps, one.answered) for one in standings), default=0)
    gone = accumulate((left[answered] for answered in range(length)), initial=0)
    steps = [
        DropoutStep(answered=answered, still=total - before, left=left[answered])
        for answered, before in enumerate(gone)
    ]
    return Dropout(
        of=total, steps=steps if total and length else [], sentence=_left_where(left, total)
    )


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
    seen: Iterable[tuple[int, bool, str]],
    places: Mapping[int, Sequence[str]],
    labels: Mapping[str, str],
) -> list[ClipCount]:
    """How often each clip was judged.

    Args:
        seen: version, whether complete, and the joined places of the judged clips.
        places: version to its clips, in the order of their places.
        labels: the clips to be listed, in their order.
    """
    found: dict[bool, Counter[str]] = {True: Counter(), False: Counter()}
    for version, complete, text in seen:
        for place, times in counted(text).items():
            found[complete][places[version][place]] += times
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
    return f"{many} judged {between} times.".replace(",", "\u202f")


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
    width = next((w for w in WIDTHS if longest < MOST_BINS * w), WIDTHS[-1])
    last = min(longest // width, MOST_BINS - 1)
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
