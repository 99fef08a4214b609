"""Which moment of each example is shown when."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion.blending.time_warp import common_order, first_event, warped

WALK = {"left_strike": 0.0, "right_off": 0.1, "right_strike": 0.5, "left_off": 0.6}
RUN = {"left_strike": 0.0, "left_off": 0.4, "right_strike": 0.5, "right_off": 0.9}
LONGER = {"left_strike": 0.0, "right_off": 0.2, "right_strike": 0.55, "left_off": 0.7}


def test_walks_share_all_events_in_their_order():
    order = ("left_strike", "right_off", "right_strike", "left_off")
    assert common_order([WALK, LONGER]) == order
    assert first_event([WALK, LONGER]) == "left_strike"


def test_a_walk_and_a_run_share_what_comes_in_the_same_order_in_both():
    names = common_order([WALK, RUN])
    assert set(names) >= {"left_strike", "right_strike"}
    for phases in (WALK, RUN):
        moments = [phases[name] for name in names]
        assert moments == sorted(moments)
    assert names == common_order([RUN, WALK])


def test_without_common_events_there_is_no_order():
    assert common_order([{"left_strike": 0.1}, {"right_strike": 0.2}]) == ()
    assert first_event([{"left_strike": 0.1}, {}]) is None


def events(*examples, names=("left_strike", "right_off", "right_strike", "left_off")):
    return np.array([[phases[name] for name in names] for phases in examples])


def test_a_blend_keytime_shows_that_of_every_example():
    weights, table = np.array([0.25, 0.75]), events(WALK, LONGER)
    found = warped(weights @ table, table, weights, cyclic=True)
    np.testing.assert_allclose(found, table, atol=1e-12)


@given(st.floats(0, 1), st.booleans())
def test_time_runs_forward_through_each_example_once(share, cyclic):
    weights, table = np.array([share, 1 - share]), events(WALK, LONGER)
    found = warped(np.linspace(0, 1, 101), table, weights, cyclic=cyclic)
    assert (np.diff(found, axis=1) >= -1e-12).all()
    np.testing.assert_allclose(found[:, -1] - found[:, 0], 1.0, atol=1e-12)
    np.testing.assert_allclose(weights @ found, np.linspace(0, 1, 101), atol=1e-12)


def test_without_events_time_is_even():
    shares = np.linspace(0, 1, 11)
    found = warped(shares, np.zeros((3, 0)), np.full(3, 1 / 3), cyclic=True)
    np.testing.assert_allclose(found, np.tile(shares, (3, 1)), atol=1e-12)


@pytest.mark.parametrize("late", [0.004, -0.004])
def test_an_event_just_beside_the_seam_comes_round_again(late):
    table = events(WALK, LONGER)
    table[1, 0] = late
    found = warped(np.array([0.0, 1.0]), table, np.array([0.5, 0.5]), cyclic=True)
    np.testing.assert_allclose(found[:, 1] - found[:, 0], 1.0, atol=1e-12)
