import itertools

import numpy as np
import pytest
from scipy import stats

from app.statistics.poles import best_clip, chance_of_best

BODIES = ["female", "female", "female", "male", "male"]


@pytest.fixture
def answers():
    generator = np.random.default_rng(5)
    means = np.array([0.0, 1.2, -0.5, 0.6, 0.1])
    return np.clip(np.rint(generator.normal(means, 0.9, (12, 5))), -2, 2)


def test_the_best_clip_is_compared_with_the_other_clips_of_its_own_body_only(answers):
    found = best_clip(answers, BODIES)
    rest = answers[:, [0, 2]]
    expected = stats.ttest_ind(answers[:, 1], rest.ravel(), equal_var=False)
    assert found.clip == 1
    assert found.welch.t == pytest.approx(expected.statistic)
    assert found.welch.p == pytest.approx(expected.pvalue)
    assert found.rest_mean == pytest.approx(rest.mean())
    again = stats.ttest_rel(answers[:, 1], rest.mean(axis=1))
    assert found.paired.t == pytest.approx(again.statistic)


def test_the_thesis_comparison_keeps_the_best_clip_in_the_group(answers):
    found = best_clip(answers, BODIES, against="all")
    expected = stats.ttest_ind(answers[:, 1], answers[:, :3].ravel(), equal_var=False)
    assert found.welch.t == pytest.approx(expected.statistic)
    alone = best_clip(answers, BODIES)
    assert found.welch.difference == pytest.approx(alone.welch.difference * 2 / 3)


def test_the_other_pole_is_the_same_question_with_the_signs_turned(answers):
    found = best_clip(-answers, BODIES)
    assert found.clip == int(np.argmin(answers.mean(axis=0)))
    assert found.mean == pytest.approx(-answers.mean(axis=0).min())


def test_a_tie_goes_to_the_first_clip_of_the_study():
    assert best_clip(np.ones((6, 5)), BODIES).clip == 0


def test_without_answers_or_without_another_clip_there_is_nothing_to_compare():
    assert best_clip(np.empty((0, 5)), BODIES) is None
    assert best_clip(np.full((3, 5), np.nan), BODIES) is None
    assert best_clip(np.ones((4, 1)), ["female"]) is None


def test_a_clip_that_nobody_answered_is_passed_over(answers):
    answers[:, 1] = np.nan
    assert best_clip(answers, BODIES).clip == 3


def test_the_permutation_test_equals_trying_every_order():
    toward = np.array([[2.0, 0.0, 1.0], [1.0, -1.0, 1.0], [2.0, 1.0, 0.0]])
    bodies = ["female"] * 3
    orders = list(itertools.permutations(range(3)))

    def distance(answers):
        means = answers.mean(axis=0)
        return means.max() - np.delete(means, means.argmax()).mean()

    every = [
        distance(np.array([row[list(order)] for row, order in zip(toward, chosen, strict=True)]))
        for chosen in itertools.product(orders, repeat=3)
    ]
    exact = np.mean(np.array(every) >= distance(toward) - 1e-9)
    found = chance_of_best(toward, bodies, np.random.default_rng(1), draws=20_000)
    assert found == pytest.approx(exact, abs=0.012)


def test_where_all_clips_are_seen_alike_the_choice_is_allowed_for():
    generator = np.random.default_rng(3)
    bodies = ["female"] * 10
    plain, permuted = [], []
    for _ in range(150):
        toward = generator.integers(-2, 3, (14, 10)).astype(float)
        plain.append(best_clip(toward, bodies).welch.p)
        permuted.append(chance_of_best(toward, bodies, generator, draws=99))
    assert np.mean(np.array(plain) < 0.05) > 0.15  # three times what it promises
    assert np.mean(np.array(permuted) <= 0.05) < 0.1


def test_a_clip_that_everybody_sees_stands_out_as_far_as_the_draws_can_tell():
    generator = np.random.default_rng(4)
    toward = generator.integers(-1, 2, (20, 5)).astype(float)
    toward[:, 3] = 2.0
    assert chance_of_best(toward, BODIES, generator, draws=199) == pytest.approx(1 / 200)
    assert chance_of_best(toward, BODIES, generator, "all", draws=199) == pytest.approx(1 / 200)


def test_without_answers_or_without_another_clip_nothing_is_permuted():
    generator = np.random.default_rng(5)
    assert chance_of_best(np.full((3, 5), np.nan), BODIES, generator) is None
    assert chance_of_best(np.ones((4, 1)), ["female"], generator) is None
