"""Charts of one-way scales and of choices."""

import xml.etree.ElementTree as ET

import pytest

from app.figures import theme
from app.figures.clips import AxisWords, ClipOnAxis, Option, chosen, intervals, shares
from app.figures.render import svg

STEPS = ("not at all", "a little", "fairly", "very")
WORDS = AxisWords("not at all", "very", STEPS, 0, 3, bipolar=False)
CLIPS = [
    ClipOnAxis("happy", 2.1, 1.8, 2.4, [0.0, 0.2, 0.5, 0.3]),
    ClipOnAxis("sad", 0.7, 0.4, 1.0, [0.5, 0.3, 0.2, 0.0]),
]
OPTIONS = [Option("happy", 0.6, 0.45, 0.73), Option("none of them", 0.1, 0.04, 0.23)]


def test_the_bars_of_a_one_way_scale_begin_at_nothing_and_end_at_all():
    for clip in CLIPS:
        parts = [p for p in shares(CLIPS, WORDS, "light")["data"]["values"]
                 if p["clip"] == clip.label]  # fmt: skip
        assert parts[0]["from"] == 0
        assert parts[-1]["to"] == pytest.approx(1)
        assert [p["to"] - p["from"] for p in parts] == pytest.approx(clip.shares)
        assert {p["told"] for p in parts} == {f"{clip.mean:.2f}"}


@pytest.mark.parametrize("steps", [2, 3, 4, 5, 7, 11])
@pytest.mark.parametrize("mode", ["light", "dark"])
def test_each_step_of_a_one_way_scale_has_a_colour_of_its_own(mode, steps):
    fills, on_fills = theme.step_colours(theme.palette(mode), steps, bipolar=False)
    assert len(set(fills)) == len(fills) == len(on_fills) == steps
    assert (fills[0].lower(), fills[-1].lower()) == (
        theme.palette(mode).steps[2].lower(), theme.palette(mode).steps[-1].lower(),
    )  # fmt: skip


def test_steps_with_the_same_word_are_told_apart_by_their_numbers():
    words = AxisWords("no", "yes", ("no", "perhaps", "perhaps", "yes"), 1, 4, bipolar=False)
    assert words.answers == ["1 no", "2 perhaps", "3 perhaps", "4 yes"]
    assert WORDS.answers == list(STEPS)


def test_a_one_way_axis_has_its_words_at_its_ends_and_no_line_in_the_middle():
    spec = intervals(CLIPS, WORDS, "light", 500)
    words = set(ET.fromstring(svg(spec)).itertext())
    assert {"0 not at all", "3 very", "1", "2"} <= words
    assert {row["side"] for row in spec["data"]["values"]} == {"neither"}
    assert len(spec["layer"]) == 2


def test_a_sliders_axis_is_not_crowded_with_numbers():
    words = AxisWords("bad", "good", (), 0, 100, bipolar=False)
    clips = [ClipOnAxis("one", 50.0, 40.0, 60.0, ())]
    told = list(ET.fromstring(svg(intervals(clips, words, "light", 500))).itertext())
    assert {"0 bad", "100 good"} <= set(told)
    assert sum(text.strip().isdigit() for text in told) < 10


@pytest.mark.parametrize("chance", [None, 0.5])
def test_choices_are_bars_with_intervals_and_a_line_at_chance(chance):
    spec = chosen(OPTIONS, chance, "light", 500)
    by_clip = {row["clip"]: (row["share"], row["low"], row["high"])
               for row in spec["data"]["values"]}  # fmt: skip
    assert by_clip == {one.label: (one.share, one.low, one.high) for one in OPTIONS}
    assert ("dashed: by chance" in spec["description"]) == (chance is not None)
    drawn = svg(spec)
    assert ("stroke-dasharray" in drawn) == (chance is not None)
    assert {"happy", "none of them", "100 %"} <= set(ET.fromstring(drawn).itertext())
