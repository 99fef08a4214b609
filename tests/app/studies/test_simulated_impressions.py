import numpy as np
import pytest

from app.studies.adjectives import PRIMARY, SCALES, SET_A, SET_B
from app.studies.published_clusters import CLUSTERS, published
from app.studies.simulated_impressions import CLIPS, latent, simulated_ratings

SETS = ("set_a", "set_b")


@pytest.mark.parametrize(("motion_set", "pairs"), [("set_a", 27), ("set_b", 29)])
def test_the_published_tables_list_so_many_of_the_questionnaires_pairs(motion_set, pairs):
    listed = [pair for cluster in CLUSTERS[motion_set].values() for pair in cluster]
    assert len(listed) == len(set(listed)) == pairs
    assert set(listed) <= {scale["id"] for scale in SCALES}
    assert list(CLUSTERS[motion_set]) == list(PRIMARY)


@pytest.mark.parametrize("motion_set", SETS)
def test_every_listed_pair_has_its_cluster_and_no_other_pair_has_one(motion_set):
    names = [*PRIMARY, None]
    for scale, cluster in zip(SCALES, published(motion_set), strict=True):
        tables = [name for name, pairs in CLUSTERS[motion_set].items() if scale["id"] in pairs]
        assert tables == ([names[cluster]] if cluster >= 0 else [])


def test_every_clip_of_the_sets_has_values():
    assert CLIPS == {"set_a": SET_A, "set_b": SET_B}
    assert latent("set_a").shape == (10, 4)
    assert latent("set_b").shape == (27, 4)


@pytest.mark.parametrize("motion_set", SETS)
def test_each_quality_reaches_an_end_and_is_about_zero_on_average(motion_set):
    values = latent(motion_set)
    assert np.abs(values).max(axis=0) == pytest.approx(1.0)
    assert np.abs(values.mean(axis=0)).max() < 0.05


@pytest.mark.parametrize("motion_set", SETS)
def test_the_qualities_are_well_spread(motion_set):
    together = np.corrcoef(latent(motion_set).T)
    assert np.abs(together - np.eye(4)).max() <= 0.6
    assert np.diag(np.linalg.inv(together)).max() < 3  # variance inflation


def test_the_reference_walk_is_neutral():
    assert (latent("set_a")[SET_A.index("set_a_neutral")] == 0).all()


def test_a_faster_walk_of_the_same_emotion_is_quicker_and_larger():
    fast, normal, slow = np.moveaxis(latent("set_b").reshape(9, 3, 4), 1, 0)
    assert (fast[:, 0] > normal[:, 0]).all()
    assert (normal[:, 0] > slow[:, 0]).all()
    assert (fast[:, 3] > normal[:, 3]).all()
    assert (normal[:, 3] > slow[:, 3]).all()
    assert (fast[:, 1:3] == slow[:, 1:3]).all()


def test_simulated_ratings_have_a_value_for_every_participant_clip_and_pair():
    found = simulated_ratings("set_b", np.random.default_rng(1), participants=5)
    assert found.shape == (5, 27, 41)
    assert set(np.unique(found)) <= {-2, -1, 0, 1, 2}


def test_the_same_seed_gives_the_same_ratings():
    one, same, other = (simulated_ratings("set_a", np.random.default_rng(k)) for k in (1, 1, 2))
    assert (one == same).all()
    assert (one != other).any()
