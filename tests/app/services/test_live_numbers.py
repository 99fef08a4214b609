from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.persistence.live import Active, Seen, Total
from app.services import live_numbers
from app.services.live_numbers import quantile
from app.services.summaries import counted, encode

TIMES = st.lists(st.integers(0, 200_000), min_size=1, max_size=60)


def histogram(values):
    known, times = np.unique(values, return_counts=True)
    return list(zip(known.tolist(), times.tolist(), strict=True))


@given(TIMES, st.floats(0, 1))
def test_a_quantile_of_counted_values_is_numpys_of_the_values(values, share):
    assert quantile(histogram(values), share) == pytest.approx(np.quantile(values, share))


@given(TIMES)
def test_every_time_stands_in_one_bin_and_bins_follow_each_other(values):
    bins = live_numbers.durations(histogram(values)).bins
    assert sum(one.count for one in bins) == len(values)
    assert 1 <= len(bins) <= live_numbers.MOST_BINS + 1
    for left, right in pairwise(bins):
        assert left.end == right.start
    for one in bins:
        end = np.inf if one.end is None else one.end
        assert one.count == sum(one.start <= value < end for value in values)


@given(st.lists(st.integers(0, 65_535), max_size=200))
def test_places_are_counted_back_from_what_is_joined(places):
    expected = {place: places.count(place) for place in places}
    assert counted(encode(places)) == expected


def test_the_curve_falls_by_who_left_and_nobody_under_way_is_in_it():
    active = [
        Active(None, False, 0, 1), Active(None, False, 3, 4), Active(None, True, 1, 7)
    ]  # fmt: skip
    found = live_numbers.dropout(5, active, [Seen(1, True, "", 25, 5)])
    assert found.of == 10
    assert [step.still for step in found.steps] == [10, 9, 9, 9, 5, 5]
    assert [step.left for step in found.steps] == [1, 0, 0, 4, 0, 0]
    assert found.sentence == "5 of 10 left early; most of them, 4, at step 4."


def test_nobody_yet_is_said_and_not_drawn():
    found = live_numbers.dropout(0, [Active(None, True, 1, 3)], [Seen(1, False, "", 3, 5)])
    assert found.steps == []
    assert found.sentence == "Nobody has come to an end yet."
    assert live_numbers.durations([]).bins == []


def test_every_group_has_a_row_and_the_rows_add_up():
    totals = [
        Total("complete", "a", 4), Total("active", "a", 3), Total("screened_out", "b", 2),
        Total("failed_attention", "b", 1), Total("withdrawn", None, 5),
    ]  # fmt: skip
    active = [Active("a", True, 2, 1), Active("a", False, 2, 2)]
    rows = live_numbers.by_group(totals, active, {"a": "Alone", "b": "Both", "c": "Not yet"})
    told = [
        (r.label, r.complete, r.under_way, r.left_early, r.ended_early) for r in rows
    ]  # fmt: skip
    assert told == [("Alone", 4, 1, 2, 0), ("Both", 0, 0, 0, 3), ("Not yet", 0, 0, 0, 0)]
    counts = live_numbers.counts(totals, active, [Seen(1, True, "", 40, 10)], 6)
    assert (counts.complete, counts.under_way, counts.left_early) == (4, 1, 2)
    assert (counts.ended_early, counts.withdrawn, counts.excluded) == (3, 5, 6)
    assert counts.answers == 40


def test_clips_are_counted_by_their_version_and_told_with_their_range():
    seen = [
        Seen(1, True, encode([0, 1, 1]), 3, 3), Seen(2, False, encode([0]), 1, 3)
    ]  # fmt: skip
    places = {1: ["x", "y"], 2: ["y", "z"]}
    clips = live_numbers.clip_counts(seen, places, {"x": "X", "y": "Y", "z": "Z"})
    assert [(c.label, c.complete, c.others) for c in clips] == [
        ("X", 1, 0), ("Y", 2, 1), ("Z", 0, 0),
    ]  # fmt: skip
    assert live_numbers.clips_sentence(clips) == "Each of 3 clips was judged 0 to 3 times."
    assert live_numbers.clips_sentence(clips[:1]) == "The clip was judged once."


@pytest.mark.parametrize(
    ("seconds", "expected"),
    [(59, "59 s"), (61, "1 min 1 s"), (2400, "40 min"), (7260, "2 h 1 min"), (400_000, "4 days")],
)
def test_lengths_of_time_are_said_as_one_says_them(seconds, expected):
    assert live_numbers.spoken(seconds) == expected
