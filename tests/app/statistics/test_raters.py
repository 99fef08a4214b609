import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from app.statistics.raters import felt, matched, ranked, rated


@given(st.floats(-5, 5), st.floats(0, 3), st.integers(0, 2**32))
def test_an_answer_is_one_of_the_steps(latent, noise, seed):
    generator = np.random.default_rng(seed)
    found = rated(np.full(50, latent), noise, generator, lowest=-2, highest=2)
    assert set(found) <= {-2, -1, 0, 1, 2}


def test_without_noise_it_is_the_nearest_step():
    found = rated(np.array([-9, -0.6, 0.2, 1.4]), 0, np.random.default_rng(1), lowest=-2, highest=2)
    assert found.tolist() == [-2, -1, 0, 1]


def test_each_step_comes_as_often_as_the_normal_distribution_says():
    found = rated(np.full(40_000, 0.3), 0.8, np.random.default_rng(2), lowest=-2, highest=2)
    edges = [-np.inf, -1.5, -0.5, 0.5, 1.5, np.inf]
    expected = np.diff(stats.norm.cdf(edges, 0.3, 0.8)) * found.size
    observed = [np.sum(found == step) for step in range(-2, 3)]
    assert stats.chisquare(observed, expected).pvalue > 0.001


def test_of_two_the_better_one_is_chosen_as_thurstone_says():
    seeming = felt(np.tile([0.5, 0.0], (40_000, 1)), 0.8, np.random.default_rng(3))
    share = np.mean(seeming[:, 0] > seeming[:, 1])
    assert share == pytest.approx(stats.norm.cdf(0.5 / (0.8 * math.sqrt(2))), abs=0.01)


@given(st.lists(st.integers(-9, 9), min_size=1, max_size=9, unique=True))
def test_ranks_begin_with_the_best(values):
    expected = stats.rankdata([-value for value in values])
    assert ranked(np.array(values, dtype=float)).tolist() == expected.tolist()


def test_what_looks_alike_can_only_be_guessed_and_what_differs_is_known():
    third = np.random.default_rng(4).integers(2, size=10_000)
    same = matched(np.zeros((10_000, 2)), third, 0.0, np.random.default_rng(5))
    assert np.mean(same == third) == pytest.approx(0.5, abs=0.02)
    apart = np.tile([0.0, 9.0], (10_000, 1))
    assert (matched(apart, third, 0.5, np.random.default_rng(6)) == third).all()
