"""Charts of a matching experiment: interfaces beside each other on every target."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from app.figures import theme
from app.figures.clips import SCHEMA, Width
from app.figures.theme import Mode

LANE, BETWEEN = 16, 26  # px of each interface, and between two targets
ALL = "all targets"
PERCENT = "replace(format(datum.value, '.0%'), '%', ' %')"


@dataclass(frozen=True)
class Bar:
    """One interface on one target; `low` and `high` are None where there is no interval."""

    target: str
    interface: str
    value: float
    low: float | None
    high: float | None


def targets(
    bars: Sequence[Bar],
    interfaces: Sequence[str],
    title: str,
    unit: str,
    mode: Mode,
    width: Width = "container",
) -> dict[str, Any]:
    """Dots with their intervals, a group of lanes a target, an interface in each lane."""
    colours = theme.palette(mode)
    fills = theme.tokens()["data"]["group"][mode][: len(interfaces)]
    rows = list(dict.fromkeys(bar.target for bar in bars))
    axis: dict[str, Any] = {"tickCount": 5}
    if not unit:
        axis |= {"labelExpr": PERCENT}
    x: dict[str, Any] = {
        "field": "value",
        "type": "quantitative",
        "title": unit or None,
        "axis": axis,
        "scale": {"domain": [0, 1]} if not unit else {"nice": True, "zero": True},
    }
    colour = {
        "field": "interface",
        "type": "nominal",
        "title": None,
        "scale": {"domain": list(interfaces), "range": list(fills)},
        "legend": {"orient": "top", "symbolType": "circle"},
    }
    reaches = {
        "transform": [{"filter": "isValid(datum.low)"}],
        "mark": {"type": "rule", "strokeWidth": 2},
        "encoding": {
            "x": {**x, "field": "low"},
            "x2": {"field": "high"},
            "color": colour,
        },
    }
    dots = {
        "mark": {"type": "point", "filled": True, "size": 60, "opacity": 1},
        "encoding": {"x": x, "color": colour},
    }
    return {
        "$schema": SCHEMA,
        "config": theme.config(mode),
        "width": width,
        "height": len(rows) * (LANE * len(interfaces) + BETWEEN),
        "autosize": {"type": "fit-x", "contains": "padding"},
        "data": {"values": [_row(bar) for bar in bars]},
        "encoding": {
            "y": {
                "field": "target",
                "type": "nominal",
                "sort": rows,
                "title": None,
                "scale": {"paddingInner": 0.35},
                "axis": {"grid": True, "gridColor": colours.line},
            },
            "yOffset": {"field": "interface", "type": "nominal", "sort": list(interfaces)},
        },
        "layer": [reaches, dots],
        "description": f"{title}, by target and interface.",
    }


def _row(bar: Bar) -> dict[str, Any]:
    return {
        "target": bar.target,
        "interface": bar.interface,
        "value": bar.value,
        "low": bar.low,
        "high": bar.high,
    }
