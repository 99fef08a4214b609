"""How far a point is from what the examples span."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import minimize

from motion import MotionError
from motion.blending import outside_hull

SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])


@pytest.mark.parametrize(
    ("point", "distance"),
    [((0.5, 0.5), 0.0), ((1.0, 0.5), 0.0), ((1.5, 0.5), 0.5), ((2.0, 2.0), np.sqrt(2.0))],
)
def test_the_distance_from_a_square_is_known(point, distance):
    assert outside_hull(SQUARE, np.array(point)) == pytest.approx(distance, abs=1e-9)


def test_mixtures_of_the_examples_are_inside():
    generator = np.random.default_rng(1)
    examples = generator.uniform(size=(27, 4))
    for shares in generator.dirichlet(np.ones(27), 50):
        assert outside_hull(examples, shares @ examples) == 0.0


@pytest.mark.parametrize("count", [1, 2, 3])
def test_a_set_without_an_inside_has_distances_too(count):
    examples = np.zeros((count, 3))
    examples[:, 0] = np.arange(count)
    assert outside_hull(examples, examples[-1]) == 0.0
    assert outside_hull(examples, np.array([0.0, 3.0, 4.0])) == pytest.approx(5.0)


@given(st.integers(0, 2**32 - 1))
def test_it_is_the_least_distance_of_any_mixture(seed):
    generator = np.random.default_rng(seed)
    examples, point = generator.uniform(size=(6, 3)), generator.uniform(-0.5, 1.5, 3)
    found = minimize(
        lambda shares: np.sum((shares @ examples - point) ** 2),
        np.full(6, 1 / 6),
        bounds=[(0, 1)] * 6,
        constraints={"type": "eq", "fun": lambda shares: shares.sum() - 1},
        options={"ftol": 1e-14, "maxiter": 300},
    )
    assert outside_hull(examples, point) == pytest.approx(np.sqrt(max(found.fun, 0)), abs=1e-4)


def test_a_point_of_another_space_is_refused():
    with pytest.raises(MotionError, match="do not agree"):
        outside_hull(SQUARE, np.zeros(3))
