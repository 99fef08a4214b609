import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.statistics.agreement import adjusted_rand, matching

LABELS = st.integers(2, 14).flatmap(
    lambda n: st.tuples(*[st.lists(st.integers(0, 3), min_size=n, max_size=n)] * 2)
)


def by_couples(one, other):
    """The adjusted index from its definition over all couples of items."""
    couples = list(itertools.combinations(range(len(one)), 2))
    first = np.array([one[a] == one[b] for a, b in couples])
    second = np.array([other[a] == other[b] for a, b in couples])
    chance = first.sum() * second.sum() / len(couples)
    greatest = (first.sum() + second.sum()) / 2
    return (np.sum(first & second) - chance) / (greatest - chance) if greatest != chance else 1.0


@given(LABELS)
def test_the_index_is_that_of_all_couples(labels):
    one, other = map(np.array, labels)
    assert adjusted_rand(one, other) == pytest.approx(by_couples(one, other), abs=1e-12)


def test_the_index_is_the_one_in_hubert_and_arabies_form_of_a_known_table():
    # Yeung & Ruzzo 2001, details of the adjusted Rand index: objects in the table
    # [[1, 1, 0], [1, 2, 1], [0, 0, 4]] have the index 0.313.
    one = np.array([0, 0, 1, 1, 1, 1, 2, 2, 2, 2])
    other = np.array([0, 1, 0, 1, 1, 2, 2, 2, 2, 2])
    assert adjusted_rand(one, other) == pytest.approx(0.313, abs=5e-4)


@given(LABELS)
def test_names_of_clusters_and_the_order_of_solutions_do_not_matter(labels):
    one, other = map(np.array, labels)
    renamed = np.array([2, 0, 3, 1])[one]
    assert adjusted_rand(renamed, other) == pytest.approx(adjusted_rand(one, other))
    assert adjusted_rand(other, one) == pytest.approx(adjusted_rand(one, other))
    assert adjusted_rand(one, renamed) == 1


def test_by_chance_the_index_is_zero_on_average():
    generator = np.random.default_rng(5)
    one = np.repeat(np.arange(4), 7)
    found = [adjusted_rand(one, generator.permutation(one)) for _ in range(2000)]
    assert abs(np.mean(found)) < 4 * np.std(found) / np.sqrt(2000)


def test_clusters_are_matched_by_what_they_share_and_the_rest_has_moved():
    one = np.array([0, 0, 0, 1, 1, 1, 2, 2])
    other = np.array([2, 2, 0, 0, 0, 0, 1, 1])
    found = matching(one, other)
    assert found.pairs == ((0, 2), (1, 0), (2, 1))
    assert np.flatnonzero(found.moved).tolist() == [2]


@given(LABELS)
def test_no_other_matching_keeps_more_items_together(labels):
    one, other = map(np.array, labels)
    best = max(
        sum(np.sum((one == row) & (other == column)) for row, column in enumerate(order))
        for order in itertools.permutations(range(4))
    )
    assert np.sum(~matching(one, other).moved) == best


def test_without_items_there_is_nothing_to_disagree_about():
    nothing = np.empty(0, dtype=np.intp)
    assert adjusted_rand(nothing, nothing) == 1
    assert matching(nothing, nothing).pairs == ()
