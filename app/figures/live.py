"""Charts of a study while it runs: who stands where, where they leave, how long they take."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from app.figures import theme
from app.figures.clips import ROW, SCHEMA, Width
from app.figures.theme import Mode, Palette

STATES = ("complete", "under way", "left early", "ended early")
CURVE_HEIGHT = 200
MINUTES = (
    "floor(datum.value / 60) + (datum.value % 60 ? ':' + format(datum.value % 60, '02d') : '')"
)
PERCENT = "replace(format(datum.value, '.0%'), '%', ' %')"
MOST_ROWS = 60  # more clips than these are told by columns without names


@dataclass(frozen=True)
class GroupBar:
    """How many of a group stand in each of `STATES`."""

    label: str
    numbers: Sequence[int]


@dataclass(frozen=True)
class Bin:
    """How many took at least `start` and less than `end` seconds."""

    start: int
    end: int
    count: int
    is_open: bool


class ClipBar(NamedTuple):
    """How often a clip was judged, by complete participants and by others."""

    label: str
    complete: int
    others: int


def standing(groups: Sequence[GroupBar], mode: Mode, width: Width = "container") -> dict[str, Any]:
    """Stacked bars, one a group, with the numbers in them."""
    colours = theme.palette(mode)
    fills, on_fills = _state_colours(colours)
    most = max((sum(group.numbers) for group in groups), default=0) or 1
    values = [part for group in groups for part in _parts(group, most)]
    x = {"field": "from", "type": "quantitative", "title": None,
         "scale": {"domain": [0, most], "nice": False},
         "axis": {"tickMinStep": 1, "tickCount": 5, "format": "d"}}  # fmt: skip
    bars = {
        "mark": {"type": "bar", "height": ROW - 4},
        "encoding": {"x": x, "x2": {"field": "to"}, "color": _by("state", STATES, fills)},
    }
    numbers = {
        "transform": [{"filter": "datum.wide"}],
        "mark": {"type": "text"},
        "encoding": {
            "x": {"field": "middle", "type": "quantitative"},
            "text": {"field": "count", "type": "nominal"},
            "color": {**_by("state", STATES, on_fills), "legend": None},
        },
    }
    spec = _base(mode, width, (ROW + 6) * len(groups))
    spec["encoding"] = {
        "y": {"field": "group", "type": "nominal", "title": None,
              "sort": [group.label for group in groups]}
    }  # fmt: skip
    spec["layer"] = [bars, numbers]
    spec["data"] = {"values": values}
    spec["resolve"] = {"scale": {"color": "independent"}}
    spec["description"] = "Participants by group and by how far they are."
    return spec


def dropout(
    steps: Sequence[tuple[int, int]],
    total: int,
    parts: Sequence[tuple[int, str]],
    mode: Mode,
    width: Width = "container",
) -> dict[str, Any]:
    """How many of `total` are still there after each step, as a falling line.

    Args:
        steps: steps answered, and how many had not left by then.
        total: all of them.
        parts: steps at which another part of the study begins, with its name.
        mode: light or dark.
        width: of the chart in pixels.
    """
    colours = theme.palette(mode)
    last = max((answered for answered, _ in steps), default=1) or 1
    values = [{"answered": answered, "share": still / total} for answered, still in steps]
    x = {"field": "answered", "type": "quantitative", "title": "steps answered",
         "scale": {"domain": [0, last], "nice": False},
         "axis": {"grid": False, "tickMinStep": 1, "format": "d"}}  # fmt: skip
    y = {"field": "share", "type": "quantitative", "title": None,
         "scale": {"domain": [0, 1]},
         "axis": {"tickCount": 4, "labelExpr": PERCENT}}  # fmt: skip
    line = {"type": "line", "interpolate": "step-after", "strokeWidth": 2.5,
            "color": colours.steps[0]}  # fmt: skip
    area = {"type": "area", "interpolate": "step-after", "color": colours.steps[0], "opacity": 0.12}
    spec = _base(mode, width, CURVE_HEIGHT)
    spec["data"] = {"values": values}
    encoding = {"x": x, "y": y}
    curves = [{"mark": mark, "encoding": encoding} for mark in (area, line)]
    spec["layer"] = [*curves, *_part_lines(parts, colours)]
    spec["description"] = f"Share of {total} participants still there after each step."
    return spec


def durations(
    bins: Sequence[Bin], median: float | None, mode: Mode, width: Width = "container"
) -> dict[str, Any]:
    """How long complete participants took, the median (seconds) marked; one bin at least."""
    colours = theme.palette(mode)
    values = [{"from": b.start, "to": b.end, "count": b.count} for b in bins]
    edges = [*(b.start for b in bins), bins[-1].end]
    marks, labels = edges[:: 1 + len(edges) // 8], MINUTES
    if bins[-1].is_open:
        labels += f" + (datum.value >= {edges[-1]} ? ' or more' : '')"
    x = {"field": "from", "type": "quantitative", "title": "minutes",
         "scale": {"domain": [edges[0], edges[-1]], "nice": False},
         "axis": {"grid": False, "labelExpr": labels, "values": marks}}  # fmt: skip
    y = {"field": "count", "type": "quantitative", "title": None,
         "axis": {"tickCount": 4, "tickMinStep": 1, "format": "d"}}  # fmt: skip
    bars = {
        "mark": {"type": "bar", "color": colours.steps[1], "binSpacing": 2},
        "encoding": {"x": {**x, "bin": "binned"}, "x2": {"field": "to"}, "y": y},
    }
    spec = _base(mode, width, CURVE_HEIGHT)
    spec["data"] = {"values": values}
    spec["layer"] = [bars]
    if median is not None:
        spec["layer"].append({
            "data": {"values": [{}]},
            "mark": {"type": "rule", "color": colours.ink, "strokeWidth": 1.5},
            "encoding": {"x": {"datum": median, "type": "quantitative"}},
        })  # fmt: skip
    spec["description"] = "How long complete participants took, in minutes."
    return spec


def clips(bars: Sequence[ClipBar], mode: Mode, width: Width = "container") -> dict[str, Any]:
    """How often each clip was judged, the rarest first."""
    colours = theme.palette(mode)
    kinds = ("by complete participants", "by others")
    ordered = sorted(bars, key=lambda bar: bar.complete + bar.others)
    values = [
        {"clip": bar.label, "place": place, "by": by, "count": count, "order": order}
        for place, bar in enumerate(ordered)
        for order, (by, count) in enumerate(zip(kinds, (bar.complete, bar.others), strict=True))
    ]
    named = len(ordered) <= MOST_ROWS
    along = {"field": "count", "type": "quantitative", "title": None, "stack": "zero",
             "axis": {"tickCount": 4, "tickMinStep": 1, "format": "d"}}  # fmt: skip
    across = (
        {"field": "clip", "type": "nominal", "title": None,
         "sort": [bar.label for bar in ordered]}
        if named
        else {"field": "place", "type": "ordinal", "title": "clips, the rarest first",
              "axis": {"labels": False}}
    )  # fmt: skip
    spec = _base(mode, width, ROW * len(ordered) if named else CURVE_HEIGHT)
    spec["data"] = {"values": values}
    spec["layer"] = [
        {
            "mark": {"type": "bar", **({"height": ROW - 8} if named else {})},
            "encoding": {
                ("x" if named else "y"): along,
                ("y" if named else "x"): across,
                "color": _by("by", kinds, [colours.steps[0], colours.steps[1]]),
                "order": {"field": "order"},
            },
        }
    ]
    spec["description"] = "How often each clip was judged."
    return spec


def _base(mode: Mode, width: Width, height: int) -> dict[str, Any]:
    return {
        "$schema": SCHEMA,
        "config": theme.config(mode),
        "width": width,
        "height": height,
        "autosize": {"type": "fit-x", "contains": "padding"},
    }


def _state_colours(colours: Palette) -> tuple[list[str], list[str]]:
    """Fill and text colour of each state: blue is well, ochre is lost; words say it too."""
    places = (0, 1, 3, 4)
    return [colours.steps[i] for i in places], [colours.on_steps[i] for i in places]


def _by(field: str, names: Sequence[str], colours: Sequence[str]) -> dict[str, Any]:
    scale = {"domain": list(names), "range": list(colours)}
    return {"field": field, "type": "nominal", "scale": scale}


def _parts(group: GroupBar, most: int) -> list[dict[str, Any]]:
    found, start = [], 0
    for state, count in zip(STATES, group.numbers, strict=True):
        found.append({
            "group": group.label, "state": state, "count": f"{count:,}".replace(",", "\u202f"),
            "from": start, "to": start + count, "middle": start + count / 2,
            "wide": count >= 0.05 * most,
        })  # fmt: skip
        start += count
    return found


def _part_lines(parts: Sequence[tuple[int, str]], colours: Palette) -> list[dict[str, Any]]:
    """A hair line where another part begins, its name beside it."""
    values = [{"at": at, "name": name.replace("_", " ")} for at, name in parts]
    x = {"field": "at", "type": "quantitative"}
    bottom = {"datum": 0, "type": "quantitative"}
    return [
        {
            "data": {"values": values},
            "mark": {"type": "rule", "color": colours.line_strong, "strokeDash": [2, 3]},
            "encoding": {"x": x},
        },
        {
            "data": {"values": values},
            "mark": {"type": "text", "align": "left", "dx": 4, "baseline": "bottom",
                     "color": colours.ink_2},
            "encoding": {"x": x, "y": bottom, "text": {"field": "name", "type": "nominal"}},
        },
    ]  # fmt: skip
