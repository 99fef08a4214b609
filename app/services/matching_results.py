"""How well the targets were matched by each interface: figures 7 to 11, and Wilcoxon's tests."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from app.persistence.responses import Counted
from app.schemas.matching import (
    FigureName,
    MatchBar,
    MatchFigure,
    Matching,
    MatchTest,
    Ranked,
)
from app.schemas.results import Clip
from app.schemas.study import Interface, Match
from app.services.versions import Pooled
from app.statistics.intervals import MeanInterval, Proportion
from app.statistics.matching import (
    OfTarget,
    Samples,
    SignedRank,
    Spread,
    of_target,
    pairwise,
)

REFERENCE: Interface = "weights"
Reached = tuple[float, float | None, float | None, int]  # value, low, high, n


class Answers(NamedTuple):
    """What was answered, each (participants, targets, interfaces); NaN where it was not."""

    guess: Samples
    seconds: Samples
    solved: Samples

    def on(self, target: int | None) -> Answers:
        """The answers on one target, or on all."""
        return self if target is None else Answers(*(one[:, target] for one in self))


class _Drawn(NamedTuple):
    """How a figure is told, and where its numbers are."""

    name: FigureName
    title: str
    unit: str
    reach: str
    values: Callable[[OfTarget], Sequence[Spread | Proportion | MeanInterval | None]]


DEVIATION = "one standard deviation"
WILSON = "Wilson’s 95 % interval"
FIGURES = (
    _Drawn("guess", "Distance of the first guess", "m", DEVIATION, lambda one: one.guess),
    _Drawn("guessed", "Matched by the first guess", "", WILSON, lambda one: one.guessed),
    _Drawn("seconds", "Time to match", "s", DEVIATION, lambda one: one.seconds),
    _Drawn("saved", "Time saved against bare weights", "s", "90 % interval of the mean",
           lambda one: one.saved),
    _Drawn("failed", "Not matched in time", "", WILSON, lambda one: one.failed),
)  # fmt: skip


def matching(asked: Pooled, clips: Sequence[Clip], rows: Sequence[Counted]) -> Matching | None:
    """The numbers of a part that matches targets; None for parts of other kinds."""
    task = asked.task
    if not isinstance(task, Match):
        return None
    answers = answers_of(task, clips, rows)
    reference = task.interfaces.index(REFERENCE) if REFERENCE in task.interfaces else None
    places: list[int | None] = [*range(len(clips)), None] if len(clips) > 1 else [None]
    numbers = {
        place: of_target(
            *answers.on(place), threshold=task.threshold, limit=task.seconds, reference=reference
        )
        for place in places
    }
    labels = {place: None if place is None else clips[place].label for place in places}
    told = {labels[place]: found for place, found in numbers.items()}
    return Matching(
        interfaces=list(task.interfaces),
        targets=[clip.label for clip in clips],
        threshold=task.threshold,
        limit=task.seconds,
        reference=None if reference is None else REFERENCE,
        figures=[
            _figure(drawn, task, told)
            for drawn in FIGURES
            if not (drawn.name == "saved" and reference is None)
            and (task.guess_first or not drawn.name.startswith("guess"))
        ],
        tests=[test for place in places for test in _tests(task, labels[place], answers.on(place))],
        rule=f"A target counts as matched below {task.threshold:g} m; one that was not matched "
        f"within {task.seconds} s counts with the whole time. Tests are Wilcoxon’s signed-rank "
        "test, paired by participant and target; pairs without a difference are left out.",
    )


def answers_of(task: Match, clips: Sequence[Clip], rows: Sequence[Counted]) -> Answers:
    """The answers as arrays; practice and revisions are gone before."""
    people = {one: index for index, one in enumerate(dict.fromkeys(r.session_id for r in rows))}
    targets = {clip.id: index for index, clip in enumerate(clips)}
    shape = (len(people), len(clips), len(task.interfaces))
    found = Answers(*(np.full(shape, np.nan) for _ in Answers._fields))
    for row in rows:
        given = row.answers
        if given.get("interface") not in task.interfaces or row.clips[0] not in targets:
            continue
        interface = task.interfaces.index(given["interface"])
        place = people[row.session_id], targets[row.clips[0]], interface
        if not given["seen"]:
            found.guess[place] = given["distance"]
            continue
        found.seconds[place], found.solved[place] = given["seconds"], given["solved"]
    return found


def _figure(drawn: _Drawn, task: Match, numbers: dict[str | None, OfTarget]) -> MatchFigure:
    bars = [
        _bar(target, interface, value)
        for target, found in numbers.items()
        for interface, value in zip(task.interfaces, drawn.values(found), strict=True)
        if not (drawn.name == "saved" and interface == REFERENCE)
    ]
    return MatchFigure(
        name=drawn.name,
        title=drawn.title,
        unit=drawn.unit,
        reach=drawn.reach,
        bars=bars,
        sentence=_sentence(drawn, [bar for bar in bars if bar.target is None]),
    )


def _bar(
    target: str | None, interface: Interface, found: Spread | Proportion | MeanInterval | None
) -> MatchBar:
    value, low, high, n = (None, None, None, 0) if found is None else _reached(found)
    return MatchBar(target=target, interface=interface, value=value, low=low, high=high, n=n)


def _reached(found: Spread | Proportion | MeanInterval) -> Reached:
    match found:
        case Spread():
            reach = found.sd
            if reach is None:
                return found.mean, None, None, found.n
            return found.mean, found.mean - reach, found.mean + reach, found.n
        case Proportion():
            return found.share, found.low, found.high, found.n
        case MeanInterval():
            return found.mean, found.low, found.high, found.n


def _sentence(drawn: _Drawn, bars: Sequence[MatchBar]) -> str:
    """The overall values in words, the interfaces in order."""
    known = [(bar.interface, bar.value) for bar in bars if bar.value is not None]
    if not known:
        return "There are no answers yet."
    listed = ", ".join(f"{name} {_told(value, drawn.unit)}" for name, value in known)
    return f"Over all targets: {listed}."


def _told(value: float, unit: str) -> str:
    if not unit:
        return f"{round(100 * value)} %"
    digits = 3 if unit == "m" else 0
    return f"{value:.{digits}f} {unit}".replace("-", "\u2212")


def _tests(task: Match, target: str | None, answers: Answers) -> Iterator[MatchTest]:
    for found in pairwise(*answers, limit=task.seconds):
        yield MatchTest(
            target=target,
            one=task.interfaces[found.one],
            other=task.interfaces[found.other],
            guess=_ranked(found.guess),
            seconds=_ranked(found.seconds),
        )


def _ranked(found: SignedRank | None) -> Ranked | None:
    if found is None:
        return None
    return Ranked(
        statistic=found.statistic, p=found.p, n=found.n, zeros=found.zeros, exact=found.exact
    )
