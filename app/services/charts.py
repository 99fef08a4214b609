"""A study's charts: results put into the figures' words.

Of each axis `shares-…` (where it has steps) and `means-…`; of choices `chosen-…`; of matches
`matching-…`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from app.errors import NotFoundError
from app.figures import clips as figures
from app.figures import render
from app.figures.matching import ALL, Bar, targets
from app.figures.theme import Mode
from app.schemas.matching import MatchFigure
from app.schemas.results import Axis, Choices, StudyResults

PRINT_WIDTH = 620
Draw = Callable[[Mode, figures.Width], dict[str, Any]]


def page_charts(results: StudyResults) -> dict[str, dict[str, Any]]:
    """Name to {"light": specification, "dark": specification}, as wide as their place in the page.

    Empty as long as too few participants are complete.
    """
    return {
        name: {mode: draw(mode, "container") for mode in _MODES}
        for name, draw in _charts(results).items()
    }


def printed(results: StudyResults, name: str, mode: Mode) -> str:
    """One chart as SVG, for print.

    Raises:
        NotFoundError: no such chart, or not yet.
    """
    draw = _charts(results).get(name)
    if draw is not None:
        return render.svg(draw(mode, PRINT_WIDTH))
    waiting = {
        **{f"{kind}-{axis.id}": axis.sentence for axis in results.axes for kind in _OF_AXES},
        **{f"chosen-{choices.id}": choices.sentence for choices in results.choices},
    }
    if name in waiting:
        raise NotFoundError(waiting[name], code="too_few_answers", mend="Wait for more answers.")
    raise NotFoundError(
        f"This study has no chart “{name[:80]}”.",
        code="figure_not_found",
        mend="Take one of the charts that the results page links to.",
    )


_OF_AXES = ("shares", "means")
_MODES: tuple[Mode, Mode] = ("light", "dark")


def _charts(results: StudyResults) -> dict[str, Draw]:
    found: dict[str, Draw] = {}
    for axis in results.axes:
        if clips := _clips(results, axis):
            words = _words(axis)
            if axis.steps:
                found[f"shares-{axis.id}"] = partial(figures.shares, clips, words)
            found[f"means-{axis.id}"] = partial(figures.intervals, clips, words)
    for choices in results.choices:
        if options := _options(choices):
            found[f"chosen-{choices.id}"] = partial(figures.chosen, options, choices.chance)
    if results.matching is not None:
        for figure in results.matching.figures:
            if bars := _bars(figure):
                found[f"matching-{figure.name}"] = partial(
                    targets, bars, results.matching.interfaces, figure.title, figure.unit
                )
    return found


def _bars(figure: MatchFigure) -> list[Bar]:
    return [
        Bar(bar.target or ALL, bar.interface, bar.value, bar.low, bar.high)
        for bar in figure.bars
        if bar.value is not None
    ]


def _words(axis: Axis) -> figures.AxisWords:
    return figures.AxisWords(
        axis.left, axis.right, axis.steps, axis.lowest, axis.highest, axis.bipolar
    )


def _clips(results: StudyResults, axis: Axis) -> list[figures.ClipOnAxis]:
    return [
        figures.ClipOnAxis(clip.label, cell.mean, cell.low, cell.high, cell.shares or ())
        for clip, cell in zip(results.clips, axis.cells, strict=True)
        if cell.mean is not None and cell.low is not None and cell.high is not None
    ]


def _options(choices: Choices) -> list[figures.Option]:
    found = [
        figures.Option(row.name, row.share, row.low, row.high)
        for row in choices.rows
        if row.share is not None and row.low is not None and row.high is not None
    ]
    return sorted(found, key=lambda option: -option.share)
