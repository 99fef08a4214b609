"""The live page's charts: its numbers put into the figures' words."""

from __future__ import annotations

from typing import Any, get_args

from app.figures import live as figures
from app.figures.theme import Mode
from app.schemas.live import LiveView

MODES: tuple[Mode, ...] = get_args(Mode)
Charts = dict[str, dict[Mode, dict[str, Any]]]


def _standing(view: LiveView, mode: Mode) -> dict[str, Any]:
    bars = [
        figures.GroupBar(
            group.label,
            (group.complete, group.under_way, group.left_early, group.ended_early),
        )
        for group in view.groups
    ]
    return figures.standing(bars, mode)


def _dropout(view: LiveView, mode: Mode) -> dict[str, Any]:
    steps = [(one.answered, one.still) for one in view.dropout.steps]
    parts = [(one.start, one.name) for one in view.dropout.parts]
    return figures.dropout(steps, view.dropout.of, parts, mode)


def _durations(view: LiveView, mode: Mode) -> dict[str, Any]:
    first = view.durations.bins[0]
    width = first.end - first.start if first.end is not None else 60
    bins = [
        figures.Bin(one.start, one.end or one.start + width, one.count, one.end is None)
        for one in view.durations.bins
    ]
    return figures.durations(bins, view.durations.median_seconds, mode)


def _clips(view: LiveView, mode: Mode) -> dict[str, Any]:
    bars = [figures.ClipBar(one.label, one.complete, one.others) for one in view.clips]
    return figures.clips(bars, mode)


def page_charts(view: LiveView) -> Charts:
    """Name to {"light": specification, "dark": specification}; none of what has no data yet."""
    wanted = {
        "standing": (_standing, any(g.complete + g.under_way + g.left_early + g.ended_early
                                    for g in view.groups)),
        "dropout": (_dropout, bool(view.dropout.steps)),
        "durations": (_durations, bool(view.durations.bins)),
        "clips": (_clips, any(one.complete + one.others for one in view.clips)),
    }  # fmt: skip
    return {
        name: {mode: chart(view, mode) for mode in MODES}
        for name, (chart, has_data) in wanted.items()
        if has_data
    }
