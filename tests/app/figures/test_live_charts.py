import pytest

from app.figures import live
from app.figures.render import svg

GROUPS = [live.GroupBar("Alone", (12, 3, 1, 0)), live.GroupBar("Both", (0, 0, 0, 2))]
BINS = [live.Bin(60, 90, 3, False), live.Bin(90, 120, 2, True)]
CHARTS = {
    "standing": lambda mode: live.standing(GROUPS, mode, 500),
    "dropout": lambda mode: live.dropout([(0, 10), (1, 9), (2, 9)], 10, [(1, "walks")], mode, 500),
    "durations": lambda mode: live.durations(BINS, 80, mode, 500),
    "clips": lambda mode: live.clips([live.ClipBar("a", 3, 1), live.ClipBar("b", 2, 0)], mode, 500),
}


@pytest.mark.parametrize("mode", ["light", "dark"])
@pytest.mark.parametrize("name", CHARTS)
def test_every_chart_can_be_drawn(name, mode):
    drawn = svg(CHARTS[name](mode))
    assert "<path" in drawn
    assert "NaN" not in drawn


def test_the_parts_of_a_groups_bar_join_and_are_as_long_as_their_number():
    values = live.standing(GROUPS, "light")["data"]["values"]
    alone = [part for part in values if part["group"] == "Alone"]
    assert [part["to"] - part["from"] for part in alone] == [12, 3, 1, 0]
    assert [part["from"] for part in alone] == [0, 12, 15, 16]


def test_minutes_stand_under_the_bins_and_the_last_one_is_open():
    drawn = svg(CHARTS["durations"]("light"))
    assert "1:30" in drawn
    assert "2 or more" in drawn


def test_the_rarest_clip_stands_first_and_very_many_have_no_names():
    few = live.clips([live.ClipBar("a", 3, 1), live.ClipBar("b", 2, 0)], "light")
    assert few["layer"][0]["encoding"]["y"]["sort"] == ["b", "a"]
    many = live.clips([live.ClipBar(str(n), n, 0) for n in range(100)], "light")
    assert many["layer"][0]["encoding"]["x"]["field"] == "place"


def test_a_part_is_named_where_it_begins():
    assert "walks" in svg(CHARTS["dropout"]("light"))
