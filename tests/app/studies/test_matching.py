"""The matching template's targets, in the space of walks that a fresh server has."""

from __future__ import annotations

import pytest

from app.schemas.spaces import START, Point
from app.studies import matching
from motion.blending.distance import matching_distance
from tests.support.slider_effects import space


@pytest.mark.parametrize("interface", ["adjectives", "features", "weights"])
def test_no_target_is_matched_before_anybody_moves_a_slider(interface):
    walks = space("set_b")
    sliders = walks.definition.sliders(interface)
    names = (
        [one.id for one in sliders.primary]
        if sliders
        else [one.clip for one in walks.definition.examples]
    )
    start = Point(interface=interface, values=dict.fromkeys(names, START))
    first = walks.clip(walks.weights(start).weights)
    for place in (*matching.TARGETS, *matching.PRACTICE):
        values = dict(zip(matching.PRIMARY, place, strict=True))
        target = walks.weights(Point(interface="adjectives", values=values))
        assert matching_distance(walks.clip(target.weights), first) > matching.THRESHOLD
