"""Weights of examples: their own at their own place, never a jump, an answer for every set."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from motion import MotionError
from motion.blending import WeightMap

RANDOM = np.random.default_rng(7)
STEP = 0.01  # of the nearest distance between two examples
JUMP = 0.05  # that no weight may move by in such a step


def lattice(*axes):
    return np.stack(np.meshgrid(*axes), -1).reshape(-1, len(axes)).astype(float)


def around(angle):
    return 0.5 + 0.5 * np.stack([np.cos(angle), np.sin(angle)], -1)


LINE = RANDOM.uniform(size=(27, 1)) @ np.full((1, 4), 0.5)
TEN = RANDOM.uniform(size=(10, 4))
HARD = {
    "one": TEN[:1],
    "two": TEN[:2],
    "more parameters than examples": TEN[:3],
    "as many parameters": TEN[:4],
    "one parameter": np.linspace(0, 1, 27)[:, None],
    "on a line": LINE,
    "nearly on a line": LINE + RANDOM.normal(0, 1e-3, LINE.shape),
    "nearly on a plane": np.hstack([RANDOM.uniform(size=(27, 2)), 0.5 + LINE[:, :2] / 50]),
    "one parameter hardly varies": 0.5 + (TEN - 0.5) * [1.0, 0.5, 0.1, 0.02],
    "every other one near another": np.vstack([TEN, TEN + RANDOM.normal(0, 0.003, TEN.shape)]),
    "a constant parameter": np.hstack([TEN, np.full((10, 1), 0.3)]),
    "all parameters constant": np.full((5, 3), 0.5),
    "twice the same": np.vstack([TEN, TEN]),
    "a close pair": np.vstack([TEN, TEN[:1] + 1e-6]),
    "a closer pair": np.vstack([TEN, TEN[:1] + 1e-9]),
    "clusters": np.concatenate([c + RANDOM.normal(0, 0.01, (9, 4)) for c in TEN[:3] / 2 + 0.25]),
    "a lattice": lattice(*[np.linspace(0, 1, 4)] * 3),
    "the corners": lattice(*[(0, 1)] * 4),
    "a simplex": np.eye(10),
    "a flat triangle": np.array([[0, 0], [1, 0], [0.5, 0.05]]),
    "a ring": around(np.arange(27) * 2 * np.pi / 27),
    "a ring and its middle": np.vstack([around(np.arange(8) * np.pi / 4), [[0.5, 0.5]]]),
}


@pytest.fixture(params=[*HARD, "10 × 4", "27 × 4", "27 × 10", "64 × 4"])
def examples(request) -> np.ndarray:
    if request.param in HARD:
        return HARD[request.param]
    count, parameters = (int(part) for part in request.param.split(" × "))
    return np.random.default_rng(count).uniform(size=(count, parameters))


def points_about(examples, generator, count=600):
    """Anywhere in [0, 1]ᴾ, between examples and beyond, and near to one."""
    nearest = nearest_distance(examples)
    one, two = examples[generator.integers(len(examples), size=(2, count))]
    between = one + generator.uniform(-0.3, 1.3, (count, 1)) * (two - one)
    near = one + generator.normal(0, nearest / 2, one.shape)
    anywhere = generator.uniform(size=one.shape)
    return np.clip(np.concatenate([anywhere, between, near]), 0.0, 1.0)


def nearest_distance(examples):
    distances = np.linalg.norm(examples[:, None] - examples, axis=-1)
    apart = distances[distances > 1e-10]
    return apart.min() if apart.size else 1.0


def test_an_example_has_all_the_weight_at_its_own_parameters(examples):
    same = np.linalg.norm(examples[:, None] - examples, axis=-1) <= 1e-10
    expected = same / same.sum(axis=1, keepdims=True)  # equal examples share it
    found = WeightMap.fit(examples)
    np.testing.assert_allclose(found.weights(examples), expected, rtol=0, atol=1e-9)


def test_weights_are_shares(examples):
    found = WeightMap.fit(examples).weights(points_about(examples, np.random.default_rng(2)))
    assert found.min() >= 0.0
    np.testing.assert_allclose(found.sum(axis=-1), 1.0, atol=1e-12)


def test_no_weight_jumps_when_a_slider_moves_a_little(examples):
    weights, step = WeightMap.fit(examples), STEP * nearest_distance(examples)
    points = points_about(examples, np.random.default_rng(3))
    before = weights.weights(points)
    for parameter in range(examples.shape[1]):
        moved = points.copy()
        moved[:, parameter] += step
        assert np.abs(weights.weights(moved) - before).max() <= JUMP


@given(
    arrays(float, st.tuples(st.integers(1, 12), st.integers(1, 5)), elements=st.floats(0, 1)),
    st.integers(0, 2**32 - 1),
)
@settings(max_examples=120)
def test_every_set_of_examples_has_weights(examples, seed):
    weights = WeightMap.fit(examples)
    points = points_about(examples, np.random.default_rng(seed), 20)
    found = weights.weights(points)
    assert np.isfinite(found).all()
    assert found.min() >= 0.0
    np.testing.assert_allclose(found.sum(axis=-1), 1.0, atol=1e-12)
    own = weights.weights(examples)
    same = np.linalg.norm(examples[:, None] - examples, axis=-1) <= 1e-10
    np.testing.assert_allclose(np.where(same, own, 0.0).sum(axis=1), 1.0, atol=1e-7)


def test_halfway_between_two_examples_each_has_half():
    np.testing.assert_allclose(
        WeightMap.fit(np.array([[0.2, 0.2], [0.8, 0.4]])).weights(np.array([0.5, 0.3])), 0.5
    )


def test_two_examples_are_mixed_as_their_line_says():
    """With one parameter and two examples the linear part is exact, and nothing is left of it."""
    found = WeightMap.fit(np.array([[0.0], [1.0]])).weights(np.linspace(0, 1, 5)[:, None])
    np.testing.assert_allclose(found[:, 1], np.linspace(0, 1, 5), atol=1e-12)


def test_a_triangle_gives_barycentric_weights():
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    expected = np.array([0.2, 0.5, 0.3])
    found = WeightMap.fit(corners).weights(expected @ corners)
    np.testing.assert_allclose(found, expected, atol=1e-12)


def test_the_linear_part_is_that_of_least_squares():
    """Far from every example only it is left: compared with NumPy's own solver."""
    examples = np.array([[0.0, 0.0], [0.1, 0.0], [0.0, 0.1], [0.1, 0.1], [0.05, 0.0]])
    point = np.array([0.9, 0.05])
    basis = np.hstack([np.ones((5, 1)), examples])
    linear, *_ = np.linalg.lstsq(basis, np.eye(5), rcond=None)
    raw = np.clip(np.array([1.0, *point]) @ linear, 0.0, 1.0)
    found = WeightMap.fit(examples).weights(point)
    np.testing.assert_allclose(found, raw / raw.sum(), atol=1e-12)


@pytest.mark.parametrize(
    ("name", "word"),
    [
        ("one", "only one example"),
        ("twice the same", "equal parameters"),
        ("all parameters constant", "same parameters"),
        ("more parameters than examples", "4 parameters but only 3 examples"),
        ("a constant parameter", "One parameter is equal for all"),
        ("on a line", "go together"),
    ],
)
def test_what_is_particular_about_the_examples_is_said(name, word):
    notes = WeightMap.fit(HARD[name]).notes
    assert any(word in note for note in notes)
    assert all(note.endswith(".") for note in notes)


def test_an_ordinary_set_needs_no_word():
    assert WeightMap.fit(np.random.default_rng(27).uniform(size=(27, 4))).notes == ()


@pytest.mark.parametrize("examples", [np.zeros((0, 3)), np.zeros(4), np.full((3, 2), np.nan)])
def test_what_is_no_set_of_examples_is_refused(examples):
    with pytest.raises(MotionError, match="at least one example"):
        WeightMap.fit(examples)


def test_a_point_of_another_space_is_refused():
    with pytest.raises(MotionError, match="4 parameters"):
        WeightMap.fit(TEN).weights(np.zeros(3))
