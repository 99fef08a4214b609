"""Curves: how much of a known structure is found again."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isnan
from typing import Any

from app.figures import theme
from app.figures.theme import Mode

_WIDTH, _HEIGHT = 300, 190


@dataclass(frozen=True)
class Curve:
    """One line: values in 0 … 1 over noise or number of raters; a band where both ends are given.

    Attributes:
        name: in the legend; the same in all panels.
        row: the panel's row, such as a set of motions.
        places: where the values lie.
        values: between which the line is drawn.
        low, high: of the band about it; empty for none.
    """

    name: str
    row: str
    places: Sequence[float]
    values: Sequence[float]
    low: Sequence[float] = ()
    high: Sequence[float] = ()


@dataclass(frozen=True)
class Axis:
    """What the curves of one column lie over, and the place that the paper has on it."""

    title: str
    paper: float
    logarithmic: bool = False


def recovery(columns: Sequence[tuple[Axis, Sequence[Curve]]], mode: Mode) -> dict[str, Any]:
    """A grid of panels: the axes beside each other, the curves' rows below each other."""
    names = list(dict.fromkeys(curve.name for _, curves in columns for curve in curves))
    rows = list(dict.fromkeys(curve.row for _, curves in columns for curve in curves))
    panels = [
        _panel(axis, [curve for curve in curves if curve.row == row], names, mode, row)
        for row in rows
        for axis, curves in columns
    ]
    config = theme.config(mode)
    colour = theme.tokens()["colour"][mode]
    config["background"] = colour["surface"]  # a picture in a page of unknown colour
    config["padding"] = 16
    config["font"] = "sans-serif"  # a file by itself has no web fonts
    config["legend"] |= {"labelLimit": 400}
    config["title"] = {"color": colour["ink"], "fontSize": 14, "fontWeight": 500, "anchor": "start"}
    return {
        "$schema": "https://vega.github.io/schema/vega-lite/v6.json",
        "description": "How much of a known structure is found again: " + ", ".join(names) + ".",
        "concat": panels,
        "columns": len(columns),
        "spacing": 28,
        "config": config,
    }


def _panel(
    axis: Axis, curves: Sequence[Curve], names: list[str], mode: Mode, row: str
) -> dict[str, Any]:
    colours = theme.palette(mode)
    x = {
        "field": "x",
        "type": "quantitative",
        "title": axis.title,
        "scale": {"type": "log", "nice": False} if axis.logarithmic else {"zero": True},
        "axis": {"grid": False, "values": sorted({*curves[0].places}), "labelOverlap": True}
        if axis.logarithmic
        else {"grid": False, "tickCount": 6},
    }
    y = {
        "field": "y",
        "type": "quantitative",
        "title": None,
        "scale": {"domain": [-0.1, 1.05], "nice": False},
        "axis": {"values": [0, 0.25, 0.5, 0.75, 1], "format": ".2f"},
    }
    colour = {
        "field": "name",
        "type": "nominal",
        "scale": {"domain": names, "range": theme.tokens()["data"]["group"][mode]},
        "legend": {
            "columns": 1,
            "symbolType": "stroke",
            "symbolStrokeWidth": 3,
            "symbolOpacity": 1,
        },
    }
    band = {
        "transform": [{"filter": "isValid(datum.low)"}],
        "mark": {"type": "area", "opacity": 0.15},
        "encoding": {"y": y | {"field": "low"}, "y2": {"field": "high"}, "color": colour},
    }
    line = {
        "mark": {"type": "line", "strokeWidth": 2, "point": {"size": 22, "filled": True}},
        "encoding": {"y": y, "color": colour},
    }
    paper = {
        "data": {"values": [{"x": axis.paper}]},
        "mark": {"type": "rule", "strokeDash": [4, 3], "color": colours.line_strong},
    }
    return {
        "title": row,
        "width": _WIDTH,
        "height": _HEIGHT,
        "data": {"values": [place for curve in curves for place in _places(curve)]},
        "encoding": {"x": x},
        "layer": [paper, band, line],
    }


def _places(curve: Curve) -> list[dict[str, Any]]:
    """The curve as data, where it is defined; a thousandth is finer than a picture shows."""
    values = {"x": curve.places, "y": curve.values}
    if curve.low:
        values |= {"low": curve.low, "high": curve.high}
    rows = [dict(zip(values, place, strict=True)) for place in zip(*values.values(), strict=True)]
    return [
        {"name": curve.name} | {key: round(value, 3) for key, value in row.items()}
        for row in rows
        if not isnan(row["y"])
    ]
