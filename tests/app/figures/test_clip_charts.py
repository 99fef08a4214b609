import json
import xml.etree.ElementTree as ET
from itertools import pairwise

import pytest

from app.figures import theme
from app.figures.clips import AxisWords, ClipOnAxis, intervals, shares
from app.figures.render import svg

WORDS = AxisWords("sad", "happy", ("very", "rather", "neither", "rather", "very"), -2, 2)
CLIPS = [
    ClipOnAxis("happy, male", 1.25, 0.8, 1.7, [0.0, 0.0, 0.25, 0.25, 0.5]),
    ClipOnAxis("sad, female", -1.5, -1.9, -1.1, [0.5, 0.5, 0.0, 0.0, 0.0]),
    ClipOnAxis("neutral, male", 0.0, -0.4, 0.4, [0.0, 0.25, 0.5, 0.25, 0.0]),
]
TOKENS = json.loads(theme.TOKENS.read_text())


def parts(clip):
    return [
        part for part in shares(CLIPS, WORDS, "light")["data"]["values"] if part["clip"] == clip
    ]


def test_the_middle_of_the_middle_step_lies_on_zero():
    for clip in CLIPS:
        middle = parts(clip.label)[2]
        assert middle["from"] == pytest.approx(-middle["to"])


def test_the_parts_of_a_bar_join_and_are_as_long_as_their_share():
    for clip in CLIPS:
        bar = parts(clip.label)
        assert [part["to"] - part["from"] for part in bar] == pytest.approx(clip.shares)
        for left, right in pairwise(bar):
            assert left["to"] == pytest.approx(right["from"])
        assert bar[-1]["to"] - bar[0]["from"] == pytest.approx(1)


@pytest.mark.parametrize("chart", [shares, intervals])
def test_clips_stand_in_the_order_of_their_means_the_left_pole_on_top(chart):
    order = chart(CLIPS, WORDS, "light")["encoding"]["y"]["sort"]
    assert order == ["sad, female", "neutral, male", "happy, male"]


def test_an_interval_is_coloured_by_the_side_it_lies_on_and_grey_across_the_middle():
    spec = intervals(CLIPS, WORDS, "light")
    sides = {row["clip"]: row["side"] for row in spec["data"]["values"]}
    assert sides == {"sad, female": "left", "neutral, male": "neither", "happy, male": "right"}
    by_hand = {(row["low"], row["mean"], row["high"]) for row in spec["data"]["values"]}
    assert by_hand == {(clip.low, clip.mean, clip.high) for clip in CLIPS}


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_the_colours_are_the_tokens(mode):
    drawn = svg(shares(CLIPS, WORDS, mode, 500)).lower()
    for colour in TOKENS["data"]["bipolar"][mode]:
        assert colour.lower() in drawn
    other = "dark" if mode == "light" else "light"
    assert TOKENS["colour"][other]["ink"].lower() not in drawn


@pytest.mark.parametrize("mode", ["light", "dark"])
@pytest.mark.parametrize("chart", [shares, intervals])
def test_a_chart_is_drawn_with_its_words_and_says_what_it_is(chart, mode):
    drawing = ET.fromstring(svg(chart(CLIPS, WORDS, mode, 500)))
    words = list(drawing.itertext())
    assert {clip.label for clip in CLIPS} <= set(words)
    assert "sad" in chart(CLIPS, WORDS, mode)["description"]
    assert float(drawing.get("width")) == pytest.approx(500, abs=2)


def test_shares_are_written_on_their_bars_and_means_beside():
    words = set(ET.fromstring(svg(shares(CLIPS, WORDS, "light", 500))).itertext())
    assert {"very sad", "rather sad", "neither", "rather happy", "very happy"} <= words
    assert {"−1.50", "0.00", "+1.25", "50", "25"} <= words


def test_a_pole_with_an_apostrophe_does_not_break_the_axis():
    words = AxisWords("can't tell", "o'clock", WORDS.steps, -2, 2)
    drawn = set(ET.fromstring(svg(intervals(CLIPS, words, "light", 500))).itertext())
    assert {"2 can't tell", "2 o'clock"} <= drawn


def test_with_seven_steps_the_ends_and_the_middle_keep_their_colours():
    colours = theme.palette("light")
    fills, on_fills = theme.step_colours(colours, 7)
    assert (fills[0], fills[3], fills[6]) == (
        colours.steps[0], colours.steps[2], colours.steps[4],
    )  # fmt: skip
    assert len(fills) == len(on_fills) == 7


def test_a_specification_is_plain_data():
    for chart in (shares, intervals):
        spec = chart(CLIPS, WORDS, "dark")
        assert json.loads(json.dumps(spec)) == spec
