"""Charts of clips on one bipolar axis: shares of the answers, and means with their intervals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from app.figures import theme
from app.figures.theme import Mode, Palette

SCHEMA = "https://vega.github.io/schema/vega-lite/v6.json"
ROW = 24
LABEL_FROM = 0.1  # narrower parts of a bar have no room for their number
Width = int | Literal["container"]


@dataclass(frozen=True)
class ClipOnAxis:
    """A clip's mean with its interval, and the share (0 ... 1) of answers at each step."""

    label: str
    mean: float
    low: float
    high: float
    shares: Sequence[float]


@dataclass(frozen=True)
class AxisWords:
    """What the axis is called, left pole first, and the words over its steps."""

    left: str
    right: str
    steps: Sequence[str]

    @property
    def reach(self) -> int:
        """The value of the outermost step."""
        return len(self.steps) // 2

    @property
    def answers(self) -> list[str]:
        """Each step with its pole, as a legend names it: very sad ... very happy."""
        half = self.reach
        left = [f"{step} {self.left}" for step in self.steps[:half]]
        right = [f"{step} {self.right}" for step in self.steps[half + 1 :]]
        return [*left, self.steps[half], *right]


def shares(
    clips: Sequence[ClipOnAxis], words: AxisWords, mode: Mode, width: Width = "container"
) -> dict[str, Any]:
    """Diverging stacked bars, the middle step's centre on zero, the leftmost clip on top."""
    colours = theme.palette(mode)
    fills, on_fills = theme.step_colours(colours, len(words.steps))
    ordered = sorted(clips, key=lambda clip: clip.mean)
    bars = {
        "mark": {"type": "bar", "height": ROW - 6},
        "encoding": {
            "x": _position(
                "from", (-1.0, 1.0), "replace(format(abs(datum.value), '.0%'), '%', ' %')"
            ),
            "x2": {"field": "to"},
            "color": {
                "field": "answer",
                "type": "nominal",
                "scale": {"domain": words.answers, "range": fills},
            },
        },
    }
    numbers = {
        "transform": [{"filter": f"datum.share >= {LABEL_FROM} && !datum.between"}],
        "mark": {"type": "text"},
        "encoding": {
            "x": {"field": "middle", "type": "quantitative"},
            "text": {"field": "percent", "type": "nominal"},
            "color": {
                "field": "answer",
                "type": "nominal",
                "scale": {"domain": words.answers, "range": on_fills},
                "legend": None,
            },
        },
    }
    means = {
        "transform": [{"filter": "datum.first"}],
        "mark": {"type": "text", "align": "right", "color": colours.ink_2, "fontSize": 13},
        "encoding": {"x": {"datum": 1.22}, "text": {"field": "told", "type": "nominal"}},
    }
    spec = _chart(ordered, mode, width, [bars, _zero_line(colours), numbers, means])
    spec["data"] = {"values": [part for clip in ordered for part in _parts(clip, words)]}
    spec["resolve"] = {"scale": {"color": "independent"}}
    spec["description"] = (
        f"Shares of the answers from {words.left} to {words.right} for {len(clips)} clips, "
        f"centred on the middle step, with each clip's mean."
    )
    return spec


def intervals(
    clips: Sequence[ClipOnAxis], words: AxisWords, mode: Mode, width: Width = "container"
) -> dict[str, Any]:
    """Means as dots on their 95 % intervals, coloured by the side on which the interval lies."""
    colours = theme.palette(mode)
    ordered = sorted(clips, key=lambda clip: clip.mean)
    side = {
        "field": "side",
        "type": "nominal",
        "scale": {"domain": list(colours.poles), "range": list(colours.poles.values())},
        "legend": None,
    }
    reach = float(words.reach)
    edges = (
        f"datum.value === {-reach:g} ? '{words.reach} ' + '{_quoted(words.left)}' : "
        f"datum.value === {reach:g} ? '{words.reach} ' + '{_quoted(words.right)}' : "
        "format(abs(datum.value), '~g')"
    )
    position = _position("low", (-reach, reach), edges)
    position["axis"] |= {"values": list(range(-words.reach, words.reach + 1))}
    bars = {
        "mark": {"type": "rule", "strokeWidth": 2.5, "clip": True},
        "encoding": {"x": position, "x2": {"field": "high"}, "color": side},
    }
    dots = {
        "mark": {"type": "point", "filled": True, "size": 70, "opacity": 1},
        "encoding": {"x": {"field": "mean", "type": "quantitative"}, "color": side},
    }
    spec = _chart(ordered, mode, width, [_zero_line(colours), bars, dots])
    spec["encoding"]["y"]["axis"] = {"grid": True}
    spec["data"] = {"values": [_interval(clip) for clip in ordered]}
    spec["description"] = (
        f"Means of {len(clips)} clips from {words.left} ({-words.reach}) to {words.right} "
        f"({words.reach}) with t-based 95 % intervals."
    )
    return spec


def _chart(
    ordered: Sequence[ClipOnAxis], mode: Mode, width: Width, layers: list[dict[str, Any]]
) -> dict[str, Any]:
    return {
        "$schema": SCHEMA,
        "config": theme.config(mode),
        "width": width,
        "height": ROW * len(ordered),
        "autosize": {"type": "fit-x", "contains": "padding"},
        "encoding": {
            "y": {
                "field": "clip",
                "type": "nominal",
                "sort": [clip.label for clip in ordered],
                "title": None,
            }
        },
        "layer": layers,
    }


def _position(field: str, domain: tuple[float, float], label: str) -> dict[str, Any]:
    return {
        "field": field,
        "type": "quantitative",
        "title": None,
        "scale": {"domain": list(domain), "nice": False},
        "axis": {"labelExpr": label, "tickCount": 5},
    }


def _zero_line(colours: Palette) -> dict[str, Any]:
    """Drawn once over the whole height: it has no row of its own."""
    return {
        "data": {"values": [{}]},
        "mark": {"type": "rule", "color": colours.ink, "strokeWidth": 1.5},
        "encoding": {"x": {"datum": 0, "type": "quantitative"}, "y": None},
    }


def _parts(clip: ClipOnAxis, words: AxisWords) -> list[dict[str, Any]]:
    """The parts of one bar; zero lies in the middle of the middle step."""
    half = words.reach
    start = -sum(clip.shares[:half]) - clip.shares[half] / 2
    parts = []
    for index, (answer, share) in enumerate(zip(words.answers, clip.shares, strict=True)):
        parts.append(
            {
                "clip": clip.label,
                "answer": answer,
                "share": share,
                "percent": f"{100 * share:.0f}",
                "from": start,
                "to": start + share,
                "middle": start + share / 2,
                "first": index == 0,
                "between": index == half,  # the zero line runs through its number
                "told": _signed(clip.mean),
            }
        )
        start += share
    return parts


def _interval(clip: ClipOnAxis) -> dict[str, Any]:
    side = "left" if clip.high < 0 else "right" if clip.low > 0 else "neither"
    return {
        "clip": clip.label,
        "mean": clip.mean,
        "low": clip.low,
        "high": clip.high,
        "side": side,
    }


def _quoted(word: str) -> str:
    return word.replace("\\", "\\\\").replace("'", "\\'")


def _signed(number: float) -> str:
    """Two decimals with a sign; zero has none."""
    return f"{number:+z.2f}".replace("-", "\u2212").replace("+0.00", "0.00")
