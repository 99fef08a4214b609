"""Designs over participants: balanced, uniform, and the same on every platform."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise
from math import gcd

import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import chisquare

from app.services.designs import Draws, subset, williams, williams_rows


@pytest.mark.parametrize("number", [2, 3, 4, 5, 8, 9, 40])
def test_a_latin_square_has_each_clip_equally_often_in_each_place_and_after_each_other(
    number: int,
) -> None:
    rows = [williams(number, row) for row in range(williams_rows(number))]
    times = len(rows) // number
    places = Counter((place, clip) for row in rows for place, clip in enumerate(row))
    assert set(places.values()) == {times}
    assert len(places) == number**2
    follows = Counter(pair for row in rows for pair in pairwise(row))
    assert set(follows.values()) == {times}
    assert len(follows) == number * (number - 1)


@given(number=st.integers(1, 30), row=st.integers(0, 1000))
def test_every_row_is_an_order_of_all_and_rows_come_round(number: int, row: int) -> None:
    order = williams(number, row)
    assert sorted(order) == list(range(number))
    assert williams(number, row + williams_rows(number)) == order


@given(number=st.integers(1, 40), share=st.floats(0.01, 1), rounds=st.integers(1, 3))
def test_subsets_show_every_clip_equally_often_after_each_round(
    number: int, share: float, rounds: int
) -> None:
    size = max(1, round(share * number))
    rows = rounds * number // gcd(number, size)
    shown = [subset(number, size, row, "a study", "clips") for row in range(rows)]
    assert all(len(set(one)) == size for one in shown)
    counts = Counter(clip for one in shown for clip in one)
    assert set(counts.values()) == {rows * size // number}
    assert len(counts) == number


@given(number=st.integers(2, 40), share=st.floats(0.01, 1), rows=st.integers(1, 100))
def test_at_any_moment_clips_differ_by_at_most_one_showing(
    number: int, share: float, rows: int
) -> None:
    size = max(1, round(share * number))
    counts = Counter(range(number))
    counts.update(clip for row in range(rows) for clip in subset(number, size, row, "s"))
    assert max(counts.values()) - min(counts.values()) <= 1


def test_each_place_is_as_likely_for_each_clip_over_ten_thousand_shuffles() -> None:
    number, allocations = 12, 10_000
    places = [Counter[int]() for _ in range(number)]
    for seed in range(allocations):
        for place, clip in enumerate(Draws(seed).shuffle(number)):
            places[clip][place] += 1
    p_values = [chisquare([count[place] for place in range(number)]).pvalue for count in places]
    # Twelve tests at once: the smallest is below 0.001 / 12 once in a thousand times, and the
    # seeds are fixed.
    assert min(p_values) > 0.001 / number


def test_the_same_seed_gives_the_same_order_everywhere() -> None:
    # NumPy promises raw draws for good; their ranks are the order.
    assert Draws(1).shuffle(8) == [2, 4, 7, 5, 0, 6, 3, 1]
    assert Draws(2**48 - 1).shuffle(8) == [6, 0, 3, 5, 7, 1, 2, 4]
    assert Draws(1).below(1000) == 127
