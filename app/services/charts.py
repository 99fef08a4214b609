"""A study's charts: results put into the figures' words. Two an axis: `shares-…` and `means-…`."""

from __future__ import annotations

from typing import Any

from app.errors import NotFoundError
from app.figures import clips as figures
from app.figures import render
from app.figures.theme import Mode
from app.schemas.results import Axis, StudyResults

KINDS = {"shares": figures.shares, "means": figures.intervals}
PRINT_WIDTH = 620


def page_charts(results: StudyResults) -> dict[str, dict[str, Any]]:
    """Name to {"light": specification, "dark": specification}, as wide as their place in the page.

    Empty as long as too few participants are complete.
    """
    return {
        f"{kind}-{axis.id}": {mode: _chart(results, axis, kind, mode) for mode in _MODES}
        for axis in results.axes
        for kind in KINDS
        if _clips(results, axis)
    }


def printed(results: StudyResults, name: str, mode: Mode) -> str:
    """One chart as SVG, for print.

    Raises:
        NotFoundError: no such chart, or not yet.
    """
    kind, _, axis_id = name.partition("-")
    axis = next((axis for axis in results.axes if axis.id == axis_id), None)
    if axis is None or kind not in KINDS:
        raise NotFoundError(
            f"This study has no chart “{name[:80]}”.",
            code="figure_not_found",
            mend="Take one of the charts that the results page links to.",
        )
    if not _clips(results, axis):
        raise NotFoundError(axis.sentence, code="too_few_answers", mend="Wait for more answers.")
    return render.svg(_chart(results, axis, kind, mode, PRINT_WIDTH))


_MODES: tuple[Mode, Mode] = ("light", "dark")


def _chart(
    results: StudyResults, axis: Axis, kind: str, mode: Mode, width: figures.Width = "container"
) -> dict[str, Any]:
    words = figures.AxisWords(axis.left, axis.right, results.steps)
    return KINDS[kind](_clips(results, axis), words, mode, width)


def _clips(results: StudyResults, axis: Axis) -> list[figures.ClipOnAxis]:
    return [
        figures.ClipOnAxis(clip.label, cell.mean, cell.low, cell.high, cell.shares)
        for clip, cell in zip(results.clips, axis.cells, strict=True)
        if cell.mean is not None and cell.low is not None and cell.high is not None and cell.shares
    ]
