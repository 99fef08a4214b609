"""How every chart looks: the design tokens as a Vega-Lite configuration, light and dark."""

from __future__ import annotations

import json
from functools import cache
from typing import Any, Literal, NamedTuple

from app.settings import PROJECT

Mode = Literal["light", "dark"]
TOKENS = PROJECT / "static" / "src" / "tokens.json"


class Palette(NamedTuple):
    """A mode's colours. `steps` go from the left pole to the right one, `on_steps` lie on them."""

    ink: str
    ink_2: str
    ink_3: str
    line: str
    line_strong: str
    steps: tuple[str, ...]
    on_steps: tuple[str, ...]

    @property
    def poles(self) -> dict[str, str]:
        """Colours of a clip that lies clearly left, clearly right, or on neither side."""
        return {"left": self.steps[0], "neither": self.line_strong, "right": self.steps[-1]}


@cache
def tokens() -> dict[str, Any]:
    """The design tokens that the front end uses too."""
    read: dict[str, Any] = json.loads(TOKENS.read_text())
    return read


def palette(mode: Mode) -> Palette:
    """The colours of charts in this mode."""
    colour, bipolar = tokens()["colour"][mode], tokens()["data"]["bipolar"]
    return Palette(
        ink=colour["ink"],
        ink_2=colour["ink2"],
        ink_3=colour["ink3"],
        line=colour["line"],
        line_strong=colour["lineStrong"],
        steps=tuple(bipolar[mode]),
        on_steps=tuple(bipolar[f"{mode}Text"]),
    )


def config(mode: Mode) -> dict[str, Any]:
    """Charts without frames, hair lines, numbers and words in the sans of the pages."""
    colours = palette(mode)
    sans = tokens()["type"]["families"]["sans"]
    return {
        "background": "transparent",
        "font": sans,
        "padding": 2,
        "view": {"stroke": None},
        "axis": {
            "domain": False,
            "ticks": False,
            "gridColor": colours.line,
            "gridWidth": 1,
            "labelColor": colours.ink_2,
            "labelFontSize": 13,
            "labelPadding": 8,
            "titleColor": colours.ink_2,
            "titleFontSize": 13,
            "titleFontWeight": 400,
        },
        "axisY": {"labelColor": colours.ink, "labelLimit": 220},
        "legend": {
            "labelColor": colours.ink,
            "labelFontSize": 13,
            "symbolType": "square",
            "symbolSize": 110,
            "symbolStrokeWidth": 0,
            "orient": "bottom",
            "direction": "horizontal",
            "title": None,
            "offset": 12,
            "columns": 3,
            "columnPadding": 16,
        },
        "text": {"font": sans, "fontSize": 12, "color": colours.ink},
    }


def step_colours(
    colours: Palette, steps: int, *, bipolar: bool = True
) -> tuple[list[str], list[str]]:
    """Fill and text colour of each step; the tokens have five, more steps share by nearness.

    Where the axis has one direction only, the colours go from the middle's to the right pole's.
    """
    last = len(colours.steps) - 1
    first = 0 if bipolar else last // 2
    places = [first + index * (last - first) / (steps - 1) for index in range(steps)]
    nearest = [round(place) for place in places]
    fills = [colours.steps[i] for i in nearest]
    if not bipolar:  # three colours for many steps: those between are mixed
        fills = [_mixed(colours.steps, place) for place in places]
    return fills, [colours.on_steps[i] for i in nearest]


def _mixed(colours: tuple[str, ...], place: float) -> str:
    """The colour between two neighbours of a row of #rrggbb, by its place in the row."""
    low = min(int(place), len(colours) - 2)
    one, other = (bytes.fromhex(colours[i].removeprefix("#")) for i in (low, low + 1))
    mixed = (a + (b - a) * (place - low) for a, b in zip(one, other, strict=True))
    return "#" + "".join(f"{round(part):02x}" for part in mixed)
