import json

from app.figures import render
from app.figures.recovery import Axis, Curve, recovery

NAN = float("nan")


def places(spec):
    return [row for panel in spec["concat"] for row in panel["data"]["values"]]


def test_what_is_undefined_is_left_out():
    curve = Curve("found", "Set A", [1, 2, 3], [0.5, NAN, 0.25], [0.4, NAN, 0.2], [0.6, NAN, 0.3])
    spec = recovery([(Axis("noise", 2), [curve])], "light")
    assert places(spec) == [
        {"name": "found", "x": 1, "y": 0.5, "low": 0.4, "high": 0.6},
        {"name": "found", "x": 3, "y": 0.25, "low": 0.2, "high": 0.3},
    ]
    assert "NaN" not in json.dumps(spec)


def test_rows_of_curves_stand_below_each_other_and_axes_beside_each_other():
    curves = [Curve(name, row, [1, 2], [0, 1]) for row in ("A", "B") for name in ("one", "two")]
    spec = recovery([(Axis("noise", 1), curves), (Axis("raters", 2, True), curves)], "light")
    assert spec["columns"] == 2
    assert [panel["title"] for panel in spec["concat"]] == ["A", "A", "B", "B"]
    titles = [panel["encoding"]["x"]["title"] for panel in spec["concat"]]
    assert titles == ["noise", "raters"] * 2
    picture = render.svg(spec)
    assert all(f">{word}<" in picture for word in ("one", "two", "noise", "raters"))
