"""Charts of clips on one axis: shares of the answers, and means with their intervals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from app.figures import theme
from app.figures.theme import Mode, Palette

SCHEMA = "https://vega.github.io/schema/vega-lite/v6.json"
ROW = 24
MANY_STEPS = 11  # a longer axis has no number at every step
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
class Option:
    """How often a clip was chosen of the times that it was shown, with the interval, in 0 ... 1."""

    label: str
    share: float
    low: float
    high: float


@dataclass(frozen=True)
class AxisWords:
    """What the axis is called, left pole first, and the words over its steps.

    Attributes:
        lowest, highest: its ends as numbers.
        bipolar: whether zero is the middle, neither the one nor the other.
    """

    left: str
    right: str
    steps: Sequence[str]
    lowest: float
    highest: float
    bipolar: bool = True

    @property
    def answers(self) -> list[str]:
        """Each step with its pole, as a legend names it: very sad ... very happy."""
        if not self.bipolar:
            alike = len(set(self.steps)) < len(self.steps)
            numbered = enumerate(self.steps, round(self.lowest))
            return [f"{value} {word}" if alike else word for value, word in numbered]
        half = len(self.steps) // 2
        left = [f"{step} {self.left}" for step in self.steps[:half]]
        right = [f"{step} {self.right}" for step in self.steps[half + 1 :]]
        return [*left, self.steps[half], *right]


def shares(
    clips: Sequence[ClipOnAxis], words: AxisWords, mode: Mode, width: Width = "container"
) -> dict[str, Any]:
    """Stacked bars, the leftmost clip on top; on a bipolar axis the middle's centre is on zero."""
    colours = theme.palette(mode)
    fills, on_fills = theme.step_colours(colours, len(words.steps), bipolar=words.bipolar)
    ordered = sorted(clips, key=lambda clip: clip.mean)
    start = -1.0 if words.bipolar else 0.0
    bars = {
        "mark": {"type": "bar", "height": ROW - 6},
        "encoding": {
            "x": _position(
                "from", (start, 1.0), "replace(format(abs(datum.value), '.0%'), '%', ' %')"
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
        "encoding": {
            "x": {"datum": 1 + 0.11 * (1 - start)},
            "text": {"field": "told", "type": "nominal"},
        },
    }
    spec = _chart(ordered, mode, width, [bars, _zero_line(colours), numbers, means])
    spec["data"] = {"values": [part for clip in ordered for part in _parts(clip, words)]}
    spec["resolve"] = {"scale": {"color": "independent"}}
    centred = ", centred on the middle step" if words.bipolar else ""
    spec["description"] = (
        f"Shares of the answers from {words.left} to {words.right} for {len(clips)} clips"
        f"{centred}, with each clip's mean."
    )
    return spec


def intervals(
    clips: Sequence[ClipOnAxis], words: AxisWords, mode: Mode, width: Width = "container"
) -> dict[str, Any]:
    """Means as dots on their 95 % intervals.

    On a bipolar axis coloured by the side on which the interval lies.
    """
    colours = theme.palette(mode)
    ordered = sorted(clips, key=lambda clip: clip.mean)
    sides = colours.poles if words.bipolar else {"neither": colours.steps[0]}
    side = {
        "field": "side",
        "type": "nominal",
        "scale": {"domain": list(sides), "range": list(sides.values())},
        "legend": None,
    }
    position = _position("low", (words.lowest, words.highest), _end_words(words))
    if words.highest - words.lowest <= MANY_STEPS:
        position["axis"] |= {"values": list(range(round(words.lowest), round(words.highest) + 1))}
    bars = {
        "mark": {"type": "rule", "strokeWidth": 2.5, "clip": True},
        "encoding": {"x": position, "x2": {"field": "high"}, "color": side},
    }
    dots = {
        "mark": {"type": "point", "filled": True, "size": 70, "opacity": 1},
        "encoding": {"x": {"field": "mean", "type": "quantitative"}, "color": side},
    }
    line = [_zero_line(colours)] if words.bipolar else []
    spec = _chart(ordered, mode, width, [*line, bars, dots])
    spec["encoding"]["y"]["axis"] = {"grid": True}
    spec["data"] = {"values": [_interval(clip, words) for clip in ordered]}
    spec["description"] = (
        f"Means of {len(clips)} clips from {words.left} ({words.lowest:g}) to {words.right} "
        f"({words.highest:g}) with t-based 95 % intervals."
    )
    return spec


def _end_words(words: AxisWords) -> str:
    """The axis's labels: numbers, at its ends with the words."""
    numbers = "abs(datum.value)" if words.bipolar else "datum.value"
    return (
        f"datum.value === {words.lowest:g} ? '{abs(words.lowest):g} ' + '{_quoted(words.left)}' : "
        f"datum.value === {words.highest:g} ? '{words.highest:g} ' + '{_quoted(words.right)}' : "
        f"format({numbers}, '~g')"
    )


def chosen(
    options: Sequence[Option], chance: float | None, mode: Mode, width: Width = "container"
) -> dict[str, Any]:
    """How often each was chosen: bars with Wilson's 95 % intervals, and a line at mere chance."""
    colours = theme.palette(mode)
    position = _position("share", (0.0, 1.0), "replace(format(datum.value, '.0%'), '%', ' %')")
    bars = {
        "mark": {"type": "bar", "height": ROW - 10, "color": colours.steps[1]},
        "encoding": {"x": position},
    }
    reaches = {
        "mark": {"type": "rule", "strokeWidth": 2, "color": colours.ink},
        "encoding": {
            "x": {"field": "low", "type": "quantitative"},
            "x2": {"field": "high"},
        },
    }
    guess = {
        "data": {"values": [{}]},
        "mark": {"type": "rule", "color": colours.ink_2, "strokeDash": [4, 3]},
        "encoding": {"x": {"datum": chance, "type": "quantitative"}, "y": None},
    }
    layers = [bars, reaches] if chance is None else [bars, guess, reaches]
    spec = _chart(options, mode, width, layers)
    spec["data"] = {
        "values": [
            {"clip": one.label, "share": one.share, "low": one.low, "high": one.high}
            for one in options
        ]
    }
    spec["description"] = (
        f"Shares of {len(options)} choices with 95 % intervals"
        f"{'' if chance is None else '; dashed: by chance'}."
    )
    return spec


def _chart(
    ordered: Sequence[ClipOnAxis | Option], mode: Mode, width: Width, layers: list[dict[str, Any]]
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
    half = len(words.steps) // 2 if words.bipolar else None
    start = 0.0 if half is None else -sum(clip.shares[:half]) - clip.shares[half] / 2
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
                "told": _signed(clip.mean) if words.bipolar else f"{clip.mean:.2f}",
            }
        )
        start += share
    return parts


def _interval(clip: ClipOnAxis, words: AxisWords) -> dict[str, Any]:
    side = "left" if clip.high < 0 else "right" if clip.low > 0 else "neither"
    if not words.bipolar:
        side = "neither"
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
