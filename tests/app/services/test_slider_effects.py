"""The sliders of the sample spaces do with motion what their adjectives say."""

import numpy as np
import pytest

from tests.support import slider_effects
from tests.support.slider_effects import MEANT, MEASURES, SETS, SLIDERS, STEPS, effects, examples

MEANT_IN_SETS = [
    (motion_set, slider, name, sign)
    for motion_set in SETS
    for slider, changes in MEANT.items()
    for name, sign in changes.items()
]
SEEN = 0.4  # of the examples' standard deviation: less is no effect
NEAR = 0.1  # slider lengths from what the examples span


def test_every_primary_slider_is_meant_to_have_an_effect():
    assert set(MEANT) == set(SLIDERS)
    assert all(MEANT.values())
    assert {"arm span", "step length"} <= set(MEANT["largeness"])
    assert {"cadence", "hand speed"} <= set(MEANT["quickness"])


@pytest.mark.parametrize(("motion_set", "slider", "name", "sign"), MEANT_IN_SETS)
def test_a_slider_moved_alone_changes_what_is_meant(motion_set, slider, name, sign):
    found = effects(motion_set)
    path = sign * found.path(slider, name)
    assert path[-1] > path[0]
    assert sign * found.order(slider, name) >= 0.7
    assert path.max() - path[0] > SEEN * _spread(motion_set, name)


@pytest.mark.parametrize(("motion_set", "slider", "name", "sign"), MEANT_IN_SETS)
def test_where_examples_are_near_no_step_goes_back(motion_set, slider, name, sign):
    found = effects(motion_set)
    near = found.outside[SLIDERS.index(slider)] < NEAR
    assert near.sum() >= 3
    assert (np.diff(sign * found.path(slider, name)[near]) > 0).all()


@pytest.mark.parametrize(("motion_set", "slider", "name", "sign"), MEANT_IN_SETS)
def test_within_the_examples_a_slider_changes_what_is_meant_whatever_the_others_are(
    motion_set, slider, name, sign
):
    found = effects(motion_set)
    assert sign * found.slope(slider, name) > SEEN * _spread(motion_set, name)
    assert found.explained[list(MEASURES).index(name)] > 0.7


@pytest.mark.parametrize("motion_set", SETS)
def test_largeness_widens_and_quickness_hastens_at_every_step_to_the_very_ends(motion_set):
    found = effects(motion_set)
    for slider, name in (
        ("largeness", "arm span"),
        *(("quickness", n) for n in MEANT["quickness"]),
    ):
        assert (np.diff(found.path(slider, name)) > 0).all()


@pytest.mark.parametrize("motion_set", SETS)
def test_the_effects_do_not_hang_on_where_the_other_sliders_stand(motion_set):
    moved, _ = slider_effects.sweep(motion_set, np.median(examples(motion_set), axis=0))
    for place, slider in enumerate(SLIDERS):
        for name, sign in MEANT[slider].items():
            path = sign * moved[place, :, list(MEASURES).index(name)]
            assert np.polyfit(STEPS, path, 1)[0] > 0
            assert path[-1] > path[0]


def test_the_page_is_up_to_date():
    assert slider_effects.PAGE.read_text(encoding="utf-8") == slider_effects.page()


def _spread(motion_set, name):
    return slider_effects.measured_examples(motion_set)[:, list(MEASURES).index(name)].std()
