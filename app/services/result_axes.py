"""Every clip on every axis: means with intervals, and how the answers spread over the steps."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from app.persistence.responses import Counted
from app.schemas.results import Axis, Cell, Clip
from app.services import sentences
from app.services.measures import EACH_FIGURE, Measure
from app.services.versions import Pooled
from app.statistics.intervals import Samples, mean_interval, present

NEEDED = 5


def rating_array(asked: Pooled, rows: Sequence[Counted]) -> Samples:
    """The analysed numbers, (participants, clips, axes); NaN where one is missing.

    A clip that a participant rated several times, in several sets, has the mean.
    """
    people = {one: index for index, one in enumerate(dict.fromkeys(r.session_id for r in rows))}
    clips = {stimulus.clip: index for index, stimulus in enumerate(asked.stimuli)}
    names = [measure.id for measure in _numeric(asked)]
    sums = np.zeros((len(people), len(clips), len(names)))
    times = np.zeros_like(sums)
    for row in rows:
        person = people[row.session_id]
        for clip, values in _given(asked, row, names):
            given = np.array([np.nan if one is None else float(one) for one in values])
            sums[person, clips[clip]] += np.nan_to_num(given)
            times[person, clips[clip]] += ~np.isnan(given)
    return np.divide(sums, times, out=np.full_like(sums, np.nan), where=times > 0)


def axes(asked: Pooled, clips: Sequence[Clip], ratings: Samples) -> list[Axis]:
    """All axes of a part; ratings (participants, clips, axes)."""
    return [
        _axis(measure, clips, ratings[:, :, index]) for index, measure in enumerate(_numeric(asked))
    ]


def _numeric(asked: Pooled) -> list[Measure]:
    return [measure for measure in asked.measures if measure.numeric]


def _given(
    asked: Pooled, row: Counted, names: Sequence[str]
) -> Iterator[tuple[str, list[float | None]]]:
    """Each clip that an answer rates, with its numbers."""
    if asked.task.kind in EACH_FIGURE:
        for place, clip in enumerate(row.clips):
            yield clip, [row.answers.get(str(place))]
    elif names:
        yield row.clips[0], [row.answers.get(name) for name in names]


def _axis(measure: Measure, clips: Sequence[Clip], ratings: Samples) -> Axis:
    """All clips on one scale; ratings (participants, clips)."""
    cells = [_cell(clip, ratings[:, index], measure) for index, clip in enumerate(clips)]
    means = [(cell.mean, clip.label) for cell, clip in zip(cells, clips, strict=True)]
    known = [(mean, label) for mean, label in means if mean is not None]
    sentence = too_few(len(ratings))
    if known:
        (low, lowest), (high, highest) = min(known), max(known)
        left, right = (measure.left, lowest, low), (measure.right, highest, high)
        poled = measure.trial_type not in ("unipolar", "likert")
        sentence = sentences.extremes(left, right) if poled else sentences.range_of(left, right)
    between = measure.trial_type in ("semantic_differential", "analogue")
    return Axis(
        id=measure.id,
        title=f"{measure.left} – {measure.right}" if between else _unquoted(measure),
        left=measure.left,
        right=measure.right,
        bipolar=measure.trial_type == "semantic_differential",
        lowest=measure.lowest or 0,
        highest=measure.highest or 0,
        steps=list(measure.steps),
        cells=cells,
        sentence=sentence,
    )


def _unquoted(measure: Measure) -> str:
    names = {"parallel": "Rating", "ranking": "Rank"}
    return names.get(measure.trial_type) or measure.title.strip("“”")


def _cell(clip: Clip, values: Samples, measure: Measure) -> Cell:
    given = present(values)
    found = mean_interval(given) if given.size >= NEEDED else None
    if found is None:
        return Cell(
            clip=clip.id, n=given.size, mean=None, sd=None, low=None, high=None, shares=None
        )
    steps = [value for value, _ in measure.levels if isinstance(value, int)]
    return Cell(
        clip=clip.id,
        n=found.n,
        mean=found.mean,
        sd=found.sd,
        low=found.low,
        high=found.high,
        shares=[float(np.mean(given == step)) for step in steps] or None,
    )


def too_few(participants: int) -> str:
    """What to say where nothing can be computed yet."""
    return f"This needs five complete participants; so far there are {participants}."
