import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.cluster import hierarchy
from scipy.spatial.distance import pdist

from app.statistics.ward import cluster_means, clusters_at, cut, merge_increase, ward
from tests.support.us_arrests import ARRESTS, STATES

SHAPES = [(2, 1), (5, 3), (27, 10), (29, 27), (41, 27)]


def directly(columns):
    """Ward's method as equations 4 to 6 say it, every candidate tried at every step."""
    groups = {item: (item,) for item in range(len(columns))}
    merges = []
    for made in range(len(columns), 2 * len(columns) - 1):
        increase, one, other = min(
            (merge_increase(columns[list(groups[a])], columns[list(groups[b])]), a, b)
            for a, b in itertools.combinations(sorted(groups), 2)
        )
        groups[made] = groups.pop(one) + groups.pop(other)
        merges.append((one, other, np.sqrt(2 * increase), len(groups[made])))
    return np.array(merges)


@pytest.mark.parametrize("shape", SHAPES)
def test_the_tree_is_that_of_the_equations_computed_directly(shape):
    columns = np.random.default_rng(shape[0]).random(shape)
    np.testing.assert_allclose(ward(columns).merges, directly(columns), atol=1e-9, rtol=0)


@pytest.mark.parametrize("shape", SHAPES)
def test_the_tree_is_scipys(shape):
    columns = np.random.default_rng(7).random(shape)
    np.testing.assert_allclose(
        ward(columns).merges, hierarchy.ward(pdist(columns)), atol=1e-9, rtol=0
    )


@given(st.integers(1, 6), st.integers(1, 6), st.integers(0, 2**32))
def test_an_increase_is_the_squared_distance_of_the_centres_weighted_by_sizes(n, m, seed):
    generator = np.random.default_rng(seed)
    one, other = generator.normal(size=(n, 4)), generator.normal(size=(m, 4))
    apart = np.sum((one.mean(axis=0) - other.mean(axis=0)) ** 2)
    assert merge_increase(one, other) == pytest.approx(n * m / (n + m) * apart, abs=1e-10)


def test_rs_published_ward_d2_solution_of_the_arrests_is_reproduced():
    # A. Kassambara, Practical Guide to Cluster Analysis in R (STHDA 2017), chapter 7:
    # hclust(dist(scale(USArrests)), "ward.D2"), cor(dist, cophenetic), table(cutree(k = 4)) and
    # the names of the first cluster. The correlation depends on every height.
    scaled = (ARRESTS - ARRESTS.mean(axis=0)) / ARRESTS.std(axis=0, ddof=1)
    tree = ward(scaled)
    correlation = np.corrcoef(pdist(scaled), hierarchy.cophenet(tree.merges))[0, 1]
    assert correlation == pytest.approx(0.6975266, abs=5e-8)
    labels = cut(tree, 4)
    groups = dict.fromkeys(labels)  # as cutree numbers them: in the order of the first members
    assert [int(np.sum(labels == group)) for group in groups] == [7, 12, 19, 12]
    assert [state for state, label in zip(STATES, labels, strict=True) if label == labels[0]] == [
        "Alabama", "Georgia", "Louisiana", "Mississippi", "North Carolina", "South Carolina",
        "Tennessee",
    ]  # fmt: skip
    assert len(set(labels[:3])) == 2  # "1 2 2 3" for Alabama, Alaska, Arizona, Arkansas
    assert labels[1] == labels[2] != labels[3] != labels[0]


def test_rs_published_agglomerative_coefficient_of_the_arrests_is_reproduced():
    # UC Business Analytics R Programming Guide, Hierarchical Cluster Analysis:
    # agnes(scale(USArrests), method = "ward")$ac; the coefficient is defined in ?agnes.object.
    tree = ward((ARRESTS - ARRESTS.mean(axis=0)) / ARRESTS.std(axis=0, ddof=1))
    first = {
        int(item): height
        for one, other, height, _ in reversed(tree.merges)
        for item in (one, other)
    }
    heights = np.array([first[state] for state in range(len(STATES))])
    assert np.mean(1 - heights / tree.heights[-1]) == pytest.approx(0.9346210, abs=5e-8)


@given(st.integers(1, 12), st.data())
def test_a_cut_gives_exactly_so_many_clusters_in_the_order_of_the_leaves(items, data):
    values = data.draw(st.lists(st.integers(0, 3), min_size=items, max_size=items))
    clusters = data.draw(st.integers(1, items))
    tree = ward(np.array(values, dtype=float)[:, None])  # many equal items and equal heights
    labels = cut(tree, clusters)
    along = labels[tree.order]
    assert sorted(set(labels)) == list(range(clusters))
    assert sorted(along) == list(along)


def test_a_cut_is_scipys_where_all_heights_differ():
    columns = np.random.default_rng(3).random((20, 4))
    tree = ward(columns)
    for clusters in range(1, 21):
        theirs = hierarchy.fcluster(tree.merges, clusters, "maxclust")
        ours = cut(tree, clusters)
        assert len(set(zip(ours, theirs, strict=True))) == clusters == len(set(theirs))


def test_a_height_says_how_many_clusters_its_cut_makes():
    tree = ward(np.array([[0.0], [1.0], [10.0], [12.0]]))
    heights = tree.heights
    assert [clusters_at(tree, h) for h in (0, heights[0], 1.9, 2, 99)] == [4, 3, 3, 2, 1]


def test_a_clusters_mean_is_the_mean_of_its_pairs():
    matrix = np.array([[0.1, 0.5, 0.3], [0.9, 0.2, 0.7]])
    found = cluster_means(matrix, np.array([1, 0, 1]))
    np.testing.assert_allclose(found, [[0.5, 0.2], [0.2, 0.8]])


def test_one_item_is_one_cluster():
    tree = ward(np.array([[0.5, 0.5]]))
    assert tree.merges.shape == (0, 4)
    assert cut(tree, 1).tolist() == [0]


@pytest.mark.parametrize("columns", [np.empty((0, 3)), np.array([[0.0], [np.nan]])])
def test_missing_numbers_and_no_items_are_refused(columns):
    with pytest.raises(ValueError, match="known"):
        ward(columns)


@pytest.mark.parametrize("clusters", [0, 3])
def test_a_cut_that_cannot_be_is_refused(clusters):
    with pytest.raises(ValueError, match="2 items"):
        cut(ward(np.array([[0.0], [1.0]])), clusters)
