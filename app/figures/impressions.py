"""Figures of an analysis of adjective pairs: the impression matrix, and Ward's tree."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from app.figures import theme
from app.figures.clips import SCHEMA, Width
from app.figures.theme import Mode

ROW = 20
REST = 4  # the last of the group colours: above the cut


@dataclass(frozen=True)
class Row:
    """A pair under the tree: its words, its cluster's number and title."""

    label: str
    cluster: int
    title: str


@dataclass(frozen=True)
class Joint:
    """Two branches become one: where each stands on the leaves' side, and how high they lie.

    Attributes:
        places, heights: of the two branches; height: of the joint.
        cluster: number of the cluster that all its leaves are in; None above the cut.
    """

    places: tuple[float, float]
    heights: tuple[float, float]
    height: float
    cluster: int | None


def heat_map(
    rows: Sequence[Row],
    clips: Sequence[str],
    values: Sequence[Sequence[float | None]],
    mode: Mode,
    width: Width = "container",
) -> dict[str, Any]:
    """The impression matrix: pairs as rows in the tree's order, clips as columns.

    Args:
        rows: from top to bottom.
        clips: labels from left to right.
        values: clips × rows, 0 (left word) to 1 (right word); None where nobody rated.
        mode: light or dark.
        width: of the whole chart.
    """
    labels, columns = _apart([row.label for row in rows]), _apart(clips)
    cells = [
        {"pair": label, "clip": clip, "value": value}
        for clip, of_clip in zip(columns, values, strict=True)
        for label, value in zip(labels, of_clip, strict=True)
        if value is not None
    ]
    ramp = theme.palette(mode).steps
    colour = {
        "field": "value",
        "type": "quantitative",
        "scale": {
            "domain": [step / (len(ramp) - 1) for step in range(len(ramp))],
            "range": list(ramp),
            "interpolate": "lab",
        },
        "legend": {"type": "gradient", "values": [0, 0.5, 1], "labelExpr": _ENDS},
    }
    matrix = {
        "data": {"values": cells},
        "mark": {"type": "rect"},
        "encoding": {
            "x": {
                "field": "clip",
                "type": "nominal",
                "sort": columns,
                "title": None,
                "axis": {"labelAngle": -60, "labelLimit": 160},
            },
            "color": colour,
        },
    }
    spec = _framed(rows, mode, width)
    spec["encoding"] = {
        "y": {"field": "pair", "type": "nominal", "sort": labels, "title": None,
              "scale": {"domain": labels}}
    }  # fmt: skip
    spec["layer"] = [matrix, _titles(rows, labels, mode)]
    spec["resolve"] = {"scale": {"color": "independent"}}
    spec["description"] = (
        f"Impressions of {len(clips)} clips on {len(rows)} pairs of adjectives, from 0 (the left "
        "word) to 1 (the right word), in the order of the tree."
    )
    return spec


def dendrogram(
    rows: Sequence[Row],
    joints: Sequence[Joint],
    cut: float | None,
    mode: Mode,
    width: Width = "container",
) -> dict[str, Any]:
    """Ward's tree lying on its side: leaves as rows, heights to the right, the cut dashed.

    Args:
        rows: the leaves from top to bottom.
        joints: the merges; places count rows from 0.
        cut: the height at which the tree is cut; None where everything is one cluster.
        mode: light or dark.
        width: of the whole chart.
    """
    colours = theme.palette(mode)
    groups = theme.tokens()["data"]["group"][mode]
    labels = _apart([row.label for row in rows])
    lines = [line for number, joint in enumerate(joints) for line in _elbow(number, joint)]
    place = {
        "field": "place",
        "type": "quantitative",
        "title": None,
        "scale": {"domain": [-0.5, len(rows) - 0.5], "reverse": True, "nice": False, "zero": False},
        "axis": {
            "values": list(range(len(rows))),
            "labelExpr": f"{json.dumps(labels)}[datum.value]",
            "labelOverlap": False,
            "grid": False,
        },
    }
    tree = {
        "data": {"values": lines},
        "mark": {"type": "line", "strokeWidth": 1.5, "interpolate": "linear"},
        "encoding": {
            "x": {
                "field": "height", "type": "quantitative", "title": "height, √(2 ΔE)",
                "scale": {"zero": True, "nice": False}, "axis": {"grid": False, "tickCount": 6},
            },
            "detail": {"field": "joint", "type": "nominal"},
            "order": {"field": "step", "type": "quantitative"},
            "color": {
                "field": "group", "type": "nominal", "legend": None,
                "scale": {"domain": list(range(len(groups))), "range": groups},
            },
        },
    }  # fmt: skip
    dashed = {
        "data": {"values": [{}]},
        "mark": {"type": "rule", "color": colours.ink_2, "strokeDash": [4, 3]},
        "encoding": {"x": {"datum": cut, "type": "quantitative"}, "y": None},
    }
    spec = _framed(rows, mode, width)
    spec["encoding"] = {"y": place}
    spec["layer"] = [tree, _titles(rows, labels, mode), *([dashed] if cut is not None else [])]
    spec["resolve"] = {"scale": {"color": "independent"}}
    spec["description"] = (
        f"Ward's tree of {len(rows)} pairs of adjectives in {len({row.cluster for row in rows})} "
        "clusters; the further to the right two branches meet, the less alike they are."
    )
    return spec


_ENDS = "datum.value == 0 ? 'left word' : datum.value == 1 ? 'right word' : 'between'"


def _framed(rows: Sequence[Row], mode: Mode, width: Width) -> dict[str, Any]:
    return {
        "$schema": SCHEMA,
        "config": theme.config(mode),
        "width": width,
        "height": ROW * len(rows),
        "autosize": {"type": "fit-x", "contains": "padding"},
    }


def _titles(rows: Sequence[Row], labels: Sequence[str], mode: Mode) -> dict[str, Any]:
    """The title of each run of rows of one cluster, beside its middle row."""
    groups = theme.tokens()["data"]["group"][mode]
    told = []
    for (cluster, title), run in groupby(enumerate(rows), lambda at: (at[1].cluster, at[1].title)):
        places = [place for place, _ in run]
        told.append(
            {
                "pair": labels[places[len(places) // 2]],
                "place": (places[0] + places[-1]) / 2,
                "title": title,
                "colour": groups[cluster % REST],
            }
        )
    return {
        "data": {"values": told},
        "mark": {"type": "text", "align": "left", "dx": 10},
        "encoding": {
            "x": {"value": "width"},
            "text": {"field": "title", "type": "nominal"},
            "color": {"field": "colour", "type": "nominal", "scale": None},
        },
    }


def _elbow(number: int, joint: Joint) -> list[dict[str, Any]]:
    """The line from the one branch up, over and down to the other."""
    group = REST if joint.cluster is None else joint.cluster % REST
    (one, other), (low, high) = joint.places, joint.heights
    corners = [(low, one), (joint.height, one), (joint.height, other), (high, other)]
    return [
        {"joint": number, "step": step, "height": height, "place": place, "group": group}
        for step, (height, place) in enumerate(corners)
    ]


def _apart(labels: Sequence[str]) -> list[str]:
    """The labels, those that are there twice with a number: a chart tells them by their text."""
    seen: dict[str, int] = {}
    found = []
    for label in labels:
        seen[label] = seen.get(label, 0) + 1
        found.append(label if seen[label] == 1 else f"{label} ({seen[label]})")
    return found
